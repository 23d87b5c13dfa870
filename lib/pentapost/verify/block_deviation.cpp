#include "pentapost/verify/block_deviation.hpp"

#include "pentapost/verify/axis_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pentapost::verify {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double relative_gap = 1e-3;
/// A share of a block this small is not divided again.
constexpr double smallest_share = 0x1p-40;
constexpr std::size_t most_levels = 42;
/// More places are needed only by blocks of many thousand turns.
constexpr int most_places = 20'000;

/// Everything that is known at one place of the block.
struct Place {
  double s;
  Station station;
  double tip_fraction;   ///< of the move, where the tip's path is nearest, within the part
  double projection;     ///< the same without bounds
  double axis_fraction;  ///< of the move, whose axis counts here
  int piece;             ///< which linear piece of axis_fraction(projection, s)
  Deviation deviation;
};

/// A share of the block between two places.
struct Share {
  Place from, to;
};

/// The search for the maximum of one of the two deviations.
class Peak {
 public:
  Peak(double proven, double limit) : reached_{proven}, bound_{proven}, limit_{limit} {}

  void reach(double value) { reached_ = std::max(reached_, value); }
  bool is_beyond_limit() const { return reached_ > limit_; }
  /// Whether a share with this upper bound must be divided; otherwise it counts as done.
  bool needs_division(double upper, bool divisible) {
    if (upper <= std::max(reached_, bound_)) return false;
    const bool is_decided = upper <= limit_;
    const bool is_sharp = upper - reached_ <= relative_gap * std::max(reached_, limit_);
    if (divisible && !(is_decided && is_sharp)) return true;
    bound_ = upper;
    return false;
  }
  double value() const { return is_beyond_limit() ? reached_ : std::max(reached_, bound_); }

 private:
  double reached_, bound_, limit_;
};

class Search {
 public:
  Search(const BlockCurve& curve, const MovePart& part)
      : curve_{curve},
        part_{part},
        move_{part.move},
        draw_{move_.length_mm() > 0.0 ? part.tip_resolution_mm / move_.length_mm() : infinity} {}

  Place place(double s, const Station& station) const;
  Place place(double s) const { return place(s, curve_.at(s)); }
  /// Upper bounds over the share.
  Deviation bound(const Share& share) const;

 private:
  void find_axis_fraction(Place& place) const;
  double pair_acceleration_mm(const Share& share, double curve_acceleration_mm) const;
  double fraction_slack(const Share& share, double curve_acceleration_mm) const;

  const BlockCurve& curve_;
  const MovePart& part_;
  const path::Segment& move_;
  double draw_;  ///< how far the projection is drawn towards the fraction of the block
};

Place Search::place(double s, const Station& station) const {
  Place here{.s = s,
             .station = station,
             .tip_fraction = 0.0,
             .projection = 0.0,
             .axis_fraction = 0.0,
             .piece = 0,
             .deviation = {}};
  const double block_fraction = part_.from_fraction + s * (part_.to_fraction - part_.from_fraction);
  here.projection = move_.projected_fraction(station.tip_mm, block_fraction);
  here.tip_fraction = std::clamp(here.projection, part_.from_fraction, part_.to_fraction);
  here.axis_fraction = block_fraction;
  if (curve_.runs_in_joints() && move_.axis_angle_rad() > 0.0) find_axis_fraction(here);
  here.deviation.tip_mm = (station.tip_mm - move_.tip_mm(here.tip_fraction)).norm();
  here.deviation.axis_chord = (station.axis - move_.axis(here.axis_fraction)).norm();
  return here;
}

/// Draws the projection towards the fraction of the block, by draw_ at most.
void Search::find_axis_fraction(Place& place) const {
  const double block_fraction = place.axis_fraction;
  const double ahead = place.tip_fraction - block_fraction;
  const int side = ahead > draw_ ? 1 : ahead < -draw_ ? -1 : 0;
  const int clamped = place.projection < part_.from_fraction ? -1
                      : place.projection > part_.to_fraction ? 1
                                                             : 0;
  place.piece = 3 * clamped + side;
  if (side != 0) place.axis_fraction = place.tip_fraction - side * draw_;
}

