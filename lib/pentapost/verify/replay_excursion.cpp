#include "pentapost/core/number_text.hpp"
#include "pentapost/verify/replay.hpp"

namespace pentapost::verify {
namespace {

/// Tips of the same words differ by arithmetic alone.
constexpr double same_words_mm = 1e-9;

ToolPlace place_of(const Stop& stop) { return {stop.station.tip_mm, stop.station.axis}; }

bool rotary_words_differ(const Stop& from, const Stop& to) {
  return from.joints.first_rad != to.joints.first_rad ||
         from.joints.second_rad != to.joints.second_rad;
}

}  // namespace

void Replay::leave_path() {
  if (excursion_.is_active()) return;
  const Stop& now = position_.now();
  if (entered_ && now.placed)
    excursion_.begin(place_of(now));
  else
    excursion_.begin(std::nullopt);
}

bool Replay::off_path(const nc::ReadMotion& motion, const path::Block& block) {
  const bool is_rapid =
      motion.kind == nc::ReadMotion::Kind::rapid || block.kind == path::Block::Kind::rapid;
  if (motion.kind != nc::ReadMotion::Kind::rapid && motion.kind != nc::ReadMotion::Kind::line)
    return fail("an arc or a cycle off the path");
  if (motion.kind == nc::ReadMotion::Kind::line && !(motion.feed > 0.0))
    return fail("a feed move without a feed");
  const Stop &from = position_.before(), &to = position_.now();
  if (!from.placed || !to.placed) {
    excursion_.take_unknown();
    return true;
  }
  const bool turns = rotary_words_differ(from, to);
  const Excursion::Slack slack{.tip_mm = 2.0 * tip_resolution_mm_ + same_words_mm,
                               .axis_rad = claim_.axis_tolerance_rad + axis_resolution_rad_};
  const bool stays = turns && excursion_.is_at_left(place_of(from), slack.tip_mm) &&
                     excursion_.is_at_left(place_of(to), slack.tip_mm);
  // Rapids need not be straight: with joint values their tip is not proven.
  if (stays && !(is_rapid && to.meaning == Meaning::joints) && turns_in_place(*excursion_.left()))
    return true;
  const auto wrong = excursion_.take(place_of(from), place_of(to), !turns, !is_rapid, slack);
  return !wrong || fail("the tool " + *wrong);
}

/// Where the tool axis is parallel to the first rotary axis, that axis may turn in the cut.
bool Replay::turns_in_place(const ToolPlace& left) {
  const path::Segment standing{left.tip_mm, left.axis, left.tip_mm, left.axis};
  const Deviation found = largest_deviation(
      curve(), position_.before().station, position_.now().station,
      {.move = standing, .tip_resolution_mm = tip_resolution_mm_}, held_.proven, held_.limit);
  const Deviation& limit = held_.limit;
  return found.tip_mm <= limit.tip_mm && found.axis_chord <= limit.axis_chord && prove(found);
}

bool Replay::come_back() {
  if (!excursion_.is_active()) return true;
  const auto& left = excursion_.left();
  if (left) {
    // Tips of TCP words come back by the same words; joint values turn out otherwise where the
    // rotary axes do.
    const double slack_mm =
        same_words_mm + (claim_.output == Output::tcp ? 0.0 : 2.0 * tip_resolution_mm_);
    const double off_mm = (position_.before().station.tip_mm - left->tip_mm).norm();
    if (!(off_mm <= slack_mm))
      return fail("the cut goes on " + number_text(off_mm, 9) +
                  " mm from the place where it was left");
    if (excursion_.wrong_for_return())
      return fail("before this cut the tool " + *excursion_.wrong_for_return());
  }
  excursion_.end();
  return true;
}

}  // namespace pentapost::verify
