#pragma once

#include "pentapost/path/segment.hpp"
#include "pentapost/verify/block_curve.hpp"

namespace pentapost::verify {

/// The part of a CL move that one block covers.
struct MovePart {
  const path::Segment& move;
  double from_fraction = 0.0;  ///< 0 <= from_fraction <= to_fraction <= 1
  double to_fraction = 1.0;
  /// How far the tip's place on the move is known: half the last digit printed, over three axes.
  double tip_resolution_mm = 0.0;
};

/// How far a block leaves its CL move. The axis is held as a chord: the distance of unit vectors,
/// 2 sin(angle / 2), which grows with the angle and keeps all digits of small ones.
struct Deviation {
  double tip_mm = 0.0;
  double axis_chord = 0.0;
};

double chord_of_angle(double angle_rad);  ///< 0 to pi
double angle_of_chord(double chord);      ///< chords above 2 count as 2

/// Largest deviation over the whole of a block, proven for every s and not sampled.
///
/// Tip: distance to the tip's path, restricted to the part. Axis: distance to the great-circle axis
/// at the fraction of the move that the block has reached. In TCP blocks that is the fraction of
/// the block. Where the joints run evenly it is the projection of the tip on the move, drawn
/// towards the fraction of the block by at most tip_resolution_mm / length: where the tip all but
/// stands still the projection is a matter of the digits printed.
///
/// @param from, to  curve.at(0) and curve.at(1).
/// @param proven  what is known to occur elsewhere: a block that stays below is not searched
/// further.
/// @param limit  what is allowed; the search goes on until a block is within or beyond it.
/// @return an upper bound, at least `proven`, above the true maximum by at most 0.1 % of it or 0.1
/// %
///         of the limit; beyond the limit a value that was reached (or, in blocks of thousands of
///         turns, that could not be excluded). NaN where a place of the block is not finite.
Deviation largest_deviation(const BlockCurve& curve, const Station& from, const Station& to,
                            const MovePart& part, const Deviation& proven, const Deviation& limit);

/// A quick upper bound for a whole straight CL move in one block: no search, no trigonometry.
/// Infinite where the move turns too far for it.
/// @param cl_from_mm, cl_to_mm, axis_from, axis_to  the CL move.
Deviation quick_bound(const BlockCurve& curve, const Station& from, const Station& to,
                      const Vec3& cl_from_mm, const Vec3& axis_from, const Vec3& cl_to_mm,
                      const Vec3& axis_to, double tip_resolution_mm);

}  // namespace pentapost::verify
