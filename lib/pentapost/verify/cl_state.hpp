#pragma once

#include "pentapost/path/tool_path.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace pentapost::verify {

/// The statements of the CL data that are in force on the way to a point. Refers to the tool path.
class ClState {
 public:
  explicit ClState(const path::ToolPath& tool_path) : tool_path_{&tool_path} {}

  /// Takes all events before the move to `point`, which must not go back.
  /// @return whether tool or spindle may have changed.
  bool advance_to(std::uint32_t point);

  /// nullopt: the CL data gives none, or one per revolution without a spindle speed.
  std::optional<double> feed_mm_min() const;
  /// Of a hole: the cycle's own, or the one in force.
  std::optional<double> cycle_feed_mm_min() const;
  /// nullopt: no tool change yet.
  const std::optional<int>& tool() const { return tool_; }
  /// Of the tool in use; nullopt: the CL data names none.
  const std::optional<int>& length_register() const { return length_register_; }
  /// nullopt: no spindle statement yet.
  const std::optional<path::Spindle::State>& spindle() const { return spindle_; }
  const std::optional<double>& speed_rpm() const { return speed_rpm_; }
  /// The tool comes to the point from a tool change or from home: there is no way from the point
  /// before.
  bool starts_anew() const { return starts_anew_; }
  /// The arc of the move to the point; nullptr: a line.
  const path::Arc* arc() const { return arc_; }
  /// nullptr: no cycle is on.
  const path::CycleStart* cycle() const { return cycle_; }

 private:
  void take(const path::Event& event);

  const path::ToolPath* tool_path_;
  std::size_t next_event_ = 0;
  std::uint32_t point_ = 0;
  bool has_new_setting_ = false;
  bool starts_anew_ = false;
  const path::FeedRate* feed_ = nullptr;
  const path::Arc* arc_ = nullptr;
  const path::CycleStart* cycle_ = nullptr;
  std::optional<int> tool_;
  std::optional<int> length_register_;
  std::optional<path::Spindle::State> spindle_;
  std::optional<double> speed_rpm_;
};

}  // namespace pentapost::verify
