#pragma once

#include "pentapost/core/output.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/path/tool_path.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pentapost::path {

/// One motion block of the NC program: where every axis is at its end.
struct Block {
  enum class Kind : std::uint8_t { rapid, line, arc_clockwise, arc_counterclockwise, drill };
  enum class Feed : std::uint8_t { none, per_minute, inverse_time };

  /// Words in the order of Motion::letters, in counts of the last digit printed.
  std::array<std::int64_t, 5> word{};
  double feed = 0.0;  ///< mm/min (deg/min where only rotary axes move), or 1/min for inverse_time
  double fraction =
      1.0;  ///< where on the CL move to `point` this block ends, in (0, 1]; 1: at the point
  std::uint32_t point = 0;    ///< index of the CL point whose move this block belongs to
  std::uint32_t cl_line = 0;  ///< of that point
  Kind kind = Kind::line;
  Feed feed_mode = Feed::none;
  std::uint8_t stated = 0x1F;  ///< bit i: word i must be written (others stay where they are)
  bool on_path = true;         ///< false: retract, repositioning, approach; leaves the CL path
};

/// Words of an arc block, mm counts: centre relative to the start point of the block.
struct ArcCentre {
  std::int64_t i = 0, j = 0;
};
struct TcpOn {};
struct TcpOff {};
/// Tool to the safe upper end of the tool-axis travel, by the dialect's own word (G28, M140 MB
/// MAX).
struct SafeRetract {};
/// The drilling cycle that block `drill` and those after it run; levels are Z words, mm counts.
struct NativeCycle {
  CycleStart::Kind kind = CycleStart::Kind::drill;
  std::int64_t clearance_z = 0;  ///< R level
  std::int64_t bottom_z = 0;
  std::int64_t peck = 0;  ///< 0: none
  double dwell_s = 0.0;
  double feed_mm_min = 0.0;
  bool retract_to_clearance = true;  ///< false: to the level before the cycle (G98)
  std::int64_t clearance =
      0;  ///< of clearance_z above the surface, for controls that take both; 0: not said

  /// The same levels are the same hole, wherever its surface is said to be.
  bool operator==(const NativeCycle& other) const {
    return kind == other.kind && clearance_z == other.clearance_z && bottom_z == other.bottom_z &&
           peck == other.peck && dwell_s == other.dwell_s && feed_mm_min == other.feed_mm_min &&
           retract_to_clearance == other.retract_to_clearance;
  }
};
struct NativeCycleEnd {};
struct ToolCall {
  int number = 0;
  std::optional<int> length_register = {};
  std::optional<double> speed_rpm =
      {};  ///< of the spindle statement that follows, for controls that call with S
  std::string name = {};
};
struct ProgramEnd {};

using ActionKind =
    std::variant<ToolCall, Spindle, Coolant, Dwell, Stop, Comment, InsertedText, ArcCentre, TcpOn,
                 TcpOff, SafeRetract, NativeCycle, NativeCycleEnd, ProgramEnd>;

/// What the NC program does between two motion blocks.
struct Action {
  std::uint32_t before_block = 0;  ///< index into Motion::blocks; blocks.size(): after the last
  std::uint32_t cl_line = 0;       ///< 0: not from the CL data
  ActionKind what;
};

/// The whole NC program, control-independent: what `nc` writes and what `verify` holds it against.
struct Motion {
  std::string
      letters;  ///< one word letter a column: linear axes first, then rotary, each A to Z ("XYZAC")
  int decimals_mm = 3;
  int decimals_deg = 3;
  Output output = Output::tcp;
  bool length_offset =
      true;  ///< axes output: the control adds the tool's length to the words (G43)
  std::vector<Block> blocks;
  std::vector<Action> actions;  ///< in order of before_block

  int decimals(std::size_t column) const { return column < 3 ? decimals_mm : decimals_deg; }
};

/// What stands at the head of the program.
struct ProgramHeader {
  std::string program_name;
  std::string machine;       ///< name@version
  std::string machine_hash;  ///< first digits of the definition's sha256
  std::vector<std::string> comments;
};

}  // namespace pentapost::path
