#pragma once

#include "machines/bundled.hpp"
#include "pentapost/analysis/demand.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/kinematics/joint_motion.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/turn.hpp"
#include "pentapost/reorient/axis_rates.hpp"
#include "sample/chains.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Machines, clampings and motions for tests of what a setup asks of the axes.
namespace pentapost::sample {

struct RateMachine {
  std::string name;
  kinematics::Model model;
};

/// All bundled machines with two rotary joints, and random chains of every kind.
inline std::vector<RateMachine> rate_machines(int random_count) {
  std::vector<RateMachine> machines;
  for (const BundledMachine& each : bundled_machines())
    if (kinematics::Model model{each.definition.chain}; model.rotary_count == 2)
      machines.push_back({each.definition.name, std::move(model)});
  std::mt19937_64 random{20171};
  for (int i = 0; i < random_count; ++i)
    machines.push_back(
        {"random_" + std::to_string(i), kinematics::Model{random_chain(random, 2, i % 4)}});
  return machines;
}

/// Rates of the axes from the joint values, which AxisRates does without.
/// @return nullopt at a singularity or out of reach.
inline std::optional<analysis::PerAxis> rates_by_joints(const kinematics::Model& model,
                                                        double gauge_length_mm,
                                                        const reorient::ToolMotion& motion,
                                                        const Mat3& to_table, const Vec3& origin_mm,
                                                        int branch) {
  const auto found = kinematics::inverse_rotary(model, to_table * motion.axis);
  if (found.count < 2) return std::nullopt;
  const auto& joints = found.branch[static_cast<std::size_t>(branch)];
  kinematics::JointMotion posture{model, joints.first_rad, joints.second_rad, gauge_length_mm};
  if (!posture.reach(to_table * motion.tip_mm + origin_mm)) return std::nullopt;
  const auto rates =
      posture.rates({to_table * motion.tip_mm_s, to_table * motion.turn_rad_s.cross(motion.axis)});
  if (!rates) return std::nullopt;
  analysis::PerAxis all = analysis::per_axis(*rates);
  for (double& each : all) each = std::abs(each);
  return all;
}

/// Random numbers for these tests.
class RateRandom {
 public:
  explicit RateRandom(std::uint64_t seed) : random_{seed} {}

  double real(double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random_);
  }
  /// Evenly over the orders of magnitude.
  double size(double least, double most) { return std::exp(real(std::log(least), std::log(most))); }
  int whole(int lower, int upper) {
    return std::uniform_int_distribution<int>{lower, upper}(random_);
  }
  bool chance(double share) { return real(0.0, 1.0) < share; }
  Vec3 direction() { return random_axis(random_); }
  Vec3 direction_at(const Vec3& axis, double angle_rad) {
    return random_axis_at(random_, axis, angle_rad);
  }
  /// Of a length up to `most`, often just that.
  Vec3 vector_within(double most) { return (chance(0.5) ? most : real(0.0, most)) * direction(); }
  double within(double most) { return chance(0.5) ? most : real(0.0, most); }

  Mat3 turn() { return path::setup_turn(real(-pi, pi), real(-pi, pi)); }
  Vec3 place_mm() { return {real(-300, 300), real(-300, 300), real(-300, 300)}; }

  /// An angle between pole and tool axis within reach, or a little beyond; often near its ends.
  double gamma_rad(const kinematics::Model& model) {
    const double least = std::abs(model.lambda_rad - model.mu_rad);
    const double most = model.lambda_rad + model.mu_rad;
    switch (whole(0, 5)) {
      case 0:
        return std::clamp(least + size(1e-6, 0.3), 0.0, pi);
      case 1:
        return std::clamp(most - size(1e-6, 0.3), 0.0, pi);
      case 2:
        return real(0.0, pi);
      default:
        return real(least, std::min(most, pi));
    }
  }

  reorient::ToolMotion motion(const Vec3& axis) {
    reorient::ToolMotion motion;
    motion.axis = axis;
    if (!chance(0.1)) motion.turn_rad_s = size(1e-3, 10.0) * direction_at(axis, 0.5 * pi);
    motion.tip_mm = place_mm();
    if (!chance(0.1)) motion.tip_mm_s = size(0.1, 200.0) * direction();
    return motion;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace pentapost::sample
