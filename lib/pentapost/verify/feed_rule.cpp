#include "pentapost/verify/feed_rule.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>
#include <optional>

namespace pentapost::verify {
namespace {

constexpr double feed_rounding = 1e-6;  ///< relative
/// Half of the last digit of F in a tapping cycle, whose pitch wants the nearest feed.
constexpr double tapping_rounding_mm_min = 0.0005;
/// Half of the last digit of a pitch, and what the division leaves.
constexpr double pitch_rounding_mm = 0.00005 + 1e-9;
constexpr double speed_rounding_rpm = 0.5;
constexpr int tool_of_silent_path = 1;

bool is_usable(double feed) { return std::isfinite(feed) && feed > 0.0; }

std::string too_fast(double found_mm_min, double programmed_mm_min) {
  return "the feed is " + number_text(found_mm_min) + " mm/min, programmed are " +
         number_text(programmed_mm_min) + " mm/min";
}

path::Spindle::State state_of(nc::ReadSpindle::State state) {
  switch (state) {
    case nc::ReadSpindle::State::off:
      return path::Spindle::State::off;
    case nc::ReadSpindle::State::clockwise:
      return path::Spindle::State::clockwise;
    case nc::ReadSpindle::State::counterclockwise:
      return path::Spindle::State::counterclockwise;
  }
  return path::Spindle::State::off;
}

}  // namespace

std::string wrong_feed(const nc::ReadMotion& motion, const FeedCase& feed_case) {
  if (motion.feed_mode == nc::ReadMotion::Feed::none || !is_usable(motion.feed))
    return "a cutting block without a feed";
  if (!feed_case.programmed_mm_min) return {};
  const double programmed = *feed_case.programmed_mm_min;
  double found = 0.0;
  if (motion.feed_mode == nc::ReadMotion::Feed::inverse_time)
    found = motion.feed * feed_case.cl_length_mm;
  else if (feed_case.f_is_tip_speed)
    found = motion.feed;
  if (found <= programmed * (1.0 + feed_rounding)) return {};
  return too_fast(found, programmed);
}

namespace {

/// A thread is its pitch, whatever the feed that the control makes of it.
std::string wrong_pitch(double found_mm, const path::CycleStart& cycle, const ClState& cl) {
  std::optional<double> programmed_mm = cycle.pitch_mm;
  if (!programmed_mm && cl.cycle_feed_mm_min() && cl.speed_rpm())
    programmed_mm = *cl.cycle_feed_mm_min() / *cl.speed_rpm();
  if (!programmed_mm || std::abs(found_mm - *programmed_mm) <= pitch_rounding_mm) return {};
  return "the pitch of a tap is " + number_text(found_mm) + " mm, programmed are " +
         number_text(*programmed_mm) + " mm";
}

}  // namespace

std::string wrong_hole_feed(const nc::ReadMotion& motion, const ClState& cl) {
  if (motion.feed_mode != nc::ReadMotion::Feed::per_minute || !is_usable(motion.feed))
    return "a drilling cycle without a feed per minute";
  const path::CycleStart& cycle = *cl.cycle();
  const bool taps =
      cycle.kind == path::CycleStart::Kind::tap || cycle.kind == path::CycleStart::Kind::tap_left;
  if (taps && motion.pitch_mm > 0.0) return wrong_pitch(motion.pitch_mm, cycle, cl);
  auto programmed = cl.cycle_feed_mm_min();
  if (taps && cycle.pitch_mm && cl.speed_rpm()) programmed = *cycle.pitch_mm * *cl.speed_rpm();
  if (!programmed) return {};
  const double rounding = *programmed * feed_rounding + (taps ? tapping_rounding_mm_min : 0.0);
  if (!(motion.feed <= *programmed + rounding)) return too_fast(motion.feed, *programmed);
  if (taps && !(motion.feed >= *programmed - rounding))
    return "the feed of a tap is " + number_text(motion.feed) + " mm/min, its pitch wants " +
           number_text(*programmed) + " mm/min";
  return {};
}

std::string wrong_setting(const ClState& cl, const std::optional<int>& tool,
                          const nc::ReadSpindle& spindle) {
  const bool tool_is_right = cl.tool() ? tool == cl.tool() : !tool || tool == tool_of_silent_path;
  if (!tool_is_right)
    return "the tool is " + (tool ? std::to_string(*tool) : std::string{"none"}) +
           ", expected is tool " + std::to_string(cl.tool().value_or(tool_of_silent_path));
  if (!cl.spindle()) return {};
  if (state_of(spindle.state) != *cl.spindle())
    return "the spindle does not turn as the CL data says";
  const bool turns = *cl.spindle() != path::Spindle::State::off;
  if (turns && cl.speed_rpm() &&
      !(std::abs(spindle.speed_rpm - *cl.speed_rpm()) <= speed_rounding_rpm))
    return "the spindle turns at " + number_text(spindle.speed_rpm) + " rpm, expected are " +
           number_text(*cl.speed_rpm()) + " rpm";
  return {};
}

std::string wrong_length_register(const ClState& cl, const nc::ReadMotion& motion) {
  if (motion.length_register == 0) return {};
  const int tool = cl.tool().value_or(tool_of_silent_path);
  const int expected = cl.length_register().value_or(tool);
  if (motion.length_register == expected) return {};
  return "the length register is " + std::to_string(motion.length_register) + ", expected is " +
         std::to_string(expected) + " of tool " + std::to_string(tool);
}

}  // namespace pentapost::verify
