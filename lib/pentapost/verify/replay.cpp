#include "pentapost/verify/replay.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::verify {
namespace {

/// Rounding of the comparison with a tolerance.
constexpr double tolerance_rounding = 1e-9;
/// Words of shops do not go beyond; squares of them stay exact enough for the bounds.
constexpr double largest_word = 1e9;

template <class... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

Deviation limit_of(const Claim& claim, double axis_rad) {
  return {claim.tip_tolerance_mm * (1.0 + tolerance_rounding),
          chord_of_angle(std::min(axis_rad, pi)) * (1.0 + tolerance_rounding)};
}

double half_digit(int decimals) { return 0.5 * std::pow(10.0, -decimals); }

}  // namespace

Replay::Replay(const Claim& claim, const AxisColumns& columns)
    : claim_{claim},
      columns_{columns},
      shape_{claim.model},
      position_{shape_, columns, claim.output, claim.origin_mm},
      coverage_{claim.tool_path.size()},
      cl_{claim.tool_path},
      held_{limit_of(claim, claim.axis_tolerance_rad), {}},
      held_near_pole_{limit_of(claim, claim.axis_tolerance_rad + claim.pole_axis_rad), {}},
      tip_resolution_mm_{half_digit(claim.motion.decimals_mm) * std::sqrt(3.0)},
      axis_resolution_rad_{half_digit(claim.motion.decimals_deg) * rad_per_deg * std::sqrt(2.0)} {}

bool Replay::fail(const std::string& what) {
  problem_.message = "NC text line " + std::to_string(text_line_);
  if (proof_.blocks_read > 0)
    problem_.message += ", motion block " + std::to_string(proof_.blocks_read);
  if (cl_line_ != 0) {
    problem_.message += " (CL line " + std::to_string(cl_line_) + ')';
    problem_.cl_line = cl_line_;
  }
  problem_.message += ": " + what;
  return false;
}

Status Replay::take(const nc::ReadItem& item) {
  text_line_ = item.text_line;
  const bool proven =
      std::visit(Overloaded{[this](const nc::ReadMotion& motion) { return take_motion(motion); },
                            [this](const nc::ReadTool& tool) {
                              leave_by_machine_words(AxisColumns::linear);
                              tool_ = tool.number;
                              length_register_ = 0;
                              settings_are_new_ = true;
                              return true;
                            },
                            [this](const nc::ReadSpindle& spindle) {
                              spindle_ = spindle;
                              settings_are_new_ = true;
                              return true;
                            },
                            [this](const nc::ReadSafeRetract&) {
                              leave_by_machine_words(AxisColumns::linear);
                              return true;
                            },
                            [this](const nc::ReadEnd&) {
                              ended_ = true;
                              return true;
                            }},
                 item.what);
  if (proven) return ok();
  return std::move(problem_);
}

void Replay::leave_by_machine_words(std::uint8_t columns) {
  leave_path();
  excursion_.take_unknown();
  position_.lose(columns);
}

bool Replay::take_motion(const nc::ReadMotion& motion) {
  if (ended_) return fail("motion after the end of the program");
  if (motion.machine_frame) {
    if (motion.kind != nc::ReadMotion::Kind::rapid)
      return fail("a feed move to a machine position");
    leave_by_machine_words(motion.stated);
    return true;
  }
  const auto& blocks = claim_.motion.blocks;
  if (proof_.blocks_read == blocks.size()) {
    cl_line_ = 0;
    return fail("a motion block more than the " + std::to_string(blocks.size()) +
                " that were planned");
  }
  const path::Block& block = blocks[proof_.blocks_read++];
  if (claim_.keep_text_lines) proof_.text_lines.push_back(text_line_);
  cl_line_ = block.point < claim_.tool_path.size() ? claim_.tool_path.cl_line[block.point] : 0;
  if (!is_sane(motion) || !keeps_datum(motion) || !keeps_length_register(motion)) return false;
  // The place where the path is left is the one before this block.
  if (!block.on_path) leave_path();
  position_.go(motion, gauge_length_mm());
  count_spans(motion);
  if (!block.on_path) return off_path(motion, block);
  const auto covered = coverage_.advance(block);
  if (!covered) return fail(covered.error().message);
  return on_path(motion, *covered);
}

bool Replay::is_sane(const nc::ReadMotion& motion) {
  for (std::size_t column = 0; column < columns_.count(); ++column)
    if (!(std::abs(motion.position[column]) <= largest_word))
      return fail("a position that is not finite or beyond all bounds");
  if (!std::isfinite(motion.feed)) return fail("a feed that is not finite");
  return true;
}

bool Replay::keeps_datum(const nc::ReadMotion& motion) {
  if (!work_offset_) {
    work_offset_ = motion.work_offset;
    datum_shift_ = motion.datum_shift;
  }
  if (motion.work_offset == *work_offset_ && motion.datum_shift == datum_shift_) return true;
  return fail("the work offset or datum shift changes within the program");
}

/// Blocks off the path are held against the CL data by the next one on it.
bool Replay::keeps_length_register(const nc::ReadMotion& motion) {
  if (motion.length_register == 0) return true;
  if (length_register_ == 0) length_register_ = motion.length_register;
  if (motion.length_register == length_register_) return true;
  return fail("the length register changes from " + std::to_string(length_register_) + " to " +
              std::to_string(motion.length_register) + " without a tool call");
}

void Replay::widen(std::size_t column, double word) {
  AxisSpan& span = proof_.spans[column];
  const auto bit = static_cast<std::uint8_t>(1U << column);
  if ((spanned_ & bit) == 0) span = {word, word};
  spanned_ |= bit;
  span.min = std::min(span.min, word);
  span.max = std::max(span.max, word);
}

void Replay::count_spans(const nc::ReadMotion& motion) {
  const Stop& now = position_.now();
  for (std::size_t column = 0; column < columns_.count(); ++column)
    if ((now.known >> column & 1U) != 0) widen(column, now.words[column]);
  if (motion.kind != nc::ReadMotion::Kind::drill) return;
  if (const auto z = columns_.find('Z')) {
    if (std::isfinite(motion.clearance_z_mm)) widen(*z, motion.clearance_z_mm);
    if (std::isfinite(motion.retract_z_mm)) widen(*z, motion.retract_z_mm);
  }
}

Result<Proof> Replay::finish() {
  cl_line_ = 0;
  const std::size_t planned = claim_.motion.blocks.size();
  if (proof_.blocks_read != planned) {
    fail("the program has " + std::to_string(proof_.blocks_read) + " motion blocks of " +
         std::to_string(planned) + " that were planned");
    return std::move(problem_);
  }
  if (!ended_) {
    fail("the program does not end");
    return std::move(problem_);
  }
  const Status covered = coverage_.finish();
  if (!covered) {
    fail(covered.error().message);
    return std::move(problem_);
  }
  const Deviation &usual = held_.proven, &near_pole = held_near_pole_.proven;
  proof_.tip_deviation_mm = std::max(usual.tip_mm, near_pole.tip_mm);
  proof_.axis_deviation_rad = angle_of_chord(std::max(usual.axis_chord, near_pole.axis_chord));
  return std::move(proof_);
}

}  // namespace pentapost::verify