/// Bound of the second derivative of (tip - point of the move at a linear fraction).
double Search::pair_acceleration_mm(const Share& share, double curve_acceleration_mm) const {
  if (!move_.is_arc()) return curve_acceleration_mm;
  const double from = share.from.tip_fraction, way = share.to.tip_fraction - from;
  const double sweep_rad = std::abs(way) * move_.sweep_rad();
  const double spiral_mm = std::abs(way * move_.radius_change_mm());
  const path::Segment* printed = curve_.printed_arc();
  if (printed == nullptr)
    return curve_acceleration_mm + sweep_rad * sweep_rad * move_.largest_radius_mm() +
           2.0 * sweep_rad * spiral_mm;
  // Two arcs all but alike: arms p, c turn by the vectors w, v; |p'' - c''| is at most
  // w^2 |p - c| + |w^2 - v^2| |c|, and |p - c| grows from its start by |w - v| |c|.
  const double h = share.to.s - share.from.s;
  const Vec3 printed_turn = h * printed->sweep_rad() * printed->normal();
  const Vec3 turn = way * move_.sweep_rad() * move_.normal();
  const double difference = (printed_turn - turn).norm();
  const double radius_mm = move_.largest_radius_mm();
  const double apart_mm = (printed->arm_mm(share.from.s) - move_.arm_mm(from)).norm() +
                          radius_mm * difference + std::abs(h * printed->radius_change_mm()) +
                          spiral_mm;
  const double w = printed_turn.norm();
  return w * w * apart_mm + (w + sweep_rad) * difference * radius_mm +
         (w * w + 2.0 * w) * std::abs(h * printed->radius_change_mm()) +
         (sweep_rad * sweep_rad + 2.0 * sweep_rad) * spiral_mm;
}

/// How far axis_fraction leaves the straight line between its values at both ends of the share.
double Search::fraction_slack(const Share& share, double curve_acceleration_mm) const {
  if (!curve_.runs_in_joints() || move_.axis_angle_rad() == 0.0 || draw_ == infinity) return 0.0;
  double acceleration = curve_acceleration_mm / move_.length_mm();
  if (move_.is_arc()) {
    const Vec3 way_mm = share.to.station.tip_mm - share.from.station.tip_mm;
    const double speed_mm = way_mm.norm() + 0.5 * curve_acceleration_mm;
    const double distance_mm = std::min(move_.axis_distance_mm(share.from.station.tip_mm),
                                        move_.axis_distance_mm(share.to.station.tip_mm)) -
                               0.5 * speed_mm;
    if (!(distance_mm > 0.0)) return 1.0;
    const double speed = speed_mm / distance_mm;
    // The projection weighs angle and height; the height's share is bounded by the term above.
    acceleration += (curve_acceleration_mm / distance_mm + 2.0 * speed * speed) / move_.sweep_rad();
  }
  double slack = acceleration / 8.0;
  if (share.from.piece != share.to.piece) {
    // Piecewise linear, with slopes between those of the pieces.
    const double block_way =
        (share.to.s - share.from.s) * (part_.to_fraction - part_.from_fraction);
    const double projected_way = share.to.projection - share.from.projection;
    const auto [least, most] = std::minmax({0.0, block_way, projected_way});
    slack += 0.25 * (most - least);
  }
  return std::min(slack, part_.to_fraction - part_.from_fraction);
}

Deviation Search::bound(const Share& share) const {
  const double h = share.to.s - share.from.s;
  const Station &from = share.from.station, &to = share.to.station;
  const double curve_acceleration_mm = curve_.tip_acceleration_mm(from, to, h);
  const double ends_mm = std::max(share.from.deviation.tip_mm, share.to.deviation.tip_mm);
  const double ends_chord =
      std::max(share.from.deviation.axis_chord, share.to.deviation.axis_chord);
  const double move_turn_rad = move_.axis_angle_rad();
  const double turn_rad =
      move_turn_rad * std::abs(share.to.axis_fraction - share.from.axis_fraction);
  return {.tip_mm = ends_mm + pair_acceleration_mm(share, curve_acceleration_mm) / 8.0,
          .axis_chord = axis_chord_bound(ends_chord, curve_.axis_rates(from, to, h), turn_rad) +
                        move_turn_rad * fraction_slack(share, curve_acceleration_mm)};
}

bool is_finite(const Deviation& deviation) {
  return std::isfinite(deviation.tip_mm) && std::isfinite(deviation.axis_chord);
}

constexpr Deviation not_a_number{std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::quiet_NaN()};

}  // namespace

double chord_of_angle(double angle_rad) { return 2.0 * std::sin(0.5 * angle_rad); }
double angle_of_chord(double chord) { return 2.0 * std::asin(std::min(1.0, 0.5 * chord)); }

Deviation largest_deviation(const BlockCurve& curve, const Station& from, const Station& to,
                            const MovePart& part, const Deviation& proven, const Deviation& limit) {
  const Search search{curve, part};
  Peak tip{proven.tip_mm, limit.tip_mm}, axis{proven.axis_chord, limit.axis_chord};
  bool finite = true;
  const auto reach = [&](const Place& place) {
    tip.reach(place.deviation.tip_mm);
    axis.reach(place.deviation.axis_chord);
    finite = finite && is_finite(place.deviation);
  };

  const Share whole{search.place(0.0, from), search.place(1.0, to)};
  reach(whole.from);
  reach(whole.to);
  // Whether the share needs a closer look.
  const auto is_open = [&](const Share& share, bool divisible) {
    const Deviation upper = search.bound(share);
    const bool is_open_for_tip = tip.needs_division(upper.tip_mm, divisible);
    const bool is_open_for_axis = axis.needs_division(upper.axis_chord, divisible);
    return is_open_for_tip || is_open_for_axis;
  };
  if (finite && is_open(whole, true)) {
    // Depth first: one waiting share a level of division.
    std::array<Share, most_levels> waiting;
    std::size_t count = 0;
    waiting[count++] = whole;
    int places = 2;
    while (count > 0 && finite && !tip.is_beyond_limit() && !axis.is_beyond_limit()) {
      const Share share = waiting[--count];
      const double h = share.to.s - share.from.s;
      if (!is_open(share, places < most_places && h > smallest_share)) continue;
      const Place middle = search.place(share.from.s + 0.5 * h);
      ++places;
      reach(middle);
      waiting[count++] = {middle, share.to};
      waiting[count++] = {share.from, middle};
    }
  }
  if (!finite) return not_a_number;
  return {tip.value(), axis.value()};
}

