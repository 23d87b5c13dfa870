#pragma once

#include "pentapost/core/units.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pentapost::path {

/// How the tool gets to a point.
enum class Move : std::uint8_t {
  feed,   ///< tool tip on a straight line (or the Arc event before it), tool axis on the great
          ///< circle
  rapid,  ///< at rapid rate; only the end point counts
  hole,   ///< a hole of the cycle that is on: the point is the hole's reference point
};

struct FeedRate {
  enum class Unit : std::uint8_t { mm_min, mm_per_revolution };
  double value = 0.0;  ///< > 0, in `unit`
  Unit unit = Unit::mm_min;
};

struct Spindle {
  enum class State : std::uint8_t { off, clockwise, counterclockwise };
  State state = State::off;
  std::optional<double> speed_rpm = {};  ///< nullopt: the speed that was set before
};

struct Coolant {
  enum class State : std::uint8_t { off, flood, mist, through, air };
  State state = State::off;
};

/// A tool change. What is not said is nullopt.
struct ToolChange {
  int number = 0;
  std::optional<int> length_register = {};
  std::string name = {};  ///< as CAM names it, may be empty
};

/// Geometry of the tool in use, from CUTTER, TLDATA and the like.
struct ToolData {
  std::optional<double> diameter_mm = {};
  std::optional<double> corner_radius_mm = {};
  std::optional<double> length_mm = {};
};

/// The move to the next point is an arc (or a helix, or whole turns) about an axis.
struct Arc {
  Vec3 centre_wp_mm = Vec3::Zero();
  Vec3 normal_wp = Vec3::UnitZ();  ///< unit; the tool runs right-handed about it
  double sweep_rad = 0.0;  ///< > 0, from the point before to the next point, whole turns included
};

/// A canned cycle is on from here: every point with Move::hole is a hole.
struct CycleStart {
  enum class Kind : std::uint8_t {
    drill,
    face,
    deep,
    break_chip,
    tap,
    tap_left,
    bore,
    bore_drag,
    ream
  };
  Kind kind = Kind::drill;
  double depth_mm =
      0.0;  ///< > 0, from the reference point into the material, against the tool axis
  double clearance_mm =
      0.0;  ///< >= 0, feed starts this far above the reference point (RAPTO, CLEAR)
  std::optional<double> retract_mm =
      {};  ///< above the reference point after each hole; nullopt: clearance
  std::optional<double> peck_mm = {};      ///< > 0, depth of one peck; deep and break_chip
  double dwell_s = 0.0;                    ///< >= 0, at the bottom
  std::optional<double> feed_mm_min = {};  ///< nullopt: the feed that is active
  std::optional<double> pitch_mm = {};     ///< tapping; nullopt: feed / speed
};
struct CycleEnd {};

struct Dwell {
  double time_s = 0.0;  ///< > 0
};
struct Stop {
  bool optional = false;
};
struct Comment {
  std::string text;
};
/// Text for the NC program as it stands (INSERT).
struct InsertedText {
  std::string text;
};
/// Start of a named operation (TOOL PATH, OPERATION NAME, FEATNO).
struct Operation {
  std::string name;
};
/// Move to the machine's home position (GOHOME).
struct GoHome {};

/// Where the tool starts (FROM); no motion.
struct StartPoint {
  Vec3 tip_wp_mm = Vec3::Zero();
  Vec3 axis_wp = Vec3::UnitZ();
};

using EventKind =
    std::variant<FeedRate, Spindle, Coolant, ToolChange, ToolData, Arc, CycleStart, CycleEnd, Dwell,
                 Stop, Comment, InsertedText, Operation, GoHome, StartPoint>;

/// What happens between two points.
struct Event {
  std::uint32_t before_point =
      0;  ///< takes effect before the move to this point; size(): after the last
  std::uint32_t cl_line = 0;  ///< 1-based
  EventKind what;
};

/// CL data as the machine-independent stages see it: columns for the motion, one record an event.
/// Lengths are mm whatever the CL file's unit. Frame: workpiece (CL coordinates).
struct ToolPath {
  std::vector<Vec3> tip_wp_mm;         ///< tool tip
  std::vector<Vec3> axis_wp;           ///< tool axis vector, unit, tip towards spindle
  std::vector<std::uint32_t> cl_line;  ///< 1-based line of the statement
  std::vector<Move> move;              ///< how the tool gets there
  std::vector<Event> events;           ///< in order of before_point, then as in the file

  std::string program_name;  ///< PARTNO; may be empty
  double axis_rounding_rad =
      0.0;  ///< two units in the last place of the axis components as written
  bool has_tool_change = false;

  std::size_t size() const noexcept { return tip_wp_mm.size(); }
  void reserve(std::size_t points) {
    tip_wp_mm.reserve(points);
    axis_wp.reserve(points);
    cl_line.reserve(points);
    move.reserve(points);
  }
  void add_point(const Vec3& tip_mm, const Vec3& axis, std::uint32_t line, Move how) {
    tip_wp_mm.push_back(tip_mm);
    axis_wp.push_back(axis);
    cl_line.push_back(line);
    move.push_back(how);
  }
  /// Adds an event that takes effect before the next point to be added.
  void add_event(std::uint32_t line, EventKind what) {
    events.push_back({static_cast<std::uint32_t>(size()), line, std::move(what)});
  }
};

}  // namespace pentapost::path
