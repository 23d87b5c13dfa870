#include "pentapost/analysis/joint_analysis.hpp"

#include "pentapost/kinematics/inverse.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pentapost::analysis {
namespace {

constexpr int tool_of_silent_program = 1;
/// Every block is resolved over so much of its turn; one that turns farther over so much beyond, as
/// long as all blocks of a program together have not used up theirs. Bounds memory and time for
/// words of thousands of turns.
constexpr double free_turn_rad = 4.0 * pi;
constexpr double most_block_turn_rad = 100.0 * 2.0 * pi;
constexpr double most_program_turn_rad = 2'000.0 * 2.0 * pi;

bool turns(const kinematics::Joints& from, const kinematics::Joints& to) {
  return from.first_rad != to.first_rad || from.second_rad != to.second_rad;
}

double time_s(const JointMove& move, const JointStretch::Ends& ends, double length_mm) {
  switch (move.feed_rule) {
    case JointMove::Feed::tip:
      return 60.0 * length_mm / move.feed;
    case JointMove::Feed::axes:
      return 60.0 *
             std::hypot((ends.to.linear_mm - ends.from.linear_mm).norm(),
                        (ends.to.first_rad - ends.from.first_rad) * deg_per_rad,
                        (ends.to.second_rad - ends.from.second_rad) * deg_per_rad) /
             move.feed;
    case JointMove::Feed::inverse_time:
      break;
  }
  return 60.0 / move.feed;
}

}  // namespace

JointAnalysis::JointAnalysis(const kinematics::Model& model, const plan::Settings& settings,
                             const AnalysisOptions& options)
    : model_{model},
      settings_{settings},
      recorder_{model, settings, options},
      turn_allowance_rad_{most_program_turn_rad} {
  frame_.origin_mm = settings.origin_mm;
  use_tool(tool_of_silent_program);
}

void JointAnalysis::use_tool(int number) {
  interrupt();
  recorder_.begin_operation(number, {});
  const auto gauge = settings_.gauge_length_mm.find(number);
  frame_.gauge_length_mm = gauge == settings_.gauge_length_mm.end() ? 0.0 : gauge->second;
}

void JointAnalysis::interrupt() {
  recorder_.interrupt();
  posture_.reset();
  met_.reset();
}

void JointAnalysis::begin(const JointPosture& posture) {
  interrupt();
  posture_ = posture;
}

Status JointAnalysis::move(const JointMove& move) {
  if (move.kind == JointMove::Kind::rapid) {
    s_mm_ += (move.to.tip_mm - posture_->tip_mm).norm();
    reposition(Repositioning::Kind::rapid, move);
  } else if (auto status = cut(move); !status) {
    return status;
  }
  posture_ = move.to;
  return ok();
}

void JointAnalysis::reposition(Repositioning::Kind kind, const JointMove& move) {
  met_.reset();
  recorder_.reposition(kind, {move.block, move.line, s_mm_, move.to.tip_mm}, joints(*posture_),
                       joints(move.to));
}

std::optional<PerAxis> JointAnalysis::joints(const JointPosture& posture) const {
  kinematics::Joints joints = posture.joints;
  if (posture.words_are_tip) {
    const auto linear =
        kinematics::inverse_linear(model_, posture.tip_mm + frame_.origin_mm, joints.first_rad,
                                   joints.second_rad, frame_.gauge_length_mm);
    if (!linear) return std::nullopt;
    joints.linear_mm = *linear;
  }
  return per_axis(joints);
}

Status JointAnalysis::cut(const JointMove& move) {
  const JointStretch::Ends ends{posture_->joints, move.to.joints};
  const bool words_are_tip = move.to.words_are_tip;
  const path::Segment straight{posture_->tip_mm, Vec3::UnitZ(), move.to.tip_mm, Vec3::UnitZ()};
  const path::Segment* tip = move.arc != nullptr ? move.arc : words_are_tip ? &straight : nullptr;
  const double turn_rad = JointStretch::turn_rad(tip, ends);
  const JointStretch stretch{
      model_, tip, ends, frame_, resolved_turn_rad(turn_rad), met_ ? &*met_ : nullptr};
  const double length_mm = stretch.length_mm();
  if (stands_still(stretch, ends, words_are_tip, length_mm)) {
    if (turns(ends.from, ends.to)) reposition(Repositioning::Kind::turn_in_place, move);
    return ok();
  }
  if (!(move.feed > 0.0))
    return Problem{
        .code = Code::no_feed,
        .message = "NC text line " + std::to_string(move.line) + ": a cutting motion has no feed"};
  const SurveyedMove surveyed{.point = move.block,
                              .line = move.line,
                              .s_from_mm = s_mm_,
                              .length_mm = length_mm,
                              .time_s = time_s(move, ends, length_mm)};
  if (!recorder_.cut(stretch, surveyed)) recorder_.interrupt();
  recorder_.account(surveyed);
  s_mm_ += length_mm;
  met_.reset();
  if (stretch.at_end()) met_.emplace(*stretch.at_end());
  return ok();
}

bool JointAnalysis::stands_still(const JointStretch& stretch, const JointStretch::Ends& ends,
                                 bool words_are_tip, double length_mm) const {
  if (!(length_mm > 0.0)) return true;
  if (words_are_tip || !turns(ends.from, ends.to)) return false;
  // Half of the last digit at either end, over three axes.
  const double digits_mm = std::sqrt(3.0) * std::pow(10.0, -settings_.decimals_mm);
  const double way_mm = (stretch.tip_mm(1.0) - stretch.tip_mm(0.0)).norm();
  return way_mm <= digits_mm && length_mm <= 2.0 * settings_.tip_tolerance_mm + digits_mm;
}

double JointAnalysis::resolved_turn_rad(double turn_rad) {
  const double extra_rad =
      std::clamp(turn_rad - free_turn_rad, 0.0, std::min(most_block_turn_rad, turn_allowance_rad_));
  turn_allowance_rad_ -= extra_rad;
  return free_turn_rad + extra_rad;
}

}  // namespace pentapost::analysis
