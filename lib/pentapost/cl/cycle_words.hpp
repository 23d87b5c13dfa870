#pragma once

#include "pentapost/cl/dialects.hpp"
#include "pentapost/cl/length_unit.hpp"
#include "pentapost/cl/words.hpp"
#include "pentapost/core/codes.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pentapost::cl {

/// What a CYCLE statement needs to know of the program before it.
struct CycleContext {
  const ClDialect* dialect = nullptr;
  Units units = Units::mm;
  FeedUnit feed_unit = {};               ///< of a feed without a unit word
  std::optional<double> speed_rpm = {};  ///< of the spindle
  bool spindle_counterclockwise = false;
};

/// A CYCLE statement, read.
struct CycleStatement {
  enum class Action : std::uint8_t { start, off, resume, none, damaged };
  Action action = Action::damaged;
  path::CycleStart cycle = {};
  /// Where the dialect gives heights along the tool axis instead of distances: the height to which
  /// the tool retracts, and how far below it the feed starts.
  std::optional<double> retract_height_mm = {};
  double feed_below_retract_mm = 0.0;
  std::string fault = {};  ///< Action::damaged: why
  Code fault_code = Code::bad_cycle;
  std::vector<std::string> remarks = {};  ///< to be reported as warnings
};

/// Reads the words of a CYCLE by name or by position (depth, feed, clearance; the feed next to its
/// unit word). Lengths in mm.
CycleStatement read_cycle(const Words& words, const CycleContext& context);

/// Most pecks of one hole.
inline constexpr double most_pecks = 1000.0;

}  // namespace pentapost::cl
