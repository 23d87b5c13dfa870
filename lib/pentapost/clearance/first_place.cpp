#include "pentapost/clearance/first_place.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::clearance {
namespace {

/// Halvings of a move; a move of the largest length needs fewer.
constexpr int most_halvings = 48;

class Search {
 public:
  Search(const Places& places, const Pair& pair, std::uint32_t before)
      : places_{places},
        pair_{pair},
        before_{before},
        lever_mm_{
            std::hypot(std::max(std::abs(pair.cylinder.from_mm), std::abs(pair.cylinder.to_mm)),
                       pair.cylinder.radius_mm)} {}

  std::optional<FoundPlace> in_node(std::uint32_t index) const {
    const Places::Node& node = places_.node(index);
    if (node.begin >= before_ || is_clear_of(node.around)) return std::nullopt;
    if (node.second != Places::no_child) {
      const auto found = in_node(index + 1);
      return found ? found : in_node(node.second);
    }
    for (std::uint32_t point = node.begin; point < std::min(node.end, before_); ++point)
      if (const auto distance_mm = at_point(point))
        return FoundPlace{.point = point, .distance_mm = *distance_mm};
    return std::nullopt;
  }

 private:
  Cylinder at(const Pose& pose) const {
    const auto& [radius_mm, from_mm, to_mm] = pair_.cylinder;
    return {.centre_mm = pose.tip_mm + 0.5 * (from_mm + to_mm) * pose.axis,
            .axis = pose.axis,
            .half_length_mm = 0.5 * (to_mm - from_mm),
            .radius_mm = radius_mm};
  }

  /// Nothing of the cylinder is further than the reach from where it is in the middle: it is turned
  /// there about the tip by the angle between the axes, and moved.
  bool is_clear_of(const Neighbourhood& around) const {
    const double reach_mm = around.tip_radius_mm + around.axis_chord * lever_mm_;
    return bound_exceeds(at(around.middle), pair_.obstacle, pair_.safety_mm + reach_mm);
  }

  std::optional<double> distance_at(const Pose& pose) const {
    const Cylinder tool = at(pose);
    if (!is_within(tool, pair_.obstacle, pair_.safety_mm)) return std::nullopt;
    return distance_within_mm(tool, pair_.obstacle, pair_.safety_mm);
  }

  /// Distance at the first place within the safety distance, on the move to the point or there.
  std::optional<double> at_point(std::uint32_t point) const {
    if (is_clear_of(places_.around(point))) return std::nullopt;
    if (const auto way = places_.way_to(point)) {
      const double reach_mm = 0.5 * (way->tip_mm + way->axis_rad * lever_mm_);
      if (const auto found = on_way(*way, 0.5, 0.5, reach_mm, 0)) return found;
    }
    return distance_at(places_.pose(point));
  }

  /// @param half  half the stretch of the way, as a fraction of it, about `middle`.
  /// @param reach_mm  how far any place of the cylinder gets within it from the middle.
  std::optional<double> on_way(const Way& way, double middle, double half, double reach_mm,
                               int halvings) const {
    const Pose pose{.tip_mm = way.segment.tip_mm(middle), .axis = way.segment.axis(middle)};
    const Cylinder tool = at(pose);
    if (bound_exceeds(tool, pair_.obstacle, pair_.safety_mm + reach_mm)) return std::nullopt;
    // Where the bound shows the place itself to be clear it is near the distance: not asked for.
    if (!bound_exceeds(tool, pair_.obstacle, pair_.safety_mm) &&
        !may_be_within(tool, pair_.obstacle, pair_.safety_mm + reach_mm))
      return std::nullopt;
    if (!(reach_mm > pair_.step_mm) || halvings == most_halvings) return distance_at(pose);
    const double quarter = 0.5 * half;
    const auto found = on_way(way, middle - quarter, quarter, 0.5 * reach_mm, halvings + 1);
    return found ? found : on_way(way, middle + quarter, quarter, 0.5 * reach_mm, halvings + 1);
  }

  const Places& places_;
  const Pair& pair_;
  std::uint32_t before_;
  double lever_mm_;  ///< largest distance of the cylinder from the tip
};

}  // namespace

std::optional<FoundPlace> first_place(const Places& places, std::size_t stretch, const Pair& pair,
                                      std::uint32_t before) {
  return Search{places, pair, before}.in_node(places.root(stretch));
}

}  // namespace pentapost::clearance
