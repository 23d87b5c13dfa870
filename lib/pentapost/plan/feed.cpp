#include "pentapost/plan/feed.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {
namespace {

std::optional<double> speed_limit(const Settings& settings, const std::string& name) {
  const auto found = settings.limits.find(name);
  return found == settings.limits.end() ? std::nullopt : found->second.max_speed;
}

}  // namespace

FeedRule::FeedRule(const kinematics::Model& model, const Settings& settings,
                   const WordColumns& columns)
    : settings_{settings}, columns_{columns} {
  for (std::size_t i = 0; i < 3; ++i)
    linear_mm_s_[i] = speed_limit(settings, model.linear_names[i]);
  for (std::size_t i = 0; i < 2; ++i)
    rotary_rad_s_[i] = speed_limit(settings, model.rotary_names[i]);
}

double FeedRule::axis_time_min(const Posture& from, const Posture& to) const {
  double time_s = 0.0;
  const auto take = [&](double way, const std::optional<double>& speed) {
    if (speed) time_s = std::max(time_s, std::abs(way) / *speed);
  };
  take(to.printed.first_rad - from.printed.first_rad, rotary_rad_s_[0]);
  take(to.printed.second_rad - from.printed.second_rad, rotary_rad_s_[1]);
  if (settings_.output == Output::axes)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto index = static_cast<Eigen::Index>(i);
      take(to.linear_mm[index] - from.linear_mm[index], linear_mm_s_[i]);
    }
  return time_s / 60.0;
}

Status FeedRule::set(path::Block& block, const Posture& from, const Posture& to, double length_mm,
                     std::optional<double> feed_mm_min) const {
  const bool tip_still =
      length_mm == 0.0 || (settings_.output == Output::tcp && from.tip_mm == to.tip_mm);
  const bool rotary_still = from.printed == to.printed;
  if (tip_still && !rotary_still) return set_in_place(block, from, to);
  if (!feed_mm_min)
    return Problem{.code = Code::no_feed,
                   .message = "the cutting move to CL line " + std::to_string(block.cl_line) +
                              " has no feed; a FEDRAT before it is needed",
                   .cl_line = block.cl_line};
  set_per_minute(block, *feed_mm_min);
  if (const double least = std::pow(10.0, -settings_.feed_decimals); *feed_mm_min < least)
    return Problem{.code = Code::out_of_domain,
                   .message = "the feed of " + number_text(*feed_mm_min) + " mm/min at CL line " +
                              std::to_string(block.cl_line) + " is below the " +
                              number_text(least) + " mm/min that the control can be given",
                   .cl_line = block.cl_line};
  if (settings_.output == Output::tcp || rotary_still) return ok();

  const double time_min = std::max(length_mm / *feed_mm_min, axis_time_min(from, to));
  if (settings_.inverse_time) {
    set_inverse_time(block, time_min);
    return ok();
  }
  // Without inverse time a control takes millimetres and degrees alike along the way of all axes.
  const double linear_mm = (to.linear_mm - from.linear_mm).norm();
  const double first_deg = (to.printed.first_rad - from.printed.first_rad) * deg_per_rad;
  const double second_deg = (to.printed.second_rad - from.printed.second_rad) * deg_per_rad;
  set_per_minute(block, std::hypot(linear_mm, first_deg, second_deg) / time_min);
  return ok();
}

void FeedRule::set_per_minute(path::Block& block, double feed) const {
  block.feed_mode = path::Block::Feed::per_minute;
  block.feed = settings_.largest_feed > 0.0 ? std::min(feed, settings_.largest_feed) : feed;
}

void FeedRule::set_inverse_time(path::Block& block, double time_min) const {
  const double largest = settings_.largest_inverse_time;
  block.feed_mode = path::Block::Feed::inverse_time;
  block.feed = largest > 0.0 ? std::min(1.0 / time_min, largest) : 1.0 / time_min;
}

/// The tip stands still: the block takes the time that the limits of the axes need.
Status FeedRule::set_in_place(path::Block& block, const Posture& from, const Posture& to) const {
  const double first_rad = to.printed.first_rad - from.printed.first_rad;
  const double second_rad = to.printed.second_rad - from.printed.second_rad;
  double time_min = axis_time_min(from, to);
  const bool limits_known =
      (first_rad == 0.0 || rotary_rad_s_[0]) && (second_rad == 0.0 || rotary_rad_s_[1]);
  if (!limits_known) {
    if (!(settings_.rotary_feed_rad_min > 0.0))
      return Problem{.code = Code::no_rotary_feed,
                     .message = "the tool turns in place at CL line " +
                                std::to_string(block.cl_line) +
                                "; the speed limits of the rotary axes or the option "
                                "rotary_feed_deg_min are needed for its feed",
                     .cl_line = block.cl_line};
    time_min =
        std::max(time_min, std::hypot(first_rad, second_rad) / settings_.rotary_feed_rad_min);
  }
  // With TCP the control's own feed per minute serves: degrees a minute where the tip rests.
  if (settings_.inverse_time && settings_.output == Output::axes) {
    set_inverse_time(block, time_min);
    return ok();
  }
  const double linear_mm =
      settings_.output == Output::axes ? (to.linear_mm - from.linear_mm).norm() : 0.0;
  set_per_minute(
      block, std::hypot(linear_mm, first_rad * deg_per_rad, second_rad * deg_per_rad) / time_min);
  return ok();
}

}  // namespace pentapost::plan
