#include "pentapost/plan/retract.hpp"

namespace pentapost::plan {
namespace {

constexpr double least_clearance_mm = 1.0;
constexpr double farthest_retract_mm = 5000.0;
constexpr int bisections = 40;

/// How far the tool can go along its axis: to the end of the travel where the ranges are held,
/// else as far as the control's setting says.
Result<double> clearance_mm(const RetractPlace& place, const RotaryPair& before,
                            const RotaryPair& after, const Settings& settings, bool check_linear,
                            BlockMaker& maker) {
  if (!check_linear) return settings.retract_mm;
  const auto reaches = [&](double distance_mm) {
    const Vec3 tip_mm = place.tip_mm + distance_mm * place.axis;
    return maker.posture(tip_mm, before, place.cl_line).has_value() &&
           maker.posture(tip_mm, after, place.cl_line).has_value();
  };
  if (!reaches(least_clearance_mm))
    return Problem{.code = Code::linear_range,
                   .message = "the tool has to retract at CL line " +
                              std::to_string(place.cl_line) +
                              ", and the linear axes leave no room for it",
                   .cl_line = place.cl_line};
  if (reaches(farthest_retract_mm)) return settings.retract_mm;
  double near_mm = least_clearance_mm, far_mm = farthest_retract_mm;
  for (int i = 0; i < bisections; ++i) {
    const double middle_mm = 0.5 * (near_mm + far_mm);
    (reaches(middle_mm) ? near_mm : far_mm) = middle_mm;
  }
  return near_mm;
}

}  // namespace

std::optional<Posture> posture_above(const RetractPlace& place, const RotaryPair& rotary,
                                     double distance_mm, BlockMaker& maker) {
  while (distance_mm >= least_clearance_mm) {
    auto above = maker.posture(place.tip_mm + distance_mm * place.axis, rotary, place.cl_line);
    if (above) return *std::move(above);
    distance_mm *= 0.5;
  }
  return std::nullopt;
}

Result<Posture> retract_and_reposition(const RetractPlace& place, const RotaryPair& before,
                                       const RotaryPair& after, const Settings& settings,
                                       bool check_linear, BlockMaker& maker, Frame& frame) {
  const auto distance_mm = clearance_mm(place, before, after, settings, check_linear, maker);
  if (!distance_mm) return distance_mm.error();
  const Vec3 clear_mm = place.tip_mm + *distance_mm * place.axis;
  const auto away = maker.posture(clear_mm, before, place.cl_line);
  if (!away) return away.error();
  const auto above = maker.posture(clear_mm, after, place.cl_line);
  if (!above) return above.error();
  const auto back = maker.posture(place.tip_mm, after, place.cl_line);
  if (!back) return back.error();

  const double active_mm_min = frame.feed_mm_min().value_or(0.0);
  const double plunge_mm_min =
      settings.plunge_feed_mm_min > 0.0 ? settings.plunge_feed_mm_min : active_mm_min;
  const auto off_path = [&](const Posture& posture, path::Block::Kind kind) -> path::Block& {
    path::Block& block = frame.add_block(posture, place.point, kind);
    block.on_path = false;
    return block;
  };
  const auto by_feed = [&](const Posture& posture) {
    if (plunge_mm_min <= 0.0) {
      off_path(posture, path::Block::Kind::rapid);
      return;
    }
    path::Block& block = off_path(posture, path::Block::Kind::line);
    block.feed_mode = path::Block::Feed::per_minute;
    block.feed = plunge_mm_min;
  };
  by_feed(*away);
  frame.leave();
  frame.position_rotary(*above, place.point);
  frame.tcp_on();
  off_path(*above, path::Block::Kind::rapid);
  by_feed(*back);
  return *back;
}

}  // namespace pentapost::plan
