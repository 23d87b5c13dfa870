#include "pentapost/cl/arcs.hpp"

#include <algorithm>
#include <iterator>

namespace pentapost::cl {
namespace {

/// The arcs of a path in order, looked up by the point that they lead to.
class ArcsOfPath {
 public:
  explicit ArcsOfPath(const path::ToolPath& path) : path_{path} {
    for (std::size_t i = 0; i < path.events.size(); ++i)
      if (std::holds_alternative<path::Arc>(path.events[i].what)) events_.push_back(i);
  }
  /// Index of the event of the arc to `point`; nullopt: not an arc.
  std::optional<std::size_t> event_to(std::size_t point) const {
    const auto at = std::lower_bound(
        events_.begin(), events_.end(), point,
        [&](std::size_t event, std::size_t p) { return path_.events[event].before_point < p; });
    if (at == events_.end() || path_.events[*at].before_point != point) return std::nullopt;
    return *at;
  }

 private:
  const path::ToolPath& path_;
  std::vector<std::size_t> events_;
};

/// Direction of the move to `point` at its start or end; zero where it is not known.
Vec3 direction(const path::ToolPath& path, const ArcsOfPath& arcs, std::size_t point, bool at_end,
               std::size_t settled_before) {
  if (point == 0 || point >= path.size() || path.move[point] != path::Move::feed)
    return Vec3::Zero();
  if (const auto event = arcs.event_to(point)) {
    if (*event >= settled_before) return Vec3::Zero();
    const auto& arc = std::get<path::Arc>(path.events[*event].what);
    return arc_tangent(arc, path.tip_wp_mm[at_end ? point : point - 1]);
  }
  const Vec3 along = path.tip_wp_mm[point] - path.tip_wp_mm[point - 1];
  const double length_mm = along.norm();
  return length_mm > 0.0 ? Vec3{along / length_mm} : Vec3{Vec3::Zero()};
}

}  // namespace

void settle_open_arcs(path::ToolPath& path, const std::vector<std::size_t>& open_events,
                      Diagnostics& diagnostics) {
  if (open_events.empty()) return;
  const ArcsOfPath arcs{path};
  for (const std::size_t event : open_events) {
    auto& arc = std::get<path::Arc>(path.events[event].what);
    const std::size_t point = path.events[event].before_point;
    const Vec3 before = direction(path, arcs, point - 1, true, event);
    const Vec3 behind = direction(path, arcs, point + 1, false, 0);
    const double agreement = before.dot(arc_tangent(arc, path.tip_wp_mm[point - 1])) +
                             behind.dot(arc_tangent(arc, path.tip_wp_mm[point]));
    constexpr double clear_agreement = 0.1;
    const bool is_clear = std::abs(agreement) > clear_agreement;
    if (is_clear ? agreement < 0.0 : arc.sweep_rad > pi) arc = reversed(arc);
    if (!diagnostics.keeps(Severity::warning)) {
      diagnostics.count(Severity::warning);
      continue;
    }
    diagnostics.add(
        {Severity::warning, Code::arc_sense_assumed, path.events[event].cl_line,
         is_clear ? "The CL dialect has no rule for the sense of this arc: the one that is tangent "
                    "to the moves next to it was taken."
                  : "The CL dialect has no rule for the sense of this arc and the moves next to it "
                    "do not tell: the shorter way was taken."});
  }
}

}  // namespace pentapost::cl
