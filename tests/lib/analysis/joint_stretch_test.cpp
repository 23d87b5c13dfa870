#include "pentapost/analysis/joint_stretch.hpp"

#include "machines/bundled.hpp"
#include "pentapost/analysis/grid.hpp"
#include "sample/chains.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pentapost::analysis {
namespace {

using kinematics::Joints;
using kinematics::Model;

constexpr double any_turn = 1e9;

/// A block of a random machine: ends of the joints, and a tip that runs on a line or an arc.
class RandomBlock {
 public:
  RandomBlock(std::mt19937_64& random, const Model& model) : random_{random} {
    ends_.from = joints();
    ends_.to = joints();
    for (Joints* const end : {&ends_.from, &ends_.to}) {
      if (model.rotary_count < 1) end->first_rad = 0.0;
      if (model.rotary_count < 2) end->second_rad = 0.0;
    }
    frame_ = {.gauge_length_mm = real(0, 200), .origin_mm = Vec3{real(-9, 9), 1.0, real(-9, 9)}};
    const Vec3 from{real(-50, 50), real(-50, 50), real(-50, 50)};
    const Vec3 to{real(-50, 50), real(-50, 50), real(-50, 50)};
    const path::Arc arc{
        .centre_wp_mm = from + Vec3{10, 0, 0}, .normal_wp = Vec3::UnitZ(), .sweep_rad = 2.0};
    const bool is_arc = real(0, 1) < 0.5;
    segment_.emplace(from, Vec3::UnitZ(),
                     is_arc ? Vec3{from + Vec3{14.161468365471424, -9.092974268256818, 3.0}} : to,
                     Vec3::UnitZ(), is_arc ? &arc : nullptr);
  }
  const JointStretch::Ends& ends() const { return ends_; }
  const JointStretch::Frame& frame() const { return frame_; }
  const path::Segment& segment() const { return *segment_; }

 private:
  double real(double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random_);
  }
  Joints joints() {
    return {{real(-100, 100), real(-100, 100), real(-100, 100)}, real(-3, 3), real(-1.2, 1.2)};
  }

  std::mt19937_64& random_;
  JointStretch::Ends ends_;
  JointStretch::Frame frame_;
  std::optional<path::Segment> segment_;
};

/// Central differences of the joints of the block itself; `order` 1 or 2.
PerAxis difference(const JointStretch& stretch, double fraction, double step, int order) {
  const auto before = stretch.at(fraction - step)->joints, there = stretch.at(fraction)->joints,
             after = stretch.at(fraction + step)->joints;
  PerAxis result{};
  for (std::size_t i = 0; i < axis_count; ++i)
    result[i] = order == 1 ? (after[i] - before[i]) / (2.0 * step)
                           : (after[i] - 2.0 * there[i] + before[i]) / (step * step);
  return result;
}

double largest(const PerAxis& values) {
  double most = 1.0;
  for (const double each : values) most = std::max(most, std::abs(each));
  return most;
}

TEST(JointStretch, HasTheRatesOfItsOwnMotion) {
  std::mt19937_64 random{3};
  for (const auto& machine : sample::bundled_machines()) {
    const Model model{machine.definition.chain};
    for (int i = 0; i < 50; ++i) {
      const RandomBlock block{random, model};
      for (const path::Segment* tip :
           {&block.segment(), static_cast<const path::Segment*>(nullptr)}) {
        const JointStretch stretch{model, tip, block.ends(), block.frame(), any_turn};
        const auto demand = stretch.at(0.37);
        if (!demand) continue;
        const PerAxis expected = difference(stretch, 0.37, 1e-5, 1);
        for (std::size_t axis = 0; axis < axis_count; ++axis)
          EXPECT_NEAR(demand->rate[axis], expected[axis], 1e-6 * largest(expected))
              << machine.definition.name << " axis " << axis;
      }
    }
  }
}

