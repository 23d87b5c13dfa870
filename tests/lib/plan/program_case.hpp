#pragma once

#include "sample/chains.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/plan/program.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

/// Tool paths in, outlines of the planned program out: one line an action or a block.
namespace pentapost::sample {

/// A job for plan_program(), with a tool path to be filled.
struct ProgramCase {
  explicit ProgramCase(const machine::Chain& chain, Output output = Output::tcp)
      : model{chain}, ranges{plan::joint_ranges(chain, model)} {
    settings.output = output;
    settings.preferences.tilt = machine::Preferences::Tilt::positive;
  }

  void event(path::EventKind what) { path.add_event(++line, std::move(what)); }
  void feed_rate(double mm_min) { event(path::FeedRate{.value = mm_min}); }
  void point(const Vec3& tip_mm, const Vec3& axis = Vec3::UnitZ(),
             path::Move how = path::Move::feed) {
    path.add_point(tip_mm, axis.normalized(), ++line, how);
  }
  void rapid(const Vec3& tip_mm, const Vec3& axis = Vec3::UnitZ()) {
    point(tip_mm, axis, path::Move::rapid);
  }
  Result<plan::Program> planned() const {
    return plan::plan_program(model, ranges, path, settings);
  }

  kinematics::Model model;
  plan::JointRanges ranges;
  plan::Settings settings;
  path::ToolPath path;
  std::uint32_t line = 0;  ///< of the last statement; statements count from 1
};

inline std::string action_text(const path::ActionKind& what) {
  struct Visitor {
    std::string operator()(const path::ToolCall& call) const {
      return "tool " + std::to_string(call.number) +
             (call.length_register ? " H" + std::to_string(*call.length_register) : "") +
             (call.speed_rpm ? " S" + number_text(*call.speed_rpm) : "");
    }
    std::string operator()(const path::Spindle& spindle) const {
      using State = path::Spindle::State;
      if (spindle.state == State::off) return "spindle off";
      return (spindle.state == State::clockwise ? "spindle right S" : "spindle left S") +
             number_text(spindle.speed_rpm.value_or(0.0));
    }
    std::string operator()(const path::Coolant& coolant) const {
      return coolant.state == path::Coolant::State::off ? "coolant off" : "coolant on";
    }
    std::string operator()(const path::Dwell& dwell) const {
      return "dwell " + number_text(dwell.time_s);
    }
    std::string operator()(const path::Stop&) const { return "stop"; }
    std::string operator()(const path::Comment& comment) const { return "(" + comment.text + ")"; }
    std::string operator()(const path::InsertedText& text) const { return text.text; }
    std::string operator()(const path::ArcCentre& centre) const {
      return "centre " + std::to_string(centre.i) + " " + std::to_string(centre.j);
    }
    std::string operator()(const path::TcpOn&) const { return "tcp on"; }
    std::string operator()(const path::TcpOff&) const { return "tcp off"; }
    std::string operator()(const path::SafeRetract&) const { return "safe retract"; }
    std::string operator()(const path::NativeCycle& cycle) const {
      return "cycle R" + std::to_string(cycle.clearance_z) + " Z" + std::to_string(cycle.bottom_z) +
             " Q" + std::to_string(cycle.peck) + " P" + number_text(cycle.dwell_s) + " F" +
             number_text(cycle.feed_mm_min);
    }
    std::string operator()(const path::NativeCycleEnd&) const { return "cycle end"; }
    std::string operator()(const path::ProgramEnd&) const { return "end"; }
  };
  return std::visit(Visitor{}, what);
}

inline std::string block_text(const path::Motion& motion, const path::Block& block) {
  using Kind = path::Block::Kind;
  std::string text = block.kind == Kind::rapid           ? "rapid"
                     : block.kind == Kind::line          ? "line"
                     : block.kind == Kind::drill         ? "drill"
                     : block.kind == Kind::arc_clockwise ? "arc right"
                                                         : "arc left";
  for (std::size_t i = 0; i < motion.letters.size(); ++i)
    if (((block.stated >> i) & 1U) != 0U)
      text += std::string{" "} + motion.letters[i] +
              number_text(decimal_value(block.word[i], motion.decimals(i)));
  if (block.feed_mode == path::Block::Feed::per_minute) text += " F" + number_text(block.feed, 3);
  if (block.feed_mode == path::Block::Feed::inverse_time) text += " T" + number_text(block.feed, 3);
  return text + (block.on_path ? "" : " off path");
}

/// The program in the order in which the control meets it.
inline std::vector<std::string> outline(const path::Motion& motion) {
  std::vector<std::string> lines;
  std::size_t next = 0;
  for (std::uint32_t i = 0; i <= motion.blocks.size(); ++i) {
    for (; next < motion.actions.size() && motion.actions[next].before_block <= i; ++next)
      lines.push_back(action_text(motion.actions[next].what));
    if (i < motion.blocks.size()) lines.push_back(block_text(motion, motion.blocks[i]));
  }
  return lines;
}

/// The outline of the program, or what keeps it from being planned.
inline std::vector<std::string> planned_outline(const ProgramCase& job) {
  const auto program = job.planned();
  if (!program) return {program.error().message};
  return outline(program->motion);
}

}  // namespace pentapost::sample
