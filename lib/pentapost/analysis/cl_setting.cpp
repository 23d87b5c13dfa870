#include "pentapost/analysis/cl_setting.hpp"

#include <variant>

namespace pentapost::analysis {

void ClSetting::advance_to(std::uint32_t point) {
  arc_ = nullptr;
  for (; next_ < events_.size() && events_[next_].before_point <= point; ++next_) {
    const path::EventKind& what = events_[next_].what;
    if (const auto* feed = std::get_if<path::FeedRate>(&what)) feed_ = *feed;
    if (const auto* spindle = std::get_if<path::Spindle>(&what); spindle && spindle->speed_rpm)
      speed_rpm_ = spindle->speed_rpm;
    if (const auto* operation = std::get_if<path::Operation>(&what)) operation_ = operation;
    if (events_[next_].before_point == point)
      if (const auto* arc = std::get_if<path::Arc>(&what)) arc_ = arc;
  }
}

std::optional<double> ClSetting::feed_mm_min() const {
  if (!feed_) return std::nullopt;
  if (feed_->unit == path::FeedRate::Unit::mm_min) return feed_->value;
  if (!speed_rpm_) return std::nullopt;
  return feed_->value * *speed_rpm_;
}

}  // namespace pentapost::analysis
