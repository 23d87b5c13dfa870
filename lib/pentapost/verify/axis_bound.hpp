#pragma once

#include "pentapost/verify/block_curve.hpp"

#include <algorithm>

namespace pentapost::verify {

/// Upper bound of the chord between a curve on the unit sphere and a great circle that is run
/// evenly, over a whole interval.
///
/// With r the chord, r'' + kappa r >= -K, where K bounds the tangential acceleration of the curve
/// and kappa = (turn^2 + speed^2) / 2; Sturm's comparison with y'' + kappa y = -K gives r <= (m + K
/// / kappa) / cos(sqrt(kappa) / 2) - K / kappa, m the larger chord of both ends. For kappa <= 1/4
/// the secant is below 1 + 1.05 kappa / 8. Wider intervals: by the speeds alone.
///
/// @param ends_chord  the larger chord of both ends.
/// @param turn_rad  angle of the great circle.
inline double axis_chord_bound(double ends_chord, const BlockCurve::AxisRates& rates,
                               double turn_rad) {
  constexpr double largest_kappa = 0.25;
  constexpr double secant_share = 1.05 / 8.0;
  const double kappa = 0.5 * (turn_rad * turn_rad + rates.speed * rates.speed);
  const double by_speed =
      ends_chord + std::min(0.5 * (rates.speed + turn_rad), rates.reach + turn_rad);
  if (!(kappa <= largest_kappa)) return by_speed;
  return std::min(by_speed, ends_chord + secant_share * (ends_chord * kappa + rates.acceleration));
}

}  // namespace pentapost::verify
