#include "pentapost/plan/plain_block.hpp"

#include "machines/bundled.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/plan/linearise.hpp"
#include "sample/chains.hpp"

#include <gtest/gtest.h>

#include <random>

namespace pentapost::plan {
namespace {

constexpr double gauge_mm = 130.0;

struct Deviation {
  double tip_mm = 0.0, axis_rad = 0.0;
};

/// A block and the CL move that it is to stand for.
struct Block {
  Vec3 tip_from_mm, axis_from, tip_to_mm, axis_to;
  Posture from, to;
  PlainBlock::ClMove move() const {
    return {tip_from_mm, axis_from, tip_to_mm, axis_to, (tip_to_mm - tip_from_mm).norm()};
  }
};

/// The great circle between unit vectors, not by path::Segment.
Vec3 on_great_circle(const Vec3& from, const Vec3& to, double share) {
  const double angle_rad = angle_between_rad(from, to);
  if (angle_rad < 1e-9) return (from + share * (to - from)).normalized();
  return (std::sin((1.0 - share) * angle_rad) * from + std::sin(share * angle_rad) * to) /
         std::sin(angle_rad);
}

/// Dense samples of the block by homogeneous matrices straight from the machine's definition.
/// Joint values: the axis is due at the projection of the tip, drawn towards the fraction of the
/// block by what the digits printed leave open. TCP: at the fraction of the block.
Deviation sampled(const machine::Definition& machine, const kinematics::Model& model,
                  const Settings& settings, const Block& block) {
  constexpr int count = 100;
  const double gauge_in_words_mm = model.head_turns ? gauge_mm : 0.0;
  const Vec3 way_mm = block.tip_to_mm - block.tip_from_mm;
  const double resolution_mm = 0.5 * std::sqrt(3.0) * std::pow(10.0, -settings.decimals_mm);
  Deviation largest;
  for (int i = 0; i <= count; ++i) {
    const double s = static_cast<double>(i) / count;
    const auto mixed = [s](double from, double to) { return from + s * (to - from); };
    sample::JointValues values;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = static_cast<Eigen::Index>(k);
      values[model.linear_names[k]] = mixed(block.from.linear_mm[index], block.to.linear_mm[index]);
    }
    values[model.rotary_names[0]] = mixed(block.from.printed.first_rad, block.to.printed.first_rad);
    values[model.rotary_names[1]] =
        mixed(block.from.printed.second_rad, block.to.printed.second_rad);
    const auto pose = sample::pose_by_definition(machine.chain, values, gauge_in_words_mm);
    const bool joints = settings.output == Output::axes;
    const Vec3 tip_mm =
        joints ? pose.tip_mm : Vec3{block.from.tip_mm + s * (block.to.tip_mm - block.from.tip_mm)};
    double reached = s;
    Vec3 nearest_mm = block.tip_from_mm;
    if (way_mm.norm() > 0.0) {
      const double share =
          std::clamp((tip_mm - block.tip_from_mm).dot(way_mm) / way_mm.squaredNorm(), 0.0, 1.0);
      nearest_mm += share * way_mm;
      const double open = resolution_mm / way_mm.norm();
      if (joints) reached = std::clamp(s, share - open, share + open);
    }
    largest.tip_mm = std::max(largest.tip_mm, (tip_mm - nearest_mm).norm());
    largest.axis_rad = std::max(
        largest.axis_rad,
        angle_between_rad(pose.axis, on_great_circle(block.axis_from, block.axis_to, reached)));
  }
  return largest;
}

/// Random blocks: steps of 0.0001 to 0.3 rad, and up to some millimetres, none, or what the turn
/// alone makes; axes of the CL data a little off what the joints reach.
class RandomBlocks {
 public:
  RandomBlocks(const kinematics::Model& model, BlockMaker& maker) : model_{model}, maker_{maker} {}

  std::optional<Block> next() {
    const double step_rad = std::pow(10.0, real(-4.0, -0.5));
    const double way_mm = real(0, 1) < 0.1 ? 0.0 : std::pow(10.0, real(-2.0, 1.0));
    const RotaryPair pair{real(-3, 3), real(-1.5, 1.5)};
    const RotaryPair then{pair.first_rad + step_rad * real(-1, 1),
                          pair.second_rad + step_rad * real(-1, 1)};
    Block block;
    block.tip_from_mm = 100.0 * Vec3{real(-1, 1), real(-1, 1), real(-1, 1)};
    block.tip_to_mm = block.tip_from_mm + way_mm * sample::random_axis(random_);
    if (real(0, 1) < 0.3) {  // the linear joints rest, at zero or elsewhere
      const Vec3 linear_mm = real(0, 1) < 0.5 ? Vec3{Vec3::Zero()} : block.tip_from_mm;
      block.tip_from_mm = tip_at(linear_mm, pair);
      block.tip_to_mm = tip_at(linear_mm, then);
    }
    block.axis_from = axis_near(pair);
    block.axis_to = axis_near(then);
    const auto from = maker_.posture(block.tip_from_mm, pair, 1);
    const auto to = maker_.posture(block.tip_to_mm, then, 1);
    if (!from || !to) return std::nullopt;  // at a linear singularity
    block.from = *from;
    block.to = *to;
    return block;
  }

