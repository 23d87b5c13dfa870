#include "pentapost/clearance/check.hpp"

#include "pentapost/clearance/first_place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pentapost::clearance {
namespace {

constexpr double usual_step_mm = 0.25;
/// Places between the CL points, of all pairs together, that a check may come to.
constexpr double most_places = 1e8;

Cylinder table_of(const machine::TableDisc& disc) {
  const Vec3& normal = disc.normal.vec();
  return {.centre_mm = disc.centre_mm - 0.5 * disc.thickness_mm * normal,
          .axis = normal,
          .half_length_mm = 0.5 * disc.thickness_mm,
          .radius_mm = disc.radius_mm};
}

Box box_of(const JigBox& box) {
  return {.centre_mm = 0.5 * (box.min_mm + box.max_mm),
          .half_size_mm = 0.5 * (box.max_mm - box.min_mm)};
}

struct IntoClCoordinates {
  const Mat3& turn;
  const Vec3& origin_mm;

  Obstacle operator()(const Cylinder& body) const {
    Cylinder placed = body;
    placed.centre_mm = turn.transpose() * (body.centre_mm - origin_mm);
    placed.axis = turn.transpose() * body.axis;
    return placed;
  }
  Obstacle operator()(const Box& body) const {
    Box placed = body;
    placed.centre_mm = turn.transpose() * (body.centre_mm - origin_mm);
    placed.directions = turn.transpose() * body.directions;
    return placed;
  }
};

std::string numbered(const char* name, std::size_t index) {
  return std::string{name} + " " + std::to_string(index + 1);
}

}  // namespace

Check::Check(const path::ToolPath& path, std::vector<Stretch> stretches, const Model& model)
    : places_{path, std::move(stretches)}, safety_mm_{model.safety_mm} {
  for (std::size_t i = 0; i < model.holder.size(); ++i)
    parts_.push_back({numbered("holder", i), model.holder[i], false});
  if (const auto& spindle = model.machine.spindle)
    for (std::size_t i = 0; i < spindle->size(); ++i)
      parts_.push_back({numbered("spindle", i), (*spindle)[i], true});
  if (model.machine.table) in_table_frame_.push_back({"table", table_of(*model.machine.table)});
  std::vector<Thing> on_workpiece;
  for (std::size_t i = 0; i < model.jig.size(); ++i)
    (model.jig[i].frame == JigBox::Frame::table ? in_table_frame_ : on_workpiece)
        .push_back({numbered("jig", i), box_of(model.jig[i])});

  double longest_gauge_mm = 0.0, lever_mm = 0.0;
  for (const Stretch& stretch : places_.stretches())
    longest_gauge_mm = std::max(longest_gauge_mm, stretch.gauge_length_mm);
  for (const Part& part : parts_) {
    const double height_mm =
        std::max(std::abs(part.cylinder.from_mm), std::abs(part.cylinder.to_mm));
    lever_mm =
        std::max(lever_mm, std::hypot(height_mm + (part.from_gauge_line ? longest_gauge_mm : 0.0),
                                      part.cylinder.radius_mm));
  }
  const auto pairs =
      static_cast<double>(parts_.size() * (in_table_frame_.size() + on_workpiece.size()));
  const double travel_mm = places_.travel_mm(lever_mm) * pairs;
  step_mm_ = std::isfinite(travel_mm) ? std::max(usual_step_mm, travel_mm / most_places)
                                      : std::numeric_limits<double>::infinity();
  with_workpiece_jig_ = earliest(on_workpiece, std::nullopt);
}

std::optional<Collision> Check::earliest(const std::vector<Thing>& things,
                                         std::optional<Collision> known) const {
  for (const Part& part : parts_) {
    for (const Thing& thing : things) {
      for (std::size_t i = 0; i < places_.stretches().size(); ++i) {
        machine::ToolCylinder cylinder = part.cylinder;
        if (part.from_gauge_line) {
          cylinder.from_mm += places_.stretches()[i].gauge_length_mm;
          cylinder.to_mm += places_.stretches()[i].gauge_length_mm;
        }
        const std::uint32_t before =
            known ? known->point : std::numeric_limits<std::uint32_t>::max();
        const auto found = first_place(places_, i,
                                       {.cylinder = cylinder,
                                        .obstacle = thing.shape,
                                        .safety_mm = safety_mm_,
                                        .step_mm = step_mm_},
                                       before);
        if (!found) continue;
        known = Collision{.point = found->point,
                          .cl_line = places_.cl_line(found->point),
                          .what = part.name,
                          .with = thing.name,
                          .distance_mm = found->distance_mm};
        break;
      }
    }
  }
  return known;
}

std::optional<Collision> Check::first_collision(const Mat3& turn, const Vec3& origin_mm) const {
  std::vector<Thing> things = in_table_frame_;
  for (Thing& thing : things)
    thing.shape = std::visit(IntoClCoordinates{turn, origin_mm}, thing.shape);
  return earliest(things, with_workpiece_jig_);
}

}  // namespace pentapost::clearance
