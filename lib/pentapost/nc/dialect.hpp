#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/machine/definition.hpp"
#include "pentapost/path/motion.hpp"

#include <span>
#include <string>
#include <string_view>

namespace pentapost::nc {

/// One setting that shops change, in a definition's controller.options.
struct OptionRow {
  std::string_view name;
  machine::OptionValue default_value;
  std::string_view description;
};

/// What the planning needs to know of a control before a word is written. From the options.
struct Abilities {
  int decimals_mm = 3;
  int decimals_deg = 3;
  int feed_decimals = 0;      ///< of feeds per minute
  double largest_feed = 0.0;  ///< largest F per minute, 0: no bound known
  bool inverse_time =
      false;  ///< false: feed of a rotary move without TCP by the control's own rule
  double largest_inverse_time = 0.0;  ///< largest F in 1/min, 0: no bound known
  bool adds_length_always = false;  ///< without TCP the control adds the length of the tool in use,
                                    ///< whatever the program says
  bool arcs = false;                ///< G02/G03 in the plane across Z
  bool helices = false;             ///< arcs that move along Z as well
  bool arcs_with_tcp = false;       ///< arcs while TCP is on
  bool native_cycles = false;       ///< canned drilling cycles
  /// TCP ends after the safe retract: its end may move the axes by the tool length.
  bool retracts_with_tcp = false;
  bool retract_needs_tool = false;  ///< no safe retract before the first tool call
  bool rapid_is_straight = false;   ///< rapids are written as straight moves
  double rapid_feed_mm_min = 0.0;   ///< of such rapids
  double rotary_feed_deg_min =
      0.0;  ///< feed for turning in place where no axis limit gives one; 0: none
  double retract_mm =
      100.0;  ///< along the tool axis before a repositioning, where no travel bounds it
  double plunge_feed_mm_min = 0.0;  ///< back to the point left; 0: the feed that is active
};

/// A control's language. One immutable value each, in nc/dialects/<name>.cpp.
struct Dialect {
  std::string_view name;  ///< as in machine definitions and GET /dialects
  std::string_view title;
  std::span<const OptionRow> options;

  /// Checks options (names, types, domains) and gives what the control can do with them.
  Result<Abilities> (*abilities)(const machine::Options& options);

  /// The NC text of `motion`. Deterministic. Appends to `out`; on a Problem `out` is to be dropped.
  Status (*write)(const path::Motion& motion, const path::ProgramHeader& header,
                  const machine::Options& options, std::string& out);
};

/// All dialects, in alphabetical order of their names.
std::span<const Dialect* const> dialects();
/// nullptr: there is none of that name.
const Dialect* find_dialect(std::string_view name);

}  // namespace pentapost::nc
