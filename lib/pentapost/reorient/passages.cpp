#include "pentapost/reorient/path_loads.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pentapost::reorient {

/// Rate of the first rotary axis on the way past the pole, for all poles within `about_rad`.
double PathLoads::passage_rate(const Tool& tool, std::uint32_t nearest, const Vec3& pole,
                               double about_rad) const {
  constexpr std::array widths{1.5, 2.5, 4.0, 8.0, 20.0};
  constexpr std::uint32_t most_stations = 5000;
  const std::vector<Station>& stations = tool.stations;
  double rate = 0.0;
  std::uint32_t from = nearest, to = nearest, passed = 0;
  for (const double width : widths) {
    const double radius_rad = width * about_rad;
    if (radius_rad > 0.5 * pi) break;
    const auto is_inside = [&](std::uint32_t station) {
      return angle_between_rad(pole, stations[station].axis) < radius_rad;
    };
    const auto goes_on = [&](std::uint32_t station, std::uint32_t next) {
      return next < stations.size() && stations[next].run == stations[station].run;
    };
    while (is_inside(from) && from > 0 && goes_on(from, from - 1) && ++passed < most_stations)
      --from;
    while (is_inside(to) && goes_on(to, to + 1) && ++passed < most_stations) ++to;
    const Vec3 &before = stations[from].axis, &after = stations[to].axis;
    const double seen_rad = angle_between_rad(pole.cross(before), pole.cross(after));
    const auto may_turn_rad = [&](const Vec3& axis) {
      const double sine = std::sin(about_rad) / pole.cross(axis).norm();
      return sine < 1.0 ? std::asin(sine) : pi;
    };
    // Without right angles the axis also turns by the angle between pole and tool axis.
    const double farthest_rad =
        about_rad + std::max(angle_between_rad(pole, before), angle_between_rad(pole, after));
    const double corner = std::tan(0.5 * farthest_rad) / std::tan(model_.lambda_rad);
    // Where a retract can lead to the other branch, it turns the other way there. Whole turns by a
    // retract are none at feed.
    const double branches = limits_.ranges.rotary_rad[0] ? 2.0 : 1.0;
    const double corner_rad = corner < 1.0 ? branches * std::asin(corner) : pi;
    const double least_rad = seen_rad - may_turn_rad(before) - may_turn_rad(after) - corner_rad;
    const double time_s = stations[to].time_s - stations[from].time_s;
    if (least_rad > 0.0 && time_s > 0.0) rate = std::max(rate, least_rad / time_s);
  }
  return rate;
}

double PathLoads::least_passage_ratio(const Clampings& clampings, const Extremes& found,
                                      const Spread& spread) const {
  // The way must not lead through the pole itself.
  if (!has_pole_ || clampings.accuracy_rad <= limits_.slack_rad || tools_.empty()) return 0.0;
  const double about_rad = spread.pole_rad + clampings.accuracy_rad;
  if (found.least_rad > found.most_rad) return 0.0;
  const Vec3& pole = clampings.nominal.pole;
  const auto station = [&](std::uint32_t tool, std::uint32_t piece) {
    return tools_[tool].tree.pieces()[piece].station;
  };
  double rate = passage_rate(tools_[found.least_tool], station(found.least_tool, found.least_piece),
                             pole, about_rad);
  if (has_two_poles_)
    rate = std::max(
        rate, passage_rate(tools_[found.most_tool], station(found.most_tool, found.most_piece),
                           Vec3{-pole}, about_rad));
  return sure_share * rate * limits_.shares.time_per_way_s[first_axis];
}

}  // namespace pentapost::reorient
