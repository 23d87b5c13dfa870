#include "pentapost/kinematics/linear_solve.hpp"

#include <cmath>

namespace pentapost::kinematics {
namespace {

/// Share of the volume at zero below which the linear directions have lost rank.
constexpr double smallest_volume_ratio = 1e-6;

}  // namespace

std::optional<Vec3> solve_linear(const Model& model, const Mat3& matrix, const Vec3& target) {
  const Vec3 x = matrix.col(0), y = matrix.col(1), z = matrix.col(2);
  const Vec3 across_x = y.cross(z), across_y = z.cross(x), across_z = x.cross(y);
  const double volume = x.dot(across_x);
  if (!(std::abs(volume) >= smallest_volume_ratio * std::abs(model.fixed.linear_volume)))
    return std::nullopt;

  const auto solve = [&](const Vec3& right_side) {
    const Vec3 volumes{across_x.dot(right_side), across_y.dot(right_side),
                       across_z.dot(right_side)};
    return Vec3{volumes / volume};
  };
  // A second pass takes out what the first leaves where the directions are nearly dependent.
  const Vec3 first = solve(target);
  return first + solve(target - matrix * first);
}

}  // namespace pentapost::kinematics
