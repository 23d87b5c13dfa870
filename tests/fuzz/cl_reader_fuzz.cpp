// Any bytes: cl::read and cl::expand_cycles must neither crash nor hang, and what they give must be
// finite and in order.

#include "pentapost/cl/cycles.hpp"
#include "pentapost/cl/dialects.hpp"
#include "pentapost/cl/reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

using namespace pentapost;

void check(bool holds) {
  if (!holds) std::abort();
}

void check_path(const path::ToolPath& path) {
  check(path.axis_wp.size() == path.size() && path.move.size() == path.size() &&
        path.cl_line.size() == path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    check(path.tip_wp_mm[i].allFinite());
    check(std::abs(path.axis_wp[i].norm() - 1.0) < 1e-12);
  }
  std::uint32_t before_point = 0;
  for (const path::Event& event : path.events) {
    check(event.before_point >= before_point && event.before_point <= path.size());
    before_point = event.before_point;
    if (const auto* arc = std::get_if<path::Arc>(&event.what))
      check(arc->centre_wp_mm.allFinite() && std::abs(arc->normal_wp.norm() - 1.0) < 1e-12 &&
            arc->sweep_rad > 0.0 && std::isfinite(arc->sweep_rad));
    if (const auto* feed = std::get_if<path::FeedRate>(&event.what))
      check(feed->value > 0.0 && std::isfinite(feed->value));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  // The last byte chooses the options, so that a CL file is a whole text: any dialect or none, any
  // unit or none.
  const std::string_view text{reinterpret_cast<const char*>(bytes), size - 1};
  const std::uint8_t last = bytes[size - 1];
  const auto dialects = cl::cl_dialects();
  const std::size_t choice = last % (3 * (dialects.size() + 1));
  cl::ReadOptions options;
  if (choice / 3 < dialects.size()) options.dialect = dialects[choice / 3].name;
  if (choice % 3 == 1) options.units = cl::Units::mm;
  if (choice % 3 == 2) options.units = cl::Units::inch;
  const cl::ReadResult result = cl::read(text, options);
  check(result.path.size() > 0 || result.diagnostics.has_errors());
  check_path(result.path);
  // Few pecks: this target is about what goes wrong, not about how long it takes.
  double pecks = 0.0;
  double deepest = 0.0;
  for (const path::Event& event : result.path.events)
    if (const auto* cycle = std::get_if<path::CycleStart>(&event.what))
      deepest = std::max(deepest, cycle->peck_mm ? cycle->depth_mm / *cycle->peck_mm : 1.0);
  for (const path::Move move : result.path.move) pecks += move == path::Move::hole ? deepest : 0.0;
  if (pecks < 1e5) {
    const auto native = [&](std::uint32_t point) { return (point + last) % 3 == 0; };
    check_path(cl::expand_cycles(result.path, native));
  }
  return 0;
}
