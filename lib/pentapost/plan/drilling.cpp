#include "pentapost/plan/drilling.hpp"

#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/plan/sequences.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace pentapost::plan {
namespace {

constexpr double direction_tolerance = 1e-9;
constexpr std::size_t z_column = 2;

bool drills_along_z(const kinematics::Model& model, const Settings& settings) {
  if (!settings.native_cycles || model.head_turns || settings.output != Output::axes) return false;
  const Mat3 directions =
      model.linear_columns[0] + model.linear_columns[1] + model.linear_columns[2];
  return (directions.col(z_column) - model.t).norm() <= direction_tolerance;
}

bool can_be_native(const path::CycleStart& cycle) {
  using Kind = path::CycleStart::Kind;
  const bool level_fits = !cycle.retract_mm || *cycle.retract_mm == cycle.clearance_mm;
  const bool pecks_known =
      (cycle.kind != Kind::deep && cycle.kind != Kind::break_chip) || cycle.peck_mm;
  const bool dwell_known = cycle.dwell_s == 0.0 || cycle.kind == Kind::face;
  return level_fits && pecks_known && dwell_known;
}

/// Along Z alone, which is the drilling axis.
void rise(const Posture& from, std::int64_t z, std::uint32_t point, Frame& frame) {
  Posture above = from;
  above.word[z_column] = z;
  path::Block& block = frame.add_block(above, point, path::Block::Kind::rapid);
  block.stated = 1U << z_column;
  block.on_path = false;
}

/// A tap's feed follows from its pitch; nullopt: the CL data give none.
std::optional<double> feed_of_hole(const path::CycleStart& cycle, const Frame& frame) {
  using Kind = path::CycleStart::Kind;
  const bool taps = cycle.kind == Kind::tap || cycle.kind == Kind::tap_left;
  if (taps && cycle.pitch_mm && frame.speed_rpm()) return *cycle.pitch_mm * *frame.speed_rpm();
  return cycle.feed_mm_min ? cycle.feed_mm_min : frame.feed_mm_min();
}

/// Whether a way along Z alone keeps to the hole: not where the tool axis lies beyond the reach by
/// too much for its depth, or the digits are too coarse for it.
bool keeps_tolerance(const kinematics::Model& model, const path::CycleStart& cycle,
                     const Vec3& axis, const Settings& settings) {
  const double beyond_rad = std::max(0.0, kinematics::inverse_rotary(model, axis, pi).beyond_rad);
  const double digits_rad = std::sqrt(0.5) * std::pow(10.0, -settings.decimals_deg) * rad_per_deg;
  const double digits_mm = std::sqrt(3.0) * std::pow(10.0, -settings.decimals_mm);
  const double length_mm = cycle.depth_mm + cycle.clearance_mm;
  return length_mm * (beyond_rad + digits_rad) + digits_mm <= settings.tip_tolerance_mm;
}

}  // namespace

std::function<bool(std::uint32_t point)> native_holes(const kinematics::Model& model,
                                                      const path::ToolPath& tool_path,
                                                      const Settings& settings) {
  if (!drills_along_z(model, settings)) return [](std::uint32_t) { return false; };
  std::vector<bool> native(tool_path.size(), false);
  std::size_t next_event = 0;
  const path::CycleStart* open = nullptr;
  for (std::uint32_t point = 0; point < tool_path.size(); ++point) {
    for (;
         next_event < tool_path.events.size() && tool_path.events[next_event].before_point <= point;
         ++next_event)
      if (const auto* cycle = std::get_if<path::CycleStart>(&tool_path.events[next_event].what))
        open = can_be_native(*cycle) ? cycle : nullptr;
    native[point] = open != nullptr && tool_path.move[point] == path::Move::hole &&
                    keeps_tolerance(model, *open, tool_path.axis_wp[point], settings);
  }
  for (const Sequence& sequence : sequences(tool_path)) native[sequence.range.begin] = false;
  return [native = std::move(native)](std::uint32_t point) { return native[point]; };
}

Result<Posture> drill(const path::ToolPath& tool_path, std::uint32_t point, const Posture& from,
                      const RotaryPair& rotary, bool rotary_moves, BlockMaker& maker,
                      Frame& frame) {
  const path::CycleStart& cycle = *frame.cycle();
  const Vec3& axis = tool_path.axis_wp[point];
  const std::uint32_t line = tool_path.cl_line[point];
  const auto level = [&](double above_mm) {
    return maker.posture(tool_path.tip_wp_mm[point] + above_mm * axis, rotary, line);
  };
  const auto bottom = level(-cycle.depth_mm);
  if (!bottom) return bottom.error();
  const auto clear = level(cycle.clearance_mm);
  if (!clear) return clear.error();
  const auto feed_mm_min = feed_of_hole(cycle, frame);
  if (!feed_mm_min)
    return Problem{.code = Code::no_feed,
                   .message = "the hole at CL line " + std::to_string(line) + " has no feed",
                   .cl_line = line};
  if (rotary_moves) {
    // A table that turns under the tool would swing the part into it.
    frame.leave();
    frame.approach(*clear, std::nullopt, point, false).on_path = false;
  } else if (clear->word[z_column] > from.word[z_column]) {
    rise(from, clear->word[z_column], point, frame);
  }
  path::NativeCycle native;
  native.kind = cycle.kind;
  native.clearance_z = clear->word[z_column];
  native.bottom_z = bottom->word[z_column];
  native.clearance = maker.count_mm(cycle.clearance_mm);
  if (cycle.peck_mm) native.peck = std::max<std::int64_t>(1, maker.count_mm(*cycle.peck_mm));
  native.dwell_s = cycle.dwell_s;
  native.feed_mm_min = *feed_mm_min;
  frame.start_cycle(native, line);
  path::Block& block = frame.add_block(*bottom, point, path::Block::Kind::drill);
  block.feed_mode = path::Block::Feed::per_minute;
  block.feed = native.feed_mm_min;
  return *clear;
}

}  // namespace pentapost::plan
