#include "pentapost/analysis/spans.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::analysis {
namespace {

/// Where the rate along the cubic through two places vanishes, and the cubic's value there.
struct Turning {
  double share;  ///< of the way between both
  double joint;
};

/// @param rate_from, rate_to  per way between both, of opposite sense.
Turning turning(double from, double to, double rate_from, double rate_to) {
  // rate(s) = rate_from + 2 (3 way - 2 rate_from - rate_to) s + 3 (rate_from + rate_to - 2 way) s^2
  const double way = to - from;
  const double half_linear = 3.0 * way - 2.0 * rate_from - rate_to;
  const double square = 3.0 * (rate_from + rate_to - 2.0 * way);
  const double root = std::sqrt(std::max(0.0, half_linear * half_linear - square * rate_from));
  // The root where the rate goes from the sense of rate_from to the other one.
  const double share = -rate_from / (half_linear + std::copysign(root, -rate_from));
  const double square_term = half_linear, cubic_term = rate_from + rate_to - 2.0 * way;
  return {share, from + share * (rate_from + share * (square_term + share * cubic_term))};
}

}  // namespace

void Spans::take(const PerAxis& joints) {
  if (!spans_) {
    spans_.emplace();
    for (std::size_t i = 0; i < axis_count; ++i) (*spans_)[i] = {joints[i], joints[i]};
    return;
  }
  for (std::size_t i = 0; i < axis_count; ++i) widen(i, joints[i]);
}

void Spans::take(const std::vector<Place>& places) {
  for (std::size_t k = 0; k < places.size(); ++k) {
    take(places[k].demand.joints);
    if (k == 0) continue;
    const Demand &from = places[k - 1].demand, &to = places[k].demand;
    const double length = places[k].fraction - places[k - 1].fraction;
    for (std::size_t i = 0; i < axis_count; ++i) {
      double way = std::abs(to.joints[i] - from.joints[i]);
      if (from.rate[i] * to.rate[i] < 0.0) {
        const Turning found =
            turning(from.joints[i], to.joints[i], length * from.rate[i], length * to.rate[i]);
        if (found.share > 0.0 && found.share < 1.0) {
          widen(i, found.joint);
          way = std::abs(found.joint - from.joints[i]) + std::abs(to.joints[i] - found.joint);
        }
      }
      travel_[i] += way;
    }
  }
}

void Spans::widen(std::size_t axis, double joint) {
  Range<double>& span = (*spans_)[axis];
  span.lower = std::min(span.lower, joint);
  span.upper = std::max(span.upper, joint);
}

}  // namespace pentapost::analysis
