#include "lib/kinematics/hard_chains.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

/// The accuracy that the library promises, over every machine: joints found for a pose bring the
/// pose back within 1e-9 mm and 1e-13 rad, next to poles and reach boundaries too.
namespace pentapost::kinematics {
namespace {

constexpr double tip_tolerance_mm = 1e-9;
constexpr double axis_tolerance = 1e-13;
/// Beyond 100 m of travel, which is next to where linear axes lose rank, a double has no 1e-9 mm.
constexpr double largest_travel_mm = 1e5;

/// Poses: the axis from random rotary values, one in four next to a pole or a reach boundary.
class PoseSource {
 public:
  explicit PoseSource(const Model& model) : model_{model} {}
  Pose next() {
    const double second_rad = pick_(random_) % 4 == 0 ? next_to_an_end_rad() : turn_rad_(random_);
    const Vec3 axis = forward_axis(model_, turn_rad_(random_), second_rad);
    return {{tip_mm_(random_), tip_mm_(random_), tip_mm_(random_)}, axis.normalized()};
  }
  double gauge_length_mm() { return gauge_mm_(random_); }

 private:
  double next_to_an_end_rad() {
    constexpr std::array distances_rad{0.0, 1e-12, -1e-12, 1e-9, -1e-9, 1e-6, -1e-6, 1e-15};
    const double end_rad = pick_(random_) % 2 == 0 ? 0.0 : pi;
    return model_.beta_zero_rad + end_rad + distances_rad[pick_(random_) % distances_rad.size()];
  }

  const Model& model_;
  std::mt19937_64 random_{42};
  std::uniform_int_distribution<std::size_t> pick_{0, 1 << 20};
  std::uniform_real_distribution<double> turn_rad_{-pi, pi}, tip_mm_{-500.0, 500.0},
      gauge_mm_{0.0, 300.0};
};

struct Errors {
  double tip_mm = 0.0, axis = 0.0;
  int unreached = 0;     ///< poses without a rotary solution
  int without_rank = 0;  ///< solutions without a linear one
  void add(const Pose& wanted, const Pose& reached, double travel_mm) {
    const double tip_error_mm = (reached.tip_mm - wanted.tip_mm).norm();
    const double axis_error = (reached.axis - wanted.axis).norm();
    const double share = std::max(1.0, travel_mm / largest_travel_mm);
    tip_mm = std::isfinite(tip_error_mm) ? std::max(tip_mm, tip_error_mm / share) : INFINITY;
    axis = std::isfinite(axis_error) ? std::max(axis, axis_error) : INFINITY;
  }
};

Errors errors_over(const Model& model, int poses) {
  PoseSource source{model};
  Errors errors;
  for (int i = 0; i < poses; ++i) {
    const Pose wanted = source.next();
    const double gauge_length_mm = source.gauge_length_mm();
    const RotarySolutions found = inverse_rotary(model, wanted.axis);
    if (found.count == 0) ++errors.unreached;
    for (std::size_t k = 0; k < static_cast<std::size_t>(found.count); ++k) {
      const auto& [first_rad, second_rad] = found.branch[k];
      const auto linear_mm =
          inverse_linear(model, wanted.tip_mm, first_rad, second_rad, gauge_length_mm);
      if (!linear_mm) {
        ++errors.without_rank;
        continue;
      }
      const Pose reached = forward(model, {*linear_mm, first_rad, second_rad}, gauge_length_mm);
      errors.add(wanted, reached, linear_mm->norm());
    }
  }
  return errors;
}

class PoseRoundTripOn : public ::testing::TestWithParam<sample::NamedChain> {};

TEST_P(PoseRoundTripOn, BringsPosesBack) {
  const Model model{GetParam().chain};

  const Errors errors = errors_over(model, PENTAPOST_POSES);

  EXPECT_LT(errors.tip_mm, tip_tolerance_mm);
  EXPECT_LT(errors.axis, axis_tolerance);
  EXPECT_EQ(errors.unreached, 0);
  EXPECT_LT(errors.without_rank, 100);
}

INSTANTIATE_TEST_SUITE_P(, PoseRoundTripOn, ::testing::ValuesIn(sample::bundled_chains()),
                         sample::name_of_chain);

class PoseRoundTripOnHardChain : public ::testing::TestWithParam<sample::NamedChain> {};

TEST_P(PoseRoundTripOnHardChain, BringsPosesBack) {
  const Model model{GetParam().chain};

  const Errors errors = errors_over(model, PENTAPOST_POSES / 20);

  EXPECT_LT(errors.tip_mm, tip_tolerance_mm);
  EXPECT_LT(errors.axis, axis_tolerance);
  EXPECT_EQ(errors.unreached, 0);
}

INSTANTIATE_TEST_SUITE_P(, PoseRoundTripOnHardChain, ::testing::ValuesIn(sample::hard_chains()),
                         sample::name_of_chain);

// Joints in any order, on either side, with axes that do not meet, and linear joints anywhere.
TEST(PoseRoundTrip, HoldsOnRandomChainsOfEveryKind) {
  for (const auto& [name, chain] : sample::random_chains(1000, 2024)) {
    SCOPED_TRACE(name);
    const Errors errors = errors_over(Model{chain}, 1'000);

    ASSERT_LT(errors.tip_mm, tip_tolerance_mm);
    ASSERT_LT(errors.axis, axis_tolerance);
    ASSERT_EQ(errors.unreached, 0);
  }
}

}  // namespace
}  // namespace pentapost::kinematics
