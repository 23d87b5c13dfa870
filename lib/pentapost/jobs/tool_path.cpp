#include "pentapost/jobs/tool_path.hpp"

#include "pentapost/cl/dialects.hpp"
#include "pentapost/cl/reader.hpp"
#include "pentapost/cl/words.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace pentapost::jobs {
namespace {

/// Most decimals that are looked for; a double of full length has more.
constexpr int most_decimals = 15;

/// The number of decimals with which `value` was written, as far as its double tells.
int decimals_of(double value, int at_least) {
  int decimals = at_least;
  for (double scale = std::pow(10.0, at_least); decimals < most_decimals; ++decimals, scale *= 10.0)
    if (std::round(value * scale) / scale == value) break;
  return decimals;
}

Problem unknown_cl_dialect(std::string_view name) {
  std::string known;
  for (const cl::ClDialect& dialect : cl::cl_dialects())
    known.append(known.empty() ? "" : ", ").append(dialect.name);
  return {.code = Code::unknown_dialect,
          .message = "found " + cl::quoted_excerpt(name) + ", expected one of " + known,
          .pointer = "/cl_dialect"};
}

/// The error to be put forward: a damaged motion before all others, else the first.
Diagnostic worst_of(const Diagnostics& diagnostics) {
  const auto& list = diagnostics.list();
  const auto error = [](const Diagnostic& each) { return each.severity == Severity::error; };
  const auto motion = std::find_if(list.begin(), list.end(), [&](const Diagnostic& each) {
    return error(each) && each.code == Code::damaged_motion;
  });
  return motion != list.end() ? *motion : *std::find_if(list.begin(), list.end(), error);
}

Result<ReadPath> read_cl(const ClText& cl) {
  if (cl.dialect && cl::find_cl_dialect(*cl.dialect) == nullptr)
    return unknown_cl_dialect(*cl.dialect);
  cl::ReadOptions options;
  if (cl.units) options.units = *cl.units == ClUnits::mm ? cl::Units::mm : cl::Units::inch;
  if (cl.dialect) options.dialect = *cl.dialect;
  cl::ReadResult read = cl::read(cl.text, options);
  if (read.diagnostics.has_errors()) {
    const Diagnostic worst = worst_of(read.diagnostics);
    Problem problem{.code = worst.code, .message = worst.message};
    if (worst.cl_line > 0) problem.cl_line = worst.cl_line;
    problem.diagnostics = std::move(read.diagnostics);
    return problem;
  }
  ReadPath result;
  result.tool_path = std::move(read.path);
  result.cl_dialect = std::move(read.dialect);
  result.cl_units = read.units == cl::Units::mm ? "mm" : "inch";
  result.lines = read.lines;
  result.points = read.points;
  result.diagnostics = std::move(read.diagnostics);
  return result;
}

/// The point in hand counts as a line of the CL data.
Result<ReadPath> read_points(const PointPath& points) {
  if (points.tip_mm.empty())
    return Problem{
        .code = Code::no_motion, .message = "the path has no points", .pointer = "/path/points"};
  ReadPath result;
  result.points = points.tip_mm.size();
  path::ToolPath& tool_path = result.tool_path;
  tool_path.reserve(points.tip_mm.size());
  tool_path.add_event(1, path::FeedRate{.value = points.feed_mm_min});
  int decimals = 0;
  for (std::size_t i = 0; i < points.tip_mm.size(); ++i) {
    const double length = points.axis[i].stableNorm();
    const auto line = static_cast<std::uint32_t>(i + 1);
    if (!(length > 0.0))
      return Problem{.code = Code::zero_tool_axis,
                     .message = "the tool axis of point " + std::to_string(i) + " has no direction",
                     .pointer = "/path/points/" + std::to_string(i)};
    for (const double component : points.axis[i])
      if (decimals < most_decimals) decimals = decimals_of(component, decimals);
    tool_path.add_point(points.tip_mm[i], points.axis[i] / length, line, path::Move::feed);
  }
  // Few decimals are exact values (0, 0.6, 0.8) rather than rounded ones.
  constexpr int most_exact_decimals = 4;
  if (decimals > most_exact_decimals) tool_path.axis_rounding_rad = 2.0 * std::pow(10.0, -decimals);
  return result;
}

}  // namespace

Result<ReadPath> read_path(const PostJob& job) {
  if (const auto* cl = std::get_if<ClText>(&job.path)) return read_cl(*cl);
  return read_points(std::get<PointPath>(job.path));
}

}  // namespace pentapost::jobs
