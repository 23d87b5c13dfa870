#include "server/json/point_path_json.hpp"

#include <cstddef>

namespace pentapost::server {

jobs::PointPath read_point_path(const json::Object& path) {
  constexpr std::size_t row_length = 6;
  jobs::PointPath points;
  points.feed_mm_min = path.number("feed_mm_min", json::Domain::positive());
  const auto rows = path.array("points");
  path.finish();
  if (rows.size() == 0) rows.fail(Code::no_motion, "there is no point");
  points.tip_mm.reserve(rows.size());
  points.axis.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = rows.at(i);
    const auto numbers = row.array().numbers(row_length);
    if (numbers.size() != row_length) break;
    points.tip_mm.emplace_back(numbers[0], numbers[1], numbers[2]);
    points.axis.emplace_back(numbers[3], numbers[4], numbers[5]);
    if (points.axis.back().isZero(0.0)) {
      row.fail(Code::zero_tool_axis, "the tool axis is 0, 0, 0");
      break;
    }
  }
  return points;
}

}  // namespace pentapost::server
