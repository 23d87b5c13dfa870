#pragma once

#include "pentapost/kinematics/model.hpp"

#include <optional>

namespace pentapost::kinematics {

/// The linear joint values (or rates) that `map.matrix` takes to `target`.
/// @return nullopt where the volume that the directions span is below 1e-6 of that at zero.
std::optional<Vec3> solve_linear(const Model& model, const Mat3& matrix, const Vec3& target);

}  // namespace pentapost::kinematics
