#include "pentapost/analysis/stretch.hpp"

#include "machines/bundled.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/kinematics/singularity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace pentapost::analysis {
namespace {

using kinematics::Model;
using Columns = Eigen::Matrix<double, 5, 1>;

constexpr double gauge_length_mm = 140.0;

class RatesOnMachine : public ::testing::TestWithParam<sample::BundledMachine> {
 protected:
  Vec3 random_axis() {
    return Vec3{normal_(random_), normal_(random_), normal_(random_)}.normalized();
  }
  Vec3 random_tangent(const Vec3& axis) { return axis.cross(random_axis()).normalized(); }

  /// The joints by the inverse alone, in a window about those of `near`.
  Columns joints_at(const path::Segment& move, int branch, double fraction, const Columns* near) {
    const auto found = kinematics::inverse_rotary(model_, move.axis(fraction));
    EXPECT_EQ(found.count, 2);
    const auto& solution = found.branch[static_cast<std::size_t>(branch)];
    const auto linear = kinematics::inverse_linear(
        model_, move.tip_mm(fraction), solution.first_rad, solution.second_rad, gauge_length_mm);
    Columns all;
    all << linear.value_or(Vec3{NAN, NAN, NAN}), solution.first_rad, solution.second_rad;
    if (near != nullptr)
      for (const Eigen::Index i : {3, 4}) all[i] = (*near)[i] + wrapped_rad(all[i] - (*near)[i]);
    return all;
  }

  /// Rates half way along a short move through `axis`, against central differences with two
  /// extrapolations to step 0.
  void expect_rates(const Vec3& axis, double distance_rad) {
    const double step_rad = std::min(1e-3, 5e-4 * distance_rad);
    const Vec3 along = random_tangent(axis);
    const auto turned = [&](double angle) {
      return Vec3{(std::cos(angle) * axis + std::sin(angle) * along).normalized()};
    };
    const double half_rad = 8.0 * step_rad;
    const Vec3 tip_mm = 100.0 * random_axis(), way_mm = 20.0 * half_rad * random_axis();
    const path::Segment move{tip_mm - way_mm, turned(-half_rad), tip_mm + way_mm, turned(half_rad)};
    for (const int branch : {0, 1}) {
      std::optional<kinematics::JointMotion> end;
      const ClStretch stretch{model_,       move, ClStretch::Follows::branch,
                              branch,       {},   gauge_length_mm,
                              Vec3::Zero(), 0.0,  end};
      const auto found = stretch.at(0.5);
      ASSERT_TRUE(found);
      const Columns at = joints_at(move, branch, 0.5, nullptr);
      const auto difference = [&](double h) {
        return Columns{
            (joints_at(move, branch, 0.5 + h, &at) - joints_at(move, branch, 0.5 - h, &at)) /
            (2.0 * h)};
      };
      const double h = step_rad / (2.0 * half_rad);
      const Columns coarse = difference(4.0 * h), middle = difference(2.0 * h),
                    fine = difference(h);
      const Columns first = (4.0 * middle - coarse) / 3.0, second = (4.0 * fine - middle) / 3.0;
      const Columns expected = (16.0 * second - first) / 15.0;
      const double scale = std::max(std::abs(expected[3]), std::abs(expected[4]));
      for (const Eigen::Index i : {3, 4})
        EXPECT_NEAR(found->rate[static_cast<std::size_t>(i)], expected[i], 1e-6 * scale);
      const double lever_mm = 1000.0;
      for (const Eigen::Index i : {0, 1, 2})
        EXPECT_NEAR(found->rate[static_cast<std::size_t>(i)], expected[i],
                    1e-6 * (scale * lever_mm + way_mm.norm()));
    }
  }

  Model model_{GetParam().definition.chain};
  std::mt19937_64 random_{11};
  std::normal_distribution<double> normal_;
};

TEST_P(RatesOnMachine, AreDifferencesOfTheInverse) {
  for (int i = 0; i < 300; ++i) {
    const Vec3 axis = random_axis();
    const auto found = kinematics::inverse_rotary(model_, axis);
    if (found.count < 2) continue;
    const auto nearest = kinematics::nearest_singularity(kinematics::singularities(model_), axis);
    if (nearest->distance_rad < 0.02) continue;
    expect_rates(axis, nearest->distance_rad);
  }
}

TEST_P(RatesOnMachine, AreDifferencesOfTheInverseNextToBothKindsOfSingularity) {
  constexpr double distance_rad = 1e-4;
  int near_count = 0;
  for (const auto& singularity : kinematics::singularities(model_))
    for (int i = 0; i < 100; ++i) {
      const Vec3 across = random_tangent(singularity.centre);
      for (const double gamma :
           {singularity.half_angle_rad + distance_rad, singularity.half_angle_rad - distance_rad}) {
        const Vec3 axis = std::cos(gamma) * singularity.centre + std::sin(gamma) * across;
        if (kinematics::inverse_rotary(model_, axis).count < 2) continue;
        expect_rates(axis, distance_rad);
        ++near_count;
      }
    }
  EXPECT_GT(near_count, 100);
}

std::vector<sample::BundledMachine> five_axis_machines() {
  auto machines = sample::bundled_machines();
  std::erase_if(machines,
                [](const auto& each) { return Model{each.definition.chain}.rotary_count < 2; });
  return machines;
}

INSTANTIATE_TEST_SUITE_P(, RatesOnMachine, ::testing::ValuesIn(five_axis_machines()),
                         [](const auto& machine) {
                           std::string name = machine.param.definition.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace pentapost::analysis
