#pragma once

#include "pentapost/nc/reader.hpp"
#include "pentapost/verify/cl_state.hpp"

#include <optional>
#include <string>

namespace pentapost::verify {

/// What a cutting block does, as far as its feed is concerned.
struct FeedCase {
  std::optional<double> programmed_mm_min = {};  ///< of the CL data; nullopt: none is given
  double cl_length_mm = 0.0;                     ///< of the part of the move that the block covers
  bool f_is_tip_speed =
      false;  ///< per minute: F is the speed of the tip (TCP, or no rotary axis turns)
};

/// What is wrong with the feed of a cutting block; empty: nothing. It may be lower than programmed,
/// never higher.
std::string wrong_feed(const nc::ReadMotion& motion, const FeedCase& feed_case);

/// The same for a hole of the cycle in force.
std::string wrong_hole_feed(const nc::ReadMotion& motion, const ClState& cl);

/// What is wrong with tool or spindle against the CL data in force; empty: nothing.
/// @param tool  as called by the program; nullopt: none was.
/// @param spindle  as switched by the program.
std::string wrong_setting(const ClState& cl, const std::optional<int>& tool,
                          const nc::ReadSpindle& spindle);

/// What is wrong with the length register of a block, which must be that of the CL data's tool or
/// bear its number; empty: nothing, or the control takes the tool's own.
std::string wrong_length_register(const ClState& cl, const nc::ReadMotion& motion);

}  // namespace pentapost::verify
