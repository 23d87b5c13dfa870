#include "pentapost/verify/cl_state.hpp"

#include <variant>

namespace pentapost::verify {

bool ClState::advance_to(std::uint32_t point) {
  if (point != point_) {
    arc_ = nullptr;
    starts_anew_ = false;
  }
  point_ = point;
  const auto& events = tool_path_->events;
  if (next_event_ == events.size() || events[next_event_].before_point > point) return false;
  has_new_setting_ = false;
  for (; next_event_ < events.size() && events[next_event_].before_point <= point; ++next_event_)
    take(events[next_event_]);
  return has_new_setting_;
}

void ClState::take(const path::Event& event) {
  if (const auto* feed = std::get_if<path::FeedRate>(&event.what)) {
    feed_ = feed;
  } else if (const auto* spindle = std::get_if<path::Spindle>(&event.what)) {
    spindle_ = spindle->state;
    if (spindle->speed_rpm) speed_rpm_ = spindle->speed_rpm;
    has_new_setting_ = true;
  } else if (const auto* change = std::get_if<path::ToolChange>(&event.what)) {
    if (tool_ != change->number) starts_anew_ = starts_anew_ || event.before_point == point_;
    if (tool_ != change->number || change->length_register)
      length_register_ = change->length_register;
    tool_ = change->number;
    has_new_setting_ = true;
  } else if (std::holds_alternative<path::GoHome>(event.what)) {
    starts_anew_ = starts_anew_ || event.before_point == point_;
  } else if (const auto* arc = std::get_if<path::Arc>(&event.what)) {
    arc_ = event.before_point == point_ ? arc : nullptr;
  } else if (const auto* cycle = std::get_if<path::CycleStart>(&event.what)) {
    cycle_ = cycle;
  } else if (std::holds_alternative<path::CycleEnd>(event.what)) {
    cycle_ = nullptr;
  }
}

std::optional<double> ClState::feed_mm_min() const {
  if (feed_ == nullptr) return std::nullopt;
  if (feed_->unit == path::FeedRate::Unit::mm_min) return feed_->value;
  if (!speed_rpm_) return std::nullopt;
  return feed_->value * *speed_rpm_;
}

std::optional<double> ClState::cycle_feed_mm_min() const {
  if (cycle_ != nullptr && cycle_->feed_mm_min) return cycle_->feed_mm_min;
  return feed_mm_min();
}

}  // namespace pentapost::verify
