#include "pentapost/plan/branches.hpp"

#include "lib/plan/program_case.hpp"
#include "sample/chains.hpp"

#include <gtest/gtest.h>

namespace pentapost::plan {
namespace {

constexpr double step_rad = 0.01;

struct Pole {
  std::string chain;
  kinematics::Model model;
  std::uint8_t pole;
};

/// Every pole of every kind of machine with two rotary axes.
std::vector<Pole> poles() {
  std::vector<Pole> found;
  for (const auto& sample : sample::chains()) {
    const kinematics::Model model{sample.chain};
    if (model.rotary_count != 2) continue;
    const PoleZone zone = pole_zone(model, 0.0, 0.0);
    if (zone.at_zero) found.push_back({sample.name, model, 1});
    if (zone.at_pi) found.push_back({sample.name, model, 2});
  }
  return found;
}

/// The rotary values along the great circle through the pole towards `onward`, at these angles
/// from it.
AxisPath chosen(const Pole& at, const Vec3& onward, const std::vector<double>& angles_rad) {
  const Vec3 pole = pole_axis(at.model, at.pole);
  path::ToolPath path;
  std::uint32_t line = 0;
  for (const double angle_rad : angles_rad) {
    const Vec3 axis = std::cos(angle_rad) * pole + std::sin(angle_rad) * onward;
    path.add_point({static_cast<double>(line), 0, 0}, angle_rad == 0.0 ? pole : axis, line + 1,
                   path::Move::feed);
    ++line;
  }
  const auto candidates =
      find_candidates(at.model, path, {0, line}, pole_zone(at.model, 1e-9, 0.0), 0.0);
  return choose_branches(at.model, {}, path, candidates.value(), {}, 0.0, false).value();
}

double slope(const RotaryPair& from, const RotaryPair& to) {
  return (to.first_rad - from.first_rad) / (to.second_rad - from.second_rad);
}

/// lib/README.md section 4: straight through the pole the first axis turns by -1/2 (a.b) of the
/// second. Symmetric differences over 0.01 rad are off by the square of that.
TEST(PoleSlope, IsHalfTheCosineOfTheAxesOnEveryMachine) {
  std::mt19937_64 random{31};
  int nutating = 0;
  for (const Pole& at : poles()) {
    const Vec3 onward = sample::random_axis_at(random, at.model.a, pi / 2.0);
    const AxisPath found =
        chosen(at, onward, {-2 * step_rad, -step_rad, 0.0, step_rad, 2 * step_rad});
    const double expected = -0.5 * at.model.a.dot(at.model.b);
    for (const auto& departure : found.departures)
      EXPECT_NEAR(departure.pair.first_rad, found.at(2).first_rad, 2e-6) << at.chain;
    EXPECT_NEAR(slope(found.at(1), found.at(3)), expected, 2e-3) << at.chain;
    if (std::abs(expected) > 0.1) ++nutating;
  }
  EXPECT_GE(nutating, 10);
}

/// The same where the pole lies inside a move, not in its middle.
TEST(PoleSlope, IsTheSameAcrossAPoleInsideAMove) {
  std::mt19937_64 random{37};
  for (const Pole& at : poles()) {
    const Vec3 onward = sample::random_axis_at(random, at.model.a, pi / 2.0);
    const AxisPath found =
        chosen(at, onward, {-1.4 * step_rad, -0.4 * step_rad, 0.6 * step_rad, 1.6 * step_rad});
    ASSERT_EQ(found.crossings.size(), 1U) << at.chain;
    EXPECT_EQ(found.crossings.front().point, 2U);
    EXPECT_NEAR(found.crossings.front().fraction, 0.4, 1e-9) << at.chain;
    EXPECT_NEAR(slope(found.at(1), found.at(2)), -0.5 * at.model.a.dot(at.model.b), 2e-3)
        << at.chain;
  }
}

/// The 45 deg tables of the machines: b tilts by 45 deg against -a and a.
TEST(PoleSlope, OfTheNutatingTablesIsARootOfEighth) {
  const double root_of_eighth = 0.35355339059327373;
  const Vec3 onward = Vec3{0.8, 0.6, 0.0};
  const AxisPath found = chosen({"", kinematics::Model{sample::nutating_table()}, 1}, onward,
                                {-step_rad, 0.0, step_rad});
  EXPECT_NEAR(slope(found.at(0), found.at(2)), root_of_eighth, 1e-3);
  // B by the closed form of the 45 deg table: cos B = 2 cos(tilt) - 1.
  EXPECT_NEAR(std::abs(found.at(2).second_rad), std::acos(2.0 * std::cos(step_rad) - 1.0), 1e-9);
}

/// The values that a path comes to the pole with and leaves it with differ by rounding: that is no
/// turn in place, which would need a block of its own and limits of the axes for its feed.
TEST(PoleSlope, ThroughThePoleNothingTurnsInPlace) {
  sample::ProgramCase job{sample::nutating_table()};
  job.ranges = {};
  job.feed_rate(500.0);
  for (const double angle_rad : {-0.02, -0.01, 0.0, 0.01, 0.02})
    job.point({100.0 * angle_rad, 0, 0},
              {0.8 * std::sin(angle_rad), 0.6 * std::sin(angle_rad), std::cos(angle_rad)});
  const auto program = job.planned();
  ASSERT_TRUE(program) << program.error().message;
  EXPECT_EQ(program->inserted_points, 0U);
  const auto& blocks = program->motion.blocks;
  for (std::size_t i = 1; i < blocks.size(); ++i)
    EXPECT_NE(blocks[i].word, blocks[i - 1].word) << i;
}

}  // namespace
}  // namespace pentapost::plan