namespace {

/// The larger of two; NaN where one is.
double larger(double one, double other) { return one > other || std::isnan(one) ? one : other; }

/// How far the tip of a block leaves a straight move, and runs ahead of it or behind.
struct TipBound {
  double tip_mm, ahead_mm;
};

// The way of the tip less the straight line between its ends is the cubic through its ends and
// their velocities, s (1 - s) times a mean of both excess velocities, but for 1/384 of the fourth
// derivative. What runs along the move is no distance from it, as long as it stays within it.
TipBound tip_bound(const BlockCurve& curve, const Station& from, const Station& to,
                   const Vec3& cl_from_mm, const Vec3& cl_to_mm) {
  const Vec3 from_error_mm = from.tip_mm - cl_from_mm, to_error_mm = to.tip_mm - cl_to_mm;
  const double ends_mm = std::sqrt(larger(from_error_mm.squaredNorm(), to_error_mm.squaredNorm()));
  if (!curve.runs_in_joints()) return {ends_mm, 0.0};
  const Vec3 way_mm = to.tip_mm - from.tip_mm;
  const Vec3 from_excess_mm = curve.tip_velocity_mm(from) - way_mm;
  const Vec3 to_excess_mm = curve.tip_velocity_mm(to) - way_mm;
  const double excess = larger(from_excess_mm.squaredNorm(), to_excess_mm.squaredNorm());
  const double rest_mm = curve.tip_snap_mm(from, to) / 384.0;
  const Vec3 move_mm = cl_to_mm - cl_from_mm;
  const double length_mm = move_mm.norm();
  const double anywhere_mm = ends_mm + 0.25 * std::sqrt(excess) + rest_mm;
  if (!(length_mm > 0.0)) return {anywhere_mm, 0.0};
  const Vec3 along = move_mm / length_mm;
  const double from_along_mm = from_excess_mm.dot(along), to_along_mm = to_excess_mm.dot(along);
  const double along_mm = larger(std::abs(from_along_mm), std::abs(to_along_mm));
  const double ends_along_mm =
      larger(std::abs(from_error_mm.dot(along)), std::abs(to_error_mm.dot(along)));
  const double ahead_mm = ends_along_mm + 0.25 * along_mm + rest_mm;
  if (!(along_mm + ends_along_mm <= length_mm)) return {anywhere_mm, ahead_mm};
  const double across = larger(from_excess_mm.squaredNorm() - from_along_mm * from_along_mm,
                               to_excess_mm.squaredNorm() - to_along_mm * to_along_mm);
  return {ends_mm + 0.25 * std::sqrt(std::max(0.0, across)) + 2.0 * rest_mm, ahead_mm};
}

}  // namespace

Deviation quick_bound(const BlockCurve& curve, const Station& from, const Station& to,
                      const Vec3& cl_from_mm, const Vec3& axis_from, const Vec3& cl_to_mm,
                      const Vec3& axis_to, double tip_resolution_mm) {
  const TipBound tip = tip_bound(curve, from, to, cl_from_mm, cl_to_mm);
  const double ends_chord =
      std::sqrt(larger((from.axis - axis_from).squaredNorm(), (to.axis - axis_to).squaredNorm()));
  const double turn_chord = (axis_to - axis_from).norm();
  if (!(turn_chord <= 1.0)) return {tip.tip_mm, infinity};
  const double turn_rad = 1.05 * turn_chord;  // 2 asin(1/2) = 1.0472
  double axis_chord = axis_chord_bound(ends_chord, curve.axis_rates(from, to, 1.0), turn_rad);
  if (curve.runs_in_joints() && turn_chord > 0.0) {
    // The projection leaves the fraction of the block by no more than the tip leaves its even run.
    const double length_mm = (cl_to_mm - cl_from_mm).norm();
    const double ahead_mm = tip.ahead_mm - tip_resolution_mm;
    if (length_mm > 0.0 && ahead_mm > 0.0)
      axis_chord += turn_rad * std::min(1.0, ahead_mm / length_mm);
  }
  return {tip.tip_mm, axis_chord};
}

}  // namespace pentapost::verify
