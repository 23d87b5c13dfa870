#include "pentapost/clearance/places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <variant>

namespace pentapost::clearance {
namespace {

/// A cone of directions that is narrower than a hemisphere holds the great circles between them.
constexpr double hemisphere_chord = std::numbers::sqrt2;
constexpr double whole_sphere_chord = 2.0;

/// The direction in the middle of two; opposite ones have none.
Vec3 middle_axis(const Vec3& one, const Vec3& other) {
  const Vec3 sum = one + other;
  const double length = sum.norm();
  return length > 0.0 ? Vec3{sum / length} : one;
}

double safe_chord(double chord) { return chord < hemisphere_chord ? chord : whole_sphere_chord; }

Neighbourhood joined(const Neighbourhood& one, const Neighbourhood& other) {
  Neighbourhood both;
  const Vec3 way = other.middle.tip_mm - one.middle.tip_mm;
  const double length = way.norm();
  if (length + other.tip_radius_mm <= one.tip_radius_mm) {
    both = one;
  } else if (length + one.tip_radius_mm <= other.tip_radius_mm) {
    both = other;
  } else {
    both.tip_radius_mm = 0.5 * (length + one.tip_radius_mm + other.tip_radius_mm);
    both.middle.tip_mm =
        one.middle.tip_mm + (both.tip_radius_mm - one.tip_radius_mm) / length * way;
  }
  both.middle.axis = middle_axis(one.middle.axis, other.middle.axis);
  both.axis_chord =
      safe_chord(std::max((one.middle.axis - both.middle.axis).norm() + one.axis_chord,
                          (other.middle.axis - both.middle.axis).norm() + other.axis_chord));
  return both;
}

/// Upper bound of how fast the tip goes, by the fraction.
double tip_rate_mm(const path::Segment& segment) {
  if (!segment.is_arc()) return segment.length_mm();
  const double rise_mm = (segment.tip_to_mm() - segment.tip_from_mm()).dot(segment.normal());
  return std::hypot(segment.sweep_rad() * segment.largest_radius_mm(), rise_mm,
                    segment.radius_change_mm());
}

}  // namespace

Places::Places(const path::ToolPath& path, std::vector<Stretch> stretches)
    : stretches_{std::move(stretches)} {
  points_.reserve(path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    points_.push_back({.pose = {.tip_mm = path.tip_wp_mm[i], .axis = path.axis_wp[i]},
                       .cl_line = path.cl_line[i],
                       .from_previous = i > 0 && path.move[i] == path::Move::feed});
  for (const path::Event& event : path.events)
    if (const auto* const arc = std::get_if<path::Arc>(&event.what))
      arcs_.push_back({.point = event.before_point, .arc = *arc});
  nodes_.reserve(path.size() / (points_per_leaf / 4) + stretches_.size());
  std::uint32_t covered = 0;
  for (const Stretch& stretch : stretches_) {
    if (stretch.begin < covered || stretch.end <= stretch.begin || stretch.end > points_.size())
      throw std::logic_error{"stretches of the path must be in order and have points"};
    covered = stretch.end;
    points_[stretch.begin].from_previous = false;
    roots_.push_back(add_node(stretch.begin, stretch.end));
    for (std::uint32_t i = stretch.begin; i < stretch.end; ++i) {
      const auto way = way_to(i);
      if (!way) continue;
      tip_travel_mm_ += way->tip_mm;
      axis_travel_rad_ += way->axis_rad;
    }
  }
}

std::uint32_t Places::add_node(std::uint32_t begin, std::uint32_t end) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({.around = around(begin), .begin = begin, .end = end});
  if (end - begin <= points_per_leaf) {
    for (std::uint32_t i = begin + 1; i < end; ++i)
      nodes_[index].around = joined(nodes_[index].around, around(i));
    return index;
  }
  const std::uint32_t middle = begin + (end - begin) / 2;
  const std::uint32_t first = add_node(begin, middle);
  const std::uint32_t second = add_node(middle, end);
  nodes_[index].second = second;
  nodes_[index].around = joined(nodes_[first].around, nodes_[second].around);
  return index;
}

const path::Arc* Places::arc_to(std::uint32_t point) const {
  const auto after =
      std::upper_bound(arcs_.begin(), arcs_.end(), point,
                       [](std::uint32_t sought, const ArcTo& each) { return sought < each.point; });
  return after != arcs_.begin() && std::prev(after)->point == point ? &std::prev(after)->arc
                                                                    : nullptr;
}

std::optional<Way> Places::way_to(std::uint32_t point) const {
  if (!points_[point].from_previous) return std::nullopt;
  const Pose& from = points_[point - 1].pose;
  const Pose& to = points_[point].pose;
  Way way{.segment = {from.tip_mm, from.axis, to.tip_mm, to.axis, arc_to(point)}};
  way.tip_mm = tip_rate_mm(way.segment);
  way.axis_rad = way.segment.axis_angle_rad();
  return way;
}

Neighbourhood Places::around(std::uint32_t point) const {
  const Pose& to = points_[point].pose;
  if (!points_[point].from_previous) return {.middle = to};
  const Pose& from = points_[point - 1].pose;
  Neighbourhood around;
  around.middle.axis = middle_axis(from.axis, to.axis);
  around.axis_chord = safe_chord(
      std::max((from.axis - around.middle.axis).norm(), (to.axis - around.middle.axis).norm()));
  around.middle.tip_mm = 0.5 * (from.tip_mm + to.tip_mm);
  around.tip_radius_mm = 0.5 * (to.tip_mm - from.tip_mm).norm();
  if (!arcs_.empty() && arc_to(point) != nullptr) {
    const Way way = *way_to(point);
    around.middle.tip_mm = way.segment.tip_mm(0.5);
    around.tip_radius_mm = 0.5 * way.tip_mm;
  }
  return around;
}

}  // namespace pentapost::clearance
