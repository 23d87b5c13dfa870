#pragma once

#include "pentapost/path/tool_path.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pentapost::analysis {

/// What the CL data have set for the move to a point. Refers to the tool path.
class ClSetting {
 public:
  explicit ClSetting(const path::ToolPath& tool_path) : events_{tool_path.events} {}

  /// Takes the events before the move to `point`, which must not go back.
  void advance_to(std::uint32_t point);
  /// nullopt: there is none, or one per revolution without a spindle speed.
  std::optional<double> feed_mm_min() const;
  const path::Arc* arc() const { return arc_; }                    ///< nullptr: a straight move
  const path::Operation* operation() const { return operation_; }  ///< nullptr: none yet

 private:
  const std::vector<path::Event>& events_;
  std::size_t next_ = 0;
  std::optional<path::FeedRate> feed_;
  std::optional<double> speed_rpm_;
  const path::Arc* arc_ = nullptr;
  const path::Operation* operation_ = nullptr;
};

}  // namespace pentapost::analysis
