#include "pentapost/plan/move_curve.hpp"

#include "pentapost/kinematics/inverse.hpp"

#include <cmath>

namespace pentapost::plan {

std::optional<RotaryPair> rotary_inside(const kinematics::Model& model,
                                        const path::Segment& segment, const MovePart& part,
                                        double fraction, const RotaryPair& lower,
                                        const RotaryPair& upper, double slack_rad) {
  switch (part.kind) {
    case MovePart::Kind::still:
      return part.from;
    case MovePart::Kind::even: {
      const double share =
          (fraction - part.fraction_from) / (part.fraction_to - part.fraction_from);
      return RotaryPair{part.from.first_rad + share * (part.to.first_rad - part.from.first_rad),
                        part.from.second_rad};
    }
    case MovePart::Kind::branch:
      break;
  }
  const auto solutions = kinematics::inverse_rotary(model, segment.axis(fraction), slack_rad);
  if (solutions.count == 0) return std::nullopt;
  const auto& found = solutions.branch[static_cast<std::size_t>(part.branch)];
  const double mean_first_rad = 0.5 * (lower.first_rad + upper.first_rad);
  if (solutions.first_is_free) return RotaryPair{mean_first_rad, found.second_rad};
  const double mean_second_rad = 0.5 * (lower.second_rad + upper.second_rad);
  constexpr double turn_rad = 2.0 * pi;
  return RotaryPair{
      found.first_rad + turn_rad * std::round((mean_first_rad - found.first_rad) / turn_rad),
      found.second_rad + turn_rad * std::round((mean_second_rad - found.second_rad) / turn_rad)};
}

MovePart split_at_limit(const kinematics::Model& model, const path::Segment& segment,
                        const Range<double>& first_range_rad, MovePart& part, double rewind_rad,
                        double slack_rad) {
  MovePart whole = part;
  whole.to.first_rad -= rewind_rad;
  const double limit_rad = rewind_rad < 0.0 ? first_range_rad.upper : first_range_rad.lower;
  double inside = part.fraction_from, outside = part.fraction_to;
  RotaryPair lower = part.from, upper = whole.to;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    const auto there = rotary_inside(model, segment, whole, middle, lower, upper, slack_rad);
    if (!there) break;
    const bool beyond =
        rewind_rad < 0.0 ? there->first_rad > limit_rad : there->first_rad < limit_rad;
    (beyond ? outside : inside) = middle;
    (beyond ? upper : lower) = *there;
  }
  MovePart rest = part;
  rest.fraction_from = inside;
  part.fraction_to = inside;
  part.to = lower;
  return rest;
}

}  // namespace pentapost::plan
