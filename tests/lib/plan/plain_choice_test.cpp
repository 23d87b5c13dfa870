#include "pentapost/plan/plain_choice.hpp"

#include "machines/bundled.hpp"
#include "pentapost/kinematics/forward.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pentapost::plan {
namespace {

/// A walk of the joints, so that every tool axis is within reach, in steps of up to 12 deg.
path::ToolPath joint_walk(const kinematics::Model& model, const JointRanges& ranges,
                          std::mt19937_64& random) {
  const auto real = [&](double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random);
  };
  const auto within = [](const std::optional<Range<double>>& range) {
    return range ? Range<double>{std::max(range->lower, -2.0), std::min(range->upper, 2.0)}
                 : Range<double>{-2.0, 2.0};
  };
  const Range<double> second_range = within(ranges.rotary_rad[1]);
  path::ToolPath tool_path;
  double first_rad = real(-3.0, 3.0), second_rad = real(second_range.lower, second_range.upper);
  const double first_step = real(-0.2, 0.2), second_step = real(-0.05, 0.05);
  Vec3 tip_mm = Vec3::Zero();
  for (std::uint32_t i = 0; i < 60; ++i) {
    tool_path.add_point(tip_mm, kinematics::forward_axis(model, first_rad, second_rad), i + 1,
                        path::Move::feed);
    tip_mm += Vec3{real(-2, 2), real(-2, 2), real(-2, 2)};
    first_rad += first_step;
    if (second_range.contains(second_rad + second_step)) second_rad += second_step;
  }
  return tool_path;
}

/// The shortcut answers most paths off the pole, and always what the whole search answers.
TEST(PlainChoice, IsTheAnswerOfTheWholeSearch) {
  std::mt19937_64 random{42};
  int answered = 0;
  for (const auto& machine : sample::bundled_machines()) {
    const kinematics::Model model{machine.definition.chain};
    if (model.rotary_count != 2) continue;
    const JointRanges ranges = joint_ranges(machine.definition.chain, model);
    Settings settings;
    settings.preferences = machine.definition.preferences;
    settings.limits = machine.definition.limits;
    for (int i = 0; i < 200; ++i) {
      SCOPED_TRACE(machine.definition.name + " path " + std::to_string(i));
      const path::ToolPath tool_path = joint_walk(model, ranges, random);
      const PointRange range{0, static_cast<std::uint32_t>(tool_path.size())};
      const PoleZone zone = pole_zone(model, 1e-9, 1e-4);
      const auto plain = plain_choice(model, ranges, tool_path, range, zone, settings, 0.0, false);
      if (!plain) continue;
      ++answered;
      const auto candidates = find_candidates(model, tool_path, range, zone, 1e-4);
      ASSERT_TRUE(candidates);
      const auto whole =
          choose_branches(model, ranges, tool_path, *candidates, settings, 0.0, false);
      ASSERT_TRUE(whole);
      EXPECT_TRUE(whole->departures.empty());
      EXPECT_TRUE(whole->crossings.empty());
      for (std::uint32_t point = 0; point < range.end; ++point) {
        ASSERT_NEAR(plain->at(point).first_rad, whole->at(point).first_rad, 1e-9) << point;
        ASSERT_NEAR(plain->at(point).second_rad, whole->at(point).second_rad, 1e-9) << point;
        ASSERT_EQ(plain->branch[point], whole->branch[point]) << point;
      }
    }
  }
  EXPECT_GT(answered, 500);
}

/// Through the pole, or with a limit on the way, the shortcut keeps out.
TEST(PlainChoice, LeavesPathsThroughThePoleToTheSearch) {
  const auto machine = sample::bundled_machine("hermle-c600u");
  const kinematics::Model model{machine.chain};
  const JointRanges ranges = joint_ranges(machine.chain, model);
  Settings settings;
  settings.preferences = machine.preferences;
  path::ToolPath tool_path;
  for (const double tilt_rad : {0.1, 0.05, 0.0, -0.05, -0.1})
    tool_path.add_point(Vec3::Zero(), kinematics::forward_axis(model, 0.5, tilt_rad), 1,
                        path::Move::feed);
  const PoleZone zone = pole_zone(model, 1e-9, 1e-4);

  EXPECT_FALSE(plain_choice(model, ranges, tool_path, {0, 5}, zone, settings, 0.0, false));
}

}  // namespace
}  // namespace pentapost::plan
