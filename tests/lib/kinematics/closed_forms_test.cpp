#include "lib/kinematics/hard_chains.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

/// The inverse against the closed forms that papers and posts print for single machines.
namespace pentapost::kinematics {
namespace {

/// Tool axes off the poles, where the closed forms keep their digits.
Vec3 axis_off_the_poles(std::mt19937_64& random) {
  for (;;) {
    const Vec3 axis = sample::random_axis(random);
    if (std::hypot(axis.x(), axis.y()) > 0.05) return axis;
  }
}

void expect_same_angle(double found_rad, double expected_rad, double tolerance_rad = 1e-13) {
  EXPECT_NEAR(wrapped_rad(found_rad - expected_rad), 0.0, tolerance_rad);
}

// Cripps et al. 2017 Table 1: A = atan2(+-sqrt(i^2 + j^2), k), C = atan2(+-i, +-j).
TEST(ClosedForms, TableOneOfCrippsAndOthers) {
  const Model model{sample::trunnion_ac()};
  std::mt19937_64 random{42};
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 axis = axis_off_the_poles(random);

    const auto found = inverse_rotary(model, axis);

    for (const std::size_t side : {0u, 1u}) {
      const double sign = side == 0 ? 1.0 : -1.0;
      expect_same_angle(found.branch[side].second_rad,
                        std::atan2(sign * std::hypot(axis.x(), axis.y()), axis.z()));
      expect_same_angle(found.branch[side].first_rad, std::atan2(sign * axis.x(), sign * axis.y()));
    }
    if (HasFailure()) break;
  }
}

// Cripps et al. 2017 eq. (1) for the linear axes, with a tool of no length.
TEST(ClosedForms, EquationOneOfCrippsAndOthers) {
  const Model model{sample::trunnion_ac()};
  const double a = 0.7, c = -2.1;
  const Vec3 tip_mm{11, -23, 37};

  const auto found = inverse_linear(model, tip_mm, c, a, 0.0);

  const double turned_y = std::sin(c) * 11 + std::cos(c) * -23;
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x(), std::cos(c) * 11 - std::sin(c) * -23, 1e-13);
  EXPECT_NEAR(found->y(), std::cos(a) * turned_y - std::sin(a) * 37, 1e-13);
  EXPECT_NEAR(found->z(), std::sin(a) * turned_y + std::cos(a) * 37, 1e-13);
}

// The nutating-table paper eq. (5) with Delta_z^2 = 1/2: B = arccos(2 K - 1). C follows from
// Rodrigues' formula: o(B, 0) = (sin B / sqrt 2, -(1 - cos B) / 2, (1 + cos B) / 2).
TEST(ClosedForms, NutatingTable) {
  const Model model{sample::nutating_table()};
  std::mt19937_64 random{42};
  for (int i = 0; i < 10'000; ++i) {
    Vec3 axis = axis_off_the_poles(random);
    axis.z() = std::abs(axis.z());
    if (axis.z() < 0.01) continue;  // arccos loses digits at B = 180 deg

    const auto found = inverse_rotary(model, axis);

    for (const std::size_t side : {0u, 1u}) {
      const double b = (side == 0 ? 1.0 : -1.0) * std::acos(2.0 * axis.z() - 1.0);
      const double c = std::atan2(axis.y(), axis.x()) -
                       std::atan2(-(1.0 - std::cos(b)) / 2.0, std::sin(b) / std::sqrt(2.0));
      expect_same_angle(found.branch[side].second_rad, b, 1e-12);
      expect_same_angle(found.branch[side].first_rad, c, 1e-12);
    }
    if (HasFailure()) break;
  }
}

// The B/C trunnion: o = (sin B cos C, sin B sin C, cos B).
TEST(ClosedForms, TrunnionBc) {
  const Model model{sample::trunnion_bc()};
  std::mt19937_64 random{42};
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 axis = axis_off_the_poles(random);

    const auto found = inverse_rotary(model, axis);

    for (const std::size_t side : {0u, 1u}) {
      const double sign = side == 0 ? 1.0 : -1.0;
      expect_same_angle(found.branch[side].second_rad,
                        std::atan2(sign * std::hypot(axis.x(), axis.y()), axis.z()));
      expect_same_angle(found.branch[side].first_rad, std::atan2(sign * axis.y(), sign * axis.x()));
    }
    if (HasFailure()) break;
  }
}

// A C/A fork head: o = (sin A sin C, -sin A cos C, cos A).
TEST(ClosedForms, ForkHeadCa) {
  const Model model{sample::fork_head_ca()};
  std::mt19937_64 random{42};
  for (int i = 0; i < 10'000; ++i) {
    const Vec3 axis = axis_off_the_poles(random);

    const auto found = inverse_rotary(model, axis);

    for (const std::size_t side : {0u, 1u}) {
      const double sign = side == 0 ? 1.0 : -1.0;
      expect_same_angle(found.branch[side].second_rad,
                        std::atan2(sign * std::hypot(axis.x(), axis.y()), axis.z()));
      expect_same_angle(found.branch[side].first_rad,
                        std::atan2(sign * axis.x(), -sign * axis.y()));
    }
    if (HasFailure()) break;
  }
}

// The fork of the same head hangs 205 mm above the gauge line: X, Y, Z carry the pivot.
TEST(ClosedForms, LinearAxesOfTheForkHeadCa) {
  const Model model{sample::fork_head_ca()};
  const double c = 0.9, a = -0.6, lever_mm = 205.0 + 130.0;
  const Vec3 axis{std::sin(a) * std::sin(c), -std::sin(a) * std::cos(c), std::cos(a)};
  const Vec3 tip_mm{400, -120, 55};

  const auto found = inverse_linear(model, tip_mm, c, a, 130.0);

  ASSERT_TRUE(found);
  const Vec3 pivot_mm = tip_mm + lever_mm * axis - Vec3{0, 0, 205};
  EXPECT_LT((*found - pivot_mm).norm(), 1e-12);
}

// Appendix 2 of Cripps et al. 2017, blocks N110, N170 and N250: what the control was given.
TEST(ClosedForms, BlocksOfAppendixTwoOfCrippsAndOthers) {
  const Model model{sample::trunnion_ac()};
  const struct {
    double x_mm, a_deg, c_deg;
  } blocks[] = {{0, 14.825, 137.259}, {6, 11.788, 127.783}, {14, 7.141, 117.071}};
  for (const auto& block : blocks) {
    SCOPED_TRACE(block.x_mm);
    // (i, -j, k) of R_x(11 deg) R_z(3.6 deg x - 90 deg) R_x(-10 deg) z in passive matrices
    // (lib/README.md section 8).
    const auto passive = [](double angle_deg, const Vec3& axis) {
      return Eigen::AngleAxisd{-angle_deg * rad_per_deg, axis}.toRotationMatrix();
    };
    Vec3 axis = passive(11, Vec3::UnitX()) * passive(3.6 * block.x_mm - 90, Vec3::UnitZ()) *
                passive(-10, Vec3::UnitX()) * Vec3::UnitZ();
    axis.y() = -axis.y();

    const auto found = inverse_rotary(model, axis);

    EXPECT_NEAR(found.branch[0].second_rad * deg_per_rad, block.a_deg, 0.00051);
    EXPECT_NEAR(found.branch[0].first_rad * deg_per_rad, block.c_deg, 0.00051);
  }
}

}  // namespace
}  // namespace pentapost::kinematics
