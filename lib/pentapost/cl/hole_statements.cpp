#include "pentapost/cl/interpreter.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::cl {
namespace {

/// Moves that the holes of a file may need in all when they are written as single moves.
constexpr double most_expanded_moves = 2e7;

double moves_of(const path::CycleStart& cycle) {
  return 6.0 + (cycle.peck_mm ? 3.0 * std::ceil(cycle.depth_mm / *cycle.peck_mm) : 0.0);
}

}  // namespace

void Interpreter::end_cycle() {
  if (cycle_is_on_ && cycle_is_written_) path_.add_event(line_, path::CycleEnd{});
  cycle_is_on_ = false;
  cycle_is_written_ = false;
}

void Interpreter::cycle(const Major& major) {
  drop_arc();
  words_.read(major.rest);
  const CycleContext context{&dialect_, units_, feed_unit_, spindle_.speed_rpm,
                             spindle_.state == path::Spindle::State::counterclockwise};
  CycleStatement found = read_cycle(words_, context);
  for (const std::string& remark : found.remarks)
    report(Severity::warning, Code::bad_cycle, [&] { return remark; });
  switch (found.action) {
    case CycleStatement::Action::none:
      return;
    case CycleStatement::Action::off:
      return end_cycle();
    case CycleStatement::Action::damaged:
      end_cycle();
      return report(Severity::error, found.fault_code, [&] {
        return "The cycle " + quoted_excerpt(statement_->text) + " is not usable: " + found.fault +
               ".";
      });
    case CycleStatement::Action::resume:
      if (!cycle_) return report_damage(Severity::error, Code::bad_cycle, "a cycle before it");
      break;
    case CycleStatement::Action::start:
      for (const Word& word : words_)
        if (const auto unit = feed_unit(word)) check_feed_unit(*unit, word.text);
      cycle_ = std::move(found);
      break;
  }
  end_cycle();
  cycle_is_on_ = true;
  cycle_line_ = line_;
}

/// Completes the cycle for a hole whose clearance is a height and whose GOTO may be its bottom.
bool Interpreter::place_hole(const Vec3& tip_mm, Vec3& top_mm) {
  path::CycleStart& cycle = cycle_->cycle;
  top_mm = tip_mm;
  if (dialect_.hole_point == HolePoint::bottom) top_mm += cycle.depth_mm * axis_;
  if (!cycle_->retract_height_mm) return true;
  const double retract_mm = *cycle_->retract_height_mm - top_mm.dot(axis_);
  const double clearance_mm = retract_mm - cycle_->feed_below_retract_mm;
  if (clearance_mm < -1e-6) {
    report(Severity::error, Code::bad_cycle, [&] {
      return "The clearance of the cycle at CL line " + std::to_string(cycle_line_) + " is " +
             number_text(-clearance_mm, 4) + " mm below the top of this hole.";
    });
    return false;
  }
  // One cycle serves holes whose heights differ by no more than rounding.
  constexpr double same_mm = 1e-6;
  const bool is_same = std::abs(cycle.clearance_mm - clearance_mm) < same_mm &&
                       std::abs(cycle.retract_mm.value_or(-1.0) - retract_mm) < same_mm;
  if (cycle_is_written_ && !is_same) {
    path_.add_event(line_, path::CycleEnd{});
    cycle_is_written_ = false;
  }
  if (!is_same) {
    cycle.clearance_mm = std::max(0.0, clearance_mm);
    cycle.retract_mm = std::max(0.0, retract_mm);
  }
  return true;
}

void Interpreter::add_hole(const Vec3& tip_mm) {
  Vec3 top_mm;
  if (!place_hole(tip_mm, top_mm)) return;
  expanded_moves_ += moves_of(cycle_->cycle);
  if (expanded_moves_ > most_expanded_moves) {
    report(Severity::error, Code::too_large,
           [] { return std::string{"The holes of the file need more than 2e7 moves in all."}; });
    return;
  }
  if (!cycle_is_written_) path_.add_event(cycle_line_, cycle_->cycle);
  cycle_is_written_ = true;
  path_.add_point(top_mm, axis_, line_, path::Move::hole);
}

}  // namespace pentapost::cl