 private:
  double real(double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random_);
  }
  Vec3 tip_at(const Vec3& linear_mm, const RotaryPair& pair) const {
    return kinematics::forward(model_, {linear_mm, pair.first_rad, pair.second_rad},
                               maker_.gauge_in_words_mm())
        .tip_mm;
  }
  Vec3 axis_near(const RotaryPair& pair) {
    const Vec3 axis = kinematics::forward_axis(model_, pair.first_rad, pair.second_rad);
    return real(0, 1) < 0.5 ? axis : sample::random_axis_at(random_, axis, real(0.0, 1e-4));
  }

  const kinematics::Model& model_;
  BlockMaker& maker_;
  std::mt19937_64 random_{2024};
};

/// Just below what samples find the block is refused; with ten times as much most are not.
void expect_never_below_samples(Output output) {
  int accepted = 0, blocks = 0;
  for (const auto& bundled : sample::bundled_machines()) {
    const machine::Definition& machine = bundled.definition;
    const kinematics::Model model{machine.chain};
    if (model.rotary_count != 2) continue;
    Settings settings;
    settings.output = output;
    const JointRanges ranges;
    BlockMaker maker{model, ranges, settings, gauge_mm, false};
    const PlainBlock plain{model, settings, maker};
    RandomBlocks random{model, maker};
    for (int i = 0; i < 400; ++i) {
      const auto block = random.next();
      if (!block) continue;
      ++blocks;
      const Deviation truth = sampled(machine, model, settings, *block);
      const auto suffices = [&](double tip_mm, double axis_rad) {
        settings.tip_tolerance_mm = tip_mm / tolerance_share;
        settings.axis_tolerance_rad = axis_rad / tolerance_share;
        return plain.suffices(block->move(), block->from, block->to);
      };
      // Words can be exact: then there is nothing below.
      EXPECT_FALSE(truth.tip_mm > 1e-9 && suffices(truth.tip_mm * (1.0 - 1e-6), 10.0))
          << machine.name << ' ' << i;
      EXPECT_FALSE(suffices(1e9, truth.axis_rad * (1.0 - 1e-6))) << machine.name << ' ' << i;
      accepted += suffices(10.0 * truth.tip_mm, 10.0 * truth.axis_rad);
    }
  }
  EXPECT_GT(blocks, 4000);
  EXPECT_GT(accepted, blocks / 2);
}

TEST(PlainBlock, OfJointValuesIsNeverBelowWhatSamplesFind) {
  expect_never_below_samples(Output::axes);
}
TEST(PlainBlock, WithTcpIsNeverBelowWhatSamplesFind) { expect_never_below_samples(Output::tcp); }

class PlainBlockOnTrunnion : public ::testing::Test {
 protected:
  PlainBlockOnTrunnion() {
    // Whatever can be bounded is within these.
    settings_.tip_tolerance_mm = 1e9;
    settings_.axis_tolerance_rad = 10.0;
  }
  bool suffices(const RotaryPair& from, const RotaryPair& to, const Vec3& way_mm = {1, 0, 0}) {
    BlockMaker maker{model_, ranges_, settings_, 0.0, false};
    const Vec3 start_mm{30, 0, 0}, end_mm = start_mm + way_mm;
    const auto axis = [&](const RotaryPair& pair) {
      return kinematics::forward_axis(model_, pair.first_rad, pair.second_rad);
    };
    const Vec3 axis_from = axis(from), axis_to = axis(to);
    return PlainBlock{model_, settings_, maker}.suffices(
        {start_mm, axis_from, end_mm, axis_to, way_mm.norm()},
        maker.posture(start_mm, from, 1).value(), maker.posture(end_mm, to, 1).value());
  }

  const kinematics::Model model_{sample::trunnion_ac()};
  const JointRanges ranges_;
  Settings settings_;
};

TEST_F(PlainBlockOnTrunnion, AcceptsWhatIsWithinWideTolerances) {
  EXPECT_TRUE(suffices({0.1, 0.2}, {0.6, 0.3}));
}

/// At the pole a whole turn of C leaves the tool axis where it is; the bound does not see it.
TEST_F(PlainBlockOnTrunnion, RefusesLargeTurnsOfTheJoints) {
  EXPECT_FALSE(suffices({0.0, 0.0}, {2.0 * pi, 0.0}));
  EXPECT_FALSE(suffices({0.0, 0.3}, {0.6, 0.8}));
}

