#include "pentapost/verify/pole_allowance.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace pentapost::verify {
namespace {

/// Arithmetic on unit vectors.
constexpr double rounding_rad = 1e-9;
constexpr double largest_pole_axis_rad = 0.5 * pi;

/// Tool axes along the first rotary axis that the machine reaches within the axis tolerance: where
/// the second axis is inclined alike to both.
std::vector<Vec3> poles_of(const Claim& claim) {
  const kinematics::Model& model = claim.model;
  std::vector<Vec3> poles;
  if (model.rotary_count != 2) return poles;
  const double tool_rad = angle_between_rad(model.b, model.t);
  for (const double sense : {1.0, -1.0}) {
    const Vec3 pole = sense * model.a;
    if (std::abs(angle_between_rad(model.b, pole) - tool_rad) <=
        claim.axis_tolerance_rad + rounding_rad)
      poles.push_back(pole);
  }
  return poles;
}

bool is_changed(const Claim& claim, std::uint32_t point) {
  return claim.planned_axis_wp[point] != claim.tool_path.axis_wp[point];
}

class Check {
 public:
  explicit Check(const Claim& claim)
      : claim_{claim},
        poles_{poles_of(claim)},
        // Beyond it a change by pole_axis_rad serves no passage.
        reach_rad_{std::sqrt(2.0 * claim.pole_axis_rad) + rounding_rad},
        on_arc_(claim.tool_path.size(), false) {
    for (const path::Event& event : claim.tool_path.events)
      if (std::holds_alternative<path::Arc>(event.what) && event.before_point < on_arc_.size())
        on_arc_[event.before_point] = true;
  }

  Status run() {
    const auto size = static_cast<std::uint32_t>(claim_.tool_path.size());
    for (std::uint32_t point = 0; point < size; ++point) {
      if (!is_changed(claim_, point)) continue;
      // Written so that NaN fails.
      const double change_rad =
          angle_between_rad(claim_.planned_axis_wp[point], claim_.tool_path.axis_wp[point]);
      if (!(change_rad <= claim_.pole_axis_rad + rounding_rad))
        return failed(point, "is changed by " + degrees(change_rad) + ", allowed are " +
                                 degrees(claim_.pole_axis_rad));
      if (point == 0 || point + 1 == size) return failed(point, "is changed at an end of the path");
      if (!may_be_changed(point) || !may_be_changed(point + 1))
        return failed(point, "is changed on a move that is no straight feed move");
      for (const std::uint32_t place : {point - 1, point, point + 1})
        if (!is_near_pole(place))
          return failed(point, "is changed farther than " + degrees(reach_rad_) +
                                   " from every pole of the machine");
    }
    return ok();
  }

 private:
  bool may_be_changed(std::uint32_t move) const {
    return claim_.tool_path.move[move] == path::Move::feed && !on_arc_[move];
  }

  bool is_near_pole(std::uint32_t point) const {
    for (const Vec3& pole : poles_)
      if (angle_between_rad(pole, claim_.tool_path.axis_wp[point]) <= reach_rad_) return true;
    return false;
  }

  static std::string degrees(double angle_rad) {
    return number_text(angle_rad * deg_per_rad, 6) + " deg";
  }

  Problem failed(std::uint32_t point, const std::string& what) const {
    const std::uint32_t line = claim_.tool_path.cl_line[point];
    return {.code = Code::proof_failed,
            .message = "The planned tool axis at CL line " + std::to_string(line) + ' ' + what,
            .cl_line = line};
  }

  const Claim& claim_;
  const std::vector<Vec3> poles_;
  const double reach_rad_;
  std::vector<bool> on_arc_;
};

}  // namespace

bool has_changed_axis(const Claim& claim, std::uint32_t point) {
  if (claim.planned_axis_wp.empty()) return false;
  return is_changed(claim, point) || (point > 0 && is_changed(claim, point - 1));
}

Status check_pole_allowance(const Claim& claim) {
  if (claim.planned_axis_wp.empty()) return ok();
  if (claim.planned_axis_wp.size() != claim.tool_path.size())
    return Problem{Code::proof_failed, "The planned tool axes are not one for each CL point"};
  if (!(claim.pole_axis_rad >= 0.0 && claim.pole_axis_rad <= largest_pole_axis_rad))
    return Problem{Code::proof_failed, "The largest change of the tool axis is no angle"};
  return Check{claim}.run();
}

}  // namespace pentapost::verify
