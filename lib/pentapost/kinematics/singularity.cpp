#include "pentapost/kinematics/singularity.hpp"

#include "pentapost/kinematics/turns.hpp"

#include <cmath>

namespace pentapost::kinematics {
namespace {

/// Half angle below which a boundary circle cannot be told from a pole.
constexpr double pole_half_angle_rad = 1e-9;

Singularity singularity_at(const Vec3& a_drawn, double gamma_rad, double opening_rad) {
  if (gamma_rad < pole_half_angle_rad) return {SingularityKind::pole, a_drawn, 0.0, opening_rad};
  if (pi - gamma_rad < pole_half_angle_rad)
    return {SingularityKind::pole, -a_drawn, 0.0, opening_rad};
  return {SingularityKind::reach_boundary, a_drawn, gamma_rad, opening_rad};
}

}  // namespace

std::vector<Singularity> singularities(const Model& model) {
  if (model.rotary_count < 2) return {};
  const Vec3& a_drawn = model.fixed.a_drawn;
  return {singularity_at(a_drawn, std::abs(model.lambda_rad - model.mu_rad), 0.0),
          singularity_at(a_drawn, model.lambda_rad + model.mu_rad, pi)};
}

double distance_rad(const Singularity& singularity, const Vec3& axis) {
  return std::abs(angle_between_rad(singularity.centre, axis) - singularity.half_angle_rad);
}

std::optional<NearestSingularity> nearest_singularity(std::span<const Singularity> all,
                                                      const Vec3& axis) {
  std::optional<NearestSingularity> nearest;
  for (const Singularity& singularity : all) {
    const double distance = distance_rad(singularity, axis);
    if (!nearest || distance < nearest->distance_rad) nearest = {singularity, distance};
  }
  return nearest;
}

double linear_volume_ratio(const Model& model, double first_rad, double second_rad) {
  if (model.fixed.linear_place >= 0) return 1.0;
  const double volume = Turns{model, first_rad, second_rad}.linear_matrix().determinant();
  return std::abs(volume / model.fixed.linear_volume);
}

}  // namespace pentapost::kinematics
