#include "pentapost/analysis/quiet_moves.hpp"
#include "lib/analysis/cut.hpp"
#include "pentapost/kinematics/forward.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pentapost::analysis {
namespace {

std::vector<sample::BundledMachine> five_axis_machines() {
  auto machines = sample::bundled_machines();
  std::erase_if(machines, [](const auto& each) {
    return kinematics::Model{each.definition.chain}.rotary_count != 2;
  });
  return machines;
}

/// Random walks of the joints.
class QuietMovesOnMachine : public ::testing::TestWithParam<sample::BundledMachine> {};

/// What is left out can be near no limit: zones and times are those of the whole analysis.
TEST_P(QuietMovesOnMachine, LeaveZonesAndTimesAsTheyAre) {
  const machine::Definition& machine = GetParam().definition;
  const kinematics::Model model{machine.chain};
  const plan::JointRanges ranges = plan::joint_ranges(machine.chain, model);
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  std::size_t zones = 0, walks = 0;
  for (int walk = 0; walk < 40; ++walk) {
    plan::Settings settings;
    settings.preferences = machine.preferences;
    settings.gauge_length_mm[1] = 120.0;
    settings.origin_mm = 100.0 * Vec3{unit(random), unit(random), unit(random)};
    for (const auto& name : model.linear_names)
      settings.limits[name].max_speed = 40.0 * std::exp(1.5 * unit(random));
    for (const auto& name : model.rotary_names)
      settings.limits[name].max_speed = 0.6 * std::exp(1.5 * unit(random));
    path::ToolPath path;
    path.add_event(1, path::FeedRate{.value = 1500.0});
    const double step_rad = 0.02 * (1.0 + unit(random));
    // Near either singularity, on either branch.
    const double near_rad = (walk % 4 < 2 ? 1.0 : -1.0) * (0.2 + 0.15 * unit(random));
    const double opening_rad = walk % 2 == 0 ? near_rad : pi - near_rad;
    kinematics::Joints joints{.first_rad = unit(random),
                              .second_rad = model.beta_zero_rad + opening_rad};
    for (std::uint32_t point = 0; point < 60; ++point) {
      joints.linear_mm += Vec3{unit(random), unit(random), unit(random)};
      joints.first_rad += step_rad * unit(random);
      joints.second_rad += step_rad * unit(random);
      const auto pose = kinematics::forward(model, joints, 120.0);
      path.add_point(pose.tip_mm - settings.origin_mm, pose.axis, point + 2,
                     point == 0 ? path::Move::rapid : path::Move::feed);
    }
    const auto whole = analyse_path(model, ranges, path, settings, {});
    const auto quick = analyse_path(model, ranges, path, settings, {.zones_only = true});
    ASSERT_EQ(whole.has_value(), quick.has_value());
    if (!whole) continue;  // out of the machine's ranges
    ++walks;
    zones += whole->zones.size() + whole->over_demands.size();
    EXPECT_NEAR(quick->predicted_time_s, whole->predicted_time_s, 1e-9 * whole->predicted_time_s);
    EXPECT_NEAR(quick->programmed_time_s, whole->programmed_time_s,
                1e-12 * whole->programmed_time_s);
    ASSERT_EQ(quick->zones.size(), whole->zones.size());
    ASSERT_EQ(quick->over_demands.size(), whole->over_demands.size());
    for (std::size_t i = 0; i < whole->zones.size(); ++i) {
      EXPECT_NEAR(quick->zones[i].from.s_mm, whole->zones[i].from.s_mm, 1e-9);
      EXPECT_NEAR(quick->zones[i].to.s_mm, whole->zones[i].to.s_mm, 1e-9);
      EXPECT_NEAR(quick->zones[i].peak_ratio, whole->zones[i].peak_ratio, 1e-9);
    }
  }
  EXPECT_GT(walks, 5U);
  EXPECT_GT(zones, 5U);
}

INSTANTIATE_TEST_SUITE_P(Bundled, QuietMovesOnMachine, ::testing::ValuesIn(five_axis_machines()),
                         [](const auto& machine) {
                           std::string name = machine.param.definition.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// A cut of 1 mm steps at 33 mm/s, the rotary axes all but at rest.
TEST(QuietMoves, AreMostOfAnOrdinaryPath) {
  const machine::Definition machine = sample::bundled_machine("hermle-c600u");
  const kinematics::Model model{machine.chain};
  plan::Settings settings;
  SpeedLimits limits;
  limits[first_axis] = limits[second_axis] = 2.6;
  const QuietMoves quiet{model, settings, Allowance{limits, 1.0}, 100.0};
  EXPECT_TRUE(quiet.is_quiet(Vec3::Zero(), sample::tilted(20.0, 10.0), sample::tilted(20.5, 10.5),
                             1.0, 0.03));
  // A quarter of a degree from the pole the first axis turns too fast.
  EXPECT_FALSE(quiet.is_quiet(Vec3::Zero(), sample::tilted(0.25, 10.0), sample::tilted(0.3, 80.0),
                              1.0, 0.03));
}

}  // namespace
}  // namespace pentapost::analysis