TEST(JointStretch, HasTheAccelerationsOfItsOwnMotion) {
  std::mt19937_64 random{4};
  for (const auto& machine : sample::bundled_machines()) {
    const Model model{machine.definition.chain};
    for (int i = 0; i < 20; ++i) {
      const RandomBlock block{random, model};
      for (const path::Segment* tip :
           {&block.segment(), static_cast<const path::Segment*>(nullptr)}) {
        const JointStretch stretch{model, tip, block.ends(), block.frame(), any_turn};
        const auto demand = stretch.at(0.37);
        if (!demand) continue;
        const auto accelerations = stretch.acceleration(0.37, *demand);
        ASSERT_TRUE(accelerations);
        const PerAxis expected = difference(stretch, 0.37, 1e-4, 2);
        for (std::size_t axis = 0; axis < axis_count; ++axis)
          EXPECT_NEAR((*accelerations)[axis], expected[axis], 2e-5 * largest(expected))
              << machine.definition.name << " axis " << axis;
      }
    }
  }
}

/// The sum of a hundred thousand chords.
TEST(JointStretch, HasTheLengthOfTheTipsPath) {
  std::mt19937_64 random{5};
  const Model model{sample::bundled_machine("hermle-c600u").chain};
  for (int i = 0; i < 5; ++i) {
    const RandomBlock block{random, model};
    const JointStretch stretch{model, nullptr, block.ends(), block.frame(), any_turn};
    constexpr int chords = 100'000;
    double expected_mm = 0.0;
    for (int chord = 0; chord < chords; ++chord)
      expected_mm +=
          (stretch.tip_mm((chord + 1.0) / chords) - stretch.tip_mm(1.0 * chord / chords)).norm();
    EXPECT_NEAR(stretch.length_mm(), expected_mm, 1e-6 * expected_mm);
  }
}

/// A of the C600U is at its pole at 0 and at 180 deg; B from -190 to 190 passes three times.
TEST(JointStretch, TurnsWhereTheSecondJointPassesASingularity) {
  const Model model{sample::bundled_machine("hermle-c600u").chain};
  const path::Segment tip{Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitZ()};
  const JointStretch::Ends ends{{.second_rad = -190.0 * rad_per_deg},
                                {.second_rad = 190.0 * rad_per_deg}};
  const JointStretch stretch{model, &tip, ends, {}, any_turn};
  const auto places = stretch.turning_places();
  const JointStretch back{model, &tip, {ends.to, ends.from}, {}, any_turn};
  EXPECT_NEAR(back.turning_places().at(0), 10.0 / 380.0, 1e-12);
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[0], 10.0 / 380.0, 1e-12);
  EXPECT_NEAR(places[1], 0.5, 1e-12);
  EXPECT_NEAR(places[2], 370.0 / 380.0, 1e-12);
  for (const double place : places) EXPECT_NEAR(stretch.at(place)->opening_sine, 0.0, 1e-12);
}

/// Between the places of the grid no rate leaves the line by more than 0.2 percent of the largest.
TEST(JointStretch, IsResolvedByTheGrid) {
  std::mt19937_64 random{6};
  const Allowance allowance{{}, 1.0};
  for (const auto& machine : sample::bundled_machines()) {
    const Model model{machine.definition.chain};
    for (int i = 0; i < 10; ++i) {
      const RandomBlock block{random, model};
      const JointStretch stretch{model, &block.segment(), block.ends(), block.frame(), any_turn};
      std::vector<Place> places;
      Grid{stretch, 1.0, allowance, false}.fill(places);
      for (std::size_t k = 1; k < places.size(); ++k) {
        const auto middle = stretch.at(0.5 * (places[k - 1].fraction + places[k].fraction));
        ASSERT_TRUE(middle);
        for (std::size_t axis = 0; axis < axis_count; ++axis)
          EXPECT_NEAR(middle->rate[axis],
                      0.5 * (places[k - 1].demand.rate[axis] + places[k].demand.rate[axis]),
                      2e-3 * largest(middle->rate))
              << machine.definition.name;
      }
    }
  }
}

/// Words of thousands of turns cost no more than the turns that are resolved.
TEST(JointStretch, BoundsItsPlaces) {
  const Model model{sample::bundled_machine("hermle-c600u").chain};
  const path::Segment tip{Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitZ()};
  const JointStretch::Ends ends{{}, {.first_rad = 1e6, .second_rad = 1e6}};
  const JointStretch stretch{model, &tip, ends, {}, 4.0 * pi};
  EXPECT_LE(stretch.turning_places().size(), 6U);
  std::vector<Place> places;
  const Allowance allowance{{}, 1.0};
  Grid{stretch, 1.0, allowance, false}.fill(places);
  EXPECT_LE(places.size(), 2000U);
}

}  // namespace
}  // namespace pentapost::analysis
