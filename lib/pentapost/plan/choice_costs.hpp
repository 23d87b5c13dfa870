#pragma once

namespace pentapost::plan {

// Costs by which the ways of the rotary axes are compared, in seconds: each is far above all that
// the one below it can add up to.
inline constexpr double retract_in_air_s = 1e8;
inline constexpr double retract_in_cut_s = retract_in_air_s + 1e5;
inline constexpr double inside_move_s = 1e3;  ///< a cut inside a move rather than at a point
inline constexpr double wrong_tilt_s = 1e4;
inline constexpr double outside_window_s = 1e3;  ///< a turn

}  // namespace pentapost::plan
