#pragma once

#include "pentapost/core/output.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/machine/definition.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace pentapost::nc {

/// A motion block as the control would understand it: where the named axes are at its end.
struct ReadMotion {
  enum class Kind : std::uint8_t { rapid, line, arc, drill };
  enum class Feed : std::uint8_t { none, per_minute, inverse_time };
  /// What a drilling cycle does: pecks with full retracts (deep) or small ones (break_chip),
  /// reverses the spindle at the bottom (taps), leaves at feed (feed_out) or with the spindle
  /// stopped.
  enum class Hole : std::uint8_t {
    drill,
    deep,
    break_chip,
    tap,
    tap_left,
    feed_out,
    spindle_stop,
    other
  };
  Kind kind = Kind::line;
  Feed feed_mode = Feed::none;
  bool tcp = false;            ///< TCP is on
  bool machine_frame = false;  ///< words are machine positions (G53, M91), not program coordinates
  bool tool_length_offset = false;  ///< a length offset is active (other than by TCP)
  std::uint8_t stated = 0;          ///< bit i: column i was written in this block
  std::uint8_t known = 0;           ///< bit i: the position of column i is known at its end
  std::array<double, 5>
      position{};     ///< mm and degrees, modal positions included, order of the letters asked for
  double feed = 0.0;  ///< as active: mm/min (deg/min where only rotary axes move), or 1/min
  /// Where the program's coordinates lie: the selected offset (54 to 59; 5401 and up: G54.1 P1 and
  /// up; 0: the control has only the preset) and the shift that the program itself adds to it.
  /// Positions count from there; a path cut in one clamping keeps both.
  int work_offset = 0;
  std::array<double, 5> datum_shift{};  ///< mm and degrees, order of the letters
  int length_register =
      0;  ///< H of the length offset or of TCP; 0: none, or the control takes the tool's own
  // arcs: in the plane across Z; centre in program coordinates
  double centre_x_mm = 0.0, centre_y_mm = 0.0;
  bool clockwise = false;  ///< seen from +Z
  int whole_turns =
      0;  ///< beyond the way from start to end; a full circle ends where it starts and has 1
  // drill: position is the hole at its bottom
  std::optional<double> travel_z_mm;  ///< level of the way across; nullopt: not known
  double clearance_z_mm = 0.0;        ///< feed starts here
  double retract_z_mm = 0.0;          ///< the tool is here afterwards
  double peck_mm = 0.0;               ///< 0: none
  double dwell_s = 0.0;
  double pitch_mm =
      0.0;  ///< of a tap, > 0 where the program states it and the feed follows from it
  Hole hole = Hole::drill;
  std::string_view cycle;  ///< the cycle's word, "G81"
};

/// Other things that change the state of the machine.
struct ReadTool {
  int number = 0;
};
struct ReadSpindle {
  enum class State : std::uint8_t { off, clockwise, counterclockwise };
  State state = State::off;
  double speed_rpm = 0.0;
};
/// The tool went to the safe end of its travel: the position of the linear axes is not known after
/// it.
struct ReadSafeRetract {};
struct ReadEnd {};

struct ReadItem {
  std::uint32_t text_line = 0;  ///< 1-based line of the NC text
  std::variant<ReadMotion, ReadTool, ReadSpindle, ReadSafeRetract, ReadEnd> what;
};

/// What a reader needs to know of the machine.
struct ReaderSetup {
  std::string letters;            ///< columns of ReadMotion::position ("XYZAC")
  machine::Options options = {};  ///< as the definition has them
};

/// Takes the items in order; a Problem stops the reading and is handed on.
using ItemSink = std::function<Status(const ReadItem&)>;

/// Reads a whole NC program as the control would. Written against the control's manual, not against
/// the writer: no code is shared with nc/dialects. Never crashes or hangs on any bytes.
/// @return Problem (code bad_number, not_in_dialect ...) with the text line in the message.
using ReadProgram = Status (*)(std::string_view text, const ReaderSetup& setup,
                               const ItemSink& sink);

struct Reader {
  std::string_view name;  ///< of the dialect
  ReadProgram read;
};

/// All readers, in alphabetical order of their names.
std::span<const Reader> readers_of_dialects();
/// nullptr: no reader of that name.
const Reader* find_reader(std::string_view name);

}  // namespace pentapost::nc
