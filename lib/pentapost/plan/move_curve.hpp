#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/segment.hpp"
#include "pentapost/plan/axis_path.hpp"

#include <optional>

namespace pentapost::plan {

/// A part of a CL move on which one branch is followed, with the rotary values at its ends.
struct MovePart {
  enum class Kind {
    still,   ///< the rotary axes stand still
    even,    ///< the tool axis rests at the pole while the first axis turns evenly
    branch,  ///< the rotary axes follow the tool axis on one branch
  };
  Kind kind = Kind::still;
  int branch = 0;
  double fraction_from = 0.0, fraction_to = 1.0;  ///< of the whole CL move
  RotaryPair from, to;
  bool in_place = false;  ///< the tool stands still; the fractions only keep the order
};

/// Rotary values inside a part of a move.
///
/// @param segment  the whole CL move; at its poles with the exact direction of the pole.
/// @param lower, upper  values already known around `fraction`; the first axis is unwrapped
///        to the turn nearest to their mean.
/// @return nullopt where the tool axis is out of reach on the way.
std::optional<RotaryPair> rotary_inside(const kinematics::Model& model,
                                        const path::Segment& segment, const MovePart& part,
                                        double fraction, const RotaryPair& lower,
                                        const RotaryPair& upper, double slack_rad);

/// Ends `part` where the first axis meets the end of its range.
///
/// @param rewind_rad  what the first axis is to be moved by there; `part.to` holds after it.
/// @return what is left of the part.
MovePart split_at_limit(const kinematics::Model& model, const path::Segment& segment,
                        const Range<double>& first_range_rad, MovePart& part, double rewind_rad,
                        double slack_rad);

}  // namespace pentapost::plan