TEST_F(PlainBlockOnTrunnion, RefusesLargeTurnsOfTheToolAxis) {
  BlockMaker maker{model_, ranges_, settings_, 0.0, false};
  const Vec3 start_mm{0, 0, 0}, end_mm{1, 0, 0}, up = Vec3::UnitZ(), across = Vec3::UnitY();
  const Posture from = maker.posture(start_mm, {}, 1).value();
  const Posture to = maker.posture(end_mm, {}, 1).value();
  const PlainBlock plain{model_, settings_, maker};
  EXPECT_TRUE(plain.suffices({start_mm, up, end_mm, up, 1.0}, from, to));
  EXPECT_FALSE(plain.suffices({start_mm, up, end_mm, across, 1.0}, from, to));
}

TEST_F(PlainBlockOnTrunnion, RefusesWhatIsNotANumber) {
  BlockMaker maker{model_, ranges_, settings_, 0.0, false};
  const double none = std::numeric_limits<double>::quiet_NaN();
  const Vec3 start_mm{0, 0, 0}, end_mm{1, 0, 0}, up = Vec3::UnitZ(), bad{none, 0, 1};
  const Posture from = maker.posture(start_mm, {}, 1).value();
  const Posture to = maker.posture(end_mm, {}, 1).value();
  const PlainBlock plain{model_, settings_, maker};
  EXPECT_FALSE(plain.suffices({start_mm, up, end_mm, bad, 1.0}, from, to));
  EXPECT_FALSE(plain.suffices({bad, up, end_mm, up, 1.0}, from, to));
  EXPECT_FALSE(plain.suffices({start_mm, up, end_mm, up, 1.0}, from,
                              {.word = to.word, .printed = {none, 0.0}, .axis = to.axis}));
}

/// Without TCP a resting tip, 30 mm beside C, leaves its place by 30 (1 - cos(5 deg)) = 0.114 mm in
/// the middle of a turn by 10 deg.
TEST_F(PlainBlockOnTrunnion, OfATurnInPlaceSeesTheSagitta) {
  settings_.output = Output::axes;
  const RotaryPair from{0.0, 0.5}, to{10.0 * rad_per_deg, 0.5};
  settings_.tip_tolerance_mm = 0.114;
  EXPECT_FALSE(suffices(from, to, Vec3::Zero()));
  settings_.tip_tolerance_mm = 1.0;
  EXPECT_TRUE(suffices(from, to, Vec3::Zero()));
  settings_.output = Output::tcp;
  settings_.tip_tolerance_mm = 0.002;
  EXPECT_TRUE(suffices(from, to, Vec3::Zero()));
}

/// Whether one block in which only the first rotary joint turns, by 0.2 rad, with the linear joints
/// at zero, keeps 1 mm: the tip leaves its chord by arm * (1 - cos 0.1) = arm / 200.
bool turn_of_an_arm_suffices(const machine::Chain& chain, double second_rad, double length_mm) {
  const kinematics::Model model{chain};
  const JointRanges ranges;
  Settings settings;
  settings.output = Output::axes;
  settings.tip_tolerance_mm = 1.0;
  settings.axis_tolerance_rad = 10.0;
  BlockMaker maker{model, ranges, settings, length_mm, false};
  const auto pose = [&](double first_rad) {
    return kinematics::forward(model, {Vec3::Zero(), first_rad, second_rad}, length_mm);
  };
  const auto from = pose(0.0), to = pose(0.2);
  return PlainBlock{model, settings, maker}.suffices(
      {from.tip_mm, from.axis, to.tip_mm, to.axis, (to.tip_mm - from.tip_mm).norm()},
      maker.posture(from.tip_mm, {0.0, second_rad}, 1).value(),
      maker.posture(to.tip_mm, {0.2, second_rad}, 1).value());
}

TEST(PlainBlock, SeesTheArmOfTheGaugeLength) {
  const auto head = sample::chain_of(
      {}, {sample::x(), sample::y(), sample::z(), sample::rotary("C", Vec3::UnitZ()),
           sample::rotary("B", Vec3::UnitY())});
  EXPECT_TRUE(turn_of_an_arm_suffices(head, pi / 2.0, 50.0));
  EXPECT_FALSE(turn_of_an_arm_suffices(head, pi / 2.0, 210.0));
}

TEST(PlainBlock, SeesTheArmBetweenTheRotaryAxes) {
  const auto table = [](double offset_mm) {
    return sample::chain_of(
        {sample::rotary("C", Vec3::UnitZ(), {offset_mm, 0, 0}), sample::rotary("A", Vec3::UnitX())},
        {sample::x(), sample::y(), sample::z()});
  };
  EXPECT_TRUE(turn_of_an_arm_suffices(table(50.0), 0.0, 0.0));
  EXPECT_FALSE(turn_of_an_arm_suffices(table(210.0), 0.0, 0.0));
}

}  // namespace
}  // namespace pentapost::plan
