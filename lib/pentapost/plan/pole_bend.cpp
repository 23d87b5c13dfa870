#include "pentapost/plan/pole_bend.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/plan/candidates.hpp"
#include "pentapost/plan/near_passages.hpp"
#include "pentapost/plan/pole_bump.hpp"
#include "pentapost/plan/sequences.hpp"
#include "pentapost/plan/tilt_signs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace pentapost::plan {
namespace {

/// A stretch that ends nearer to the pole than this many times the nearest distance is too short.
constexpr double least_stretch = 3.0;
/// What must be left at most of the first joint's turn for each radian of the tool axis.
constexpr double largest_share_left = 0.5;
/// Turn of the first joint for each radian of tilt by which a corner at the pole is rounded off.
constexpr double corner_turn_ratio = 3.0;
/// What corners elsewhere may be rounded off by, of the change.
constexpr double largest_rounding = 0.01;
/// Arithmetic on unit vectors.
constexpr double least_noise = 1e-9;

double chord_of(double angle_rad) { return 2.0 * std::sin(0.5 * angle_rad); }
double angle_of(double chord) { return 2.0 * std::asin(std::min(1.0, 0.5 * chord)); }

/// How far from the pole a change of the axis by `change_rad` at most reaches.
double reach_rad(double change_rad) { return std::sqrt(2.0 * change_rad / bent_turn_ratio); }

/// A point of the bent path.
struct BentPoint {
  std::uint32_t point;  ///< on the CL move to this point
  double fraction;      ///< in (0, 1]
  std::size_t side;
  Vec3 cl_axis, axis;
  double azimuth_turn_rad;  ///< that rounds off corners of the CL path
};

struct Bend {
  PoleBend what;
  std::vector<BentPoint> points;  ///< the first and the last are not changed
};

class Bender {
 public:
  Bender(const kinematics::Model& model, const path::ToolPath& tool_path, double largest_rad)
      : model_{model}, tool_path_{tool_path}, largest_rad_{largest_rad} {}

  /// @return nullopt: the passage is better left alone.
  std::optional<Bend> bend(const NearPassage& passage) const {
    const double nearest = passage.nearest.chord;
    const double reach = chord_of(reach_rad(angle_of(nearest)));
    const std::array<double, 2> ends{std::min(reach, passage.before.chord),
                                     std::min(reach, passage.after.chord)};
    if (!(std::min(ends[0], ends[1]) >= least_stretch * nearest)) return std::nullopt;
    const Vec3 pole = pole_axis(model_, passage.pole);
    PoleBump bump{pole, nearest_axis(passage), ends};
    Bend bend;
    bend.points = points_of(passage, bump);
    if (!set_axes(bump, bend.points)) return std::nullopt;
    bend.what = {tool_path_.cl_line[passage.nearest.point], largest_change_rad(bend.points)};
    if (!(bend.what.change_rad <= largest_rad_) || !is_better(pole, bend.points))
      return std::nullopt;
    return bend;
  }

 private:
  Vec3 nearest_axis(const NearPassage& passage) const {
    const std::uint32_t point = passage.nearest.point;
    if (passage.nearest.fraction == 1.0) return tool_path_.axis_wp[point];
    return GreatCircle{tool_path_.axis_wp[point - 1], tool_path_.axis_wp[point]}.axis(
        passage.nearest.fraction);
  }

  /// CL points and new ones from the last place that is not changed to the next.
  std::vector<BentPoint> points_of(const NearPassage& passage, const PoleBump& bump) const {
    const std::uint32_t nearest = passage.nearest.point;
    const bool is_point = passage.nearest.fraction == 1.0;
    std::uint32_t begin = nearest - 1, end = is_point ? nearest + 1 : nearest;
    while (begin > passage.before.point && bump.x_of(tool_path_.axis_wp[begin], 0) < 1.0) --begin;
    while (end < passage.after.point && bump.x_of(tool_path_.axis_wp[end], 1) < 1.0) ++end;
    std::vector<BentPoint> points;
    add(points, begin, 1.0, PoleBump::before, tool_path_.axis_wp[begin]);
    for (std::uint32_t point = begin + 1; point <= end; ++point) {
      if (tool_path_.axis_wp[point] != tool_path_.axis_wp[point - 1]) {
        const GreatCircle turn{tool_path_.axis_wp[point - 1], tool_path_.axis_wp[point]};
        const double part = point < nearest   ? 1.0
                            : point > nearest ? 0.0
                                              : passage.nearest.fraction;
        if (part > 0.0) add_divisions(points, bump, turn, point, 0.0, part, PoleBump::before);
        if (part < 1.0) add_divisions(points, bump, turn, point, part, 1.0, PoleBump::after);
      }
      const bool is_after = point > nearest || (point == nearest && !is_point);
      add(points, point, 1.0, is_after ? PoleBump::after : PoleBump::before,
          tool_path_.axis_wp[point]);
    }
    // A division at the end of the bump makes the CL point beyond it superfluous.
    const auto is_end = [&](const BentPoint& each) {
      return each.fraction < 1.0 && bump.x_of(each.cl_axis, each.side) >= 1.0 - least_noise;
    };
    if (is_end(points[1])) points.erase(points.begin());
    if (is_end(points[points.size() - 2])) points.pop_back();
    return points;
  }

  static void add(std::vector<BentPoint>& points, std::uint32_t point, double fraction,
                  std::size_t side, const Vec3& axis) {
    points.push_back({point, fraction, side, axis, axis, 0.0});
  }

  static void add_divisions(std::vector<BentPoint>& points, const PoleBump& bump,
                            const GreatCircle& turn, std::uint32_t point, double from, double to,
                            std::size_t side) {
    for (const double fraction : bump.divisions(turn, from, to, side))
      add(points, point, fraction, side, turn.axis(fraction));
  }

  static bool set_axes(PoleBump& bump, std::vector<BentPoint>& points) {
    std::optional<Vec3> in, out;
    for (const BentPoint& each : points) {
      if (!is_outside(bump, each)) continue;
      if (each.side == PoleBump::before) in = each.cl_axis;
      if (each.side == PoleBump::after && !out) out = each.cl_axis;
    }
    if (!in || !out || !bump.set_core({*in, *out})) return false;
    for (const std::size_t side : {PoleBump::before, PoleBump::after})
      if (!round_corners(bump, points, side)) return false;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
      points[i].axis = bump.bent(points[i].cl_axis, points[i].side, points[i].azimuth_turn_rad);
    return true;
  }

  /// The places of a side from the end of the core outwards.
  static std::vector<BentPoint*> outwards(const PoleBump& bump, std::vector<BentPoint>& points,
                                          std::size_t side) {
    std::vector<BentPoint*> places;
    for (BentPoint& each : points)
      if (each.side == side && is_outside(bump, each)) places.push_back(&each);
    if (side == PoleBump::before) std::reverse(places.begin(), places.end());
    return places;
  }

  /// A corner of the CL path turns the first joint at once, the nearer to the pole the more. What
  /// turns at the core is spread outwards, and between two CL points the new ones follow an even
  /// turn about the pole.
  static bool round_corners(const PoleBump& bump, std::vector<BentPoint>& points,
                            std::size_t side) {
    const auto places = outwards(bump, points, side);
    const double core_turn_rad = bump.core_turn_rad(side);
    const double core_rad = bump.polar(places.front()->cl_axis).tilt_rad;
    std::size_t corner = places.size();  // the CL point before; none yet
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double tilt_rad = bump.polar(places[i]->cl_axis).tilt_rad;
      const double left_rad = std::abs(core_turn_rad) - corner_turn_ratio * (tilt_rad - core_rad);
      places[i]->azimuth_turn_rad += std::copysign(std::max(0.0, left_rad), core_turn_rad);
      if (i + 1 == places.size() && left_rad > 0.0 && std::abs(core_turn_rad) > least_noise)
        return false;
      if (!is_cl_point(places, i)) continue;
      if (corner < i) turn_evenly(bump, places, corner, i);
      corner = i;
    }
    return true;
  }

  static bool is_cl_point(const std::vector<BentPoint*>& places, std::size_t i) {
    return places[i]->fraction == 1.0 || i + 1 == places.size();
  }

  /// Turns the places between two of a side so that the azimuth runs evenly with the tilt.
  static void turn_evenly(const PoleBump& bump, const std::vector<BentPoint*>& places,
                          std::size_t begin, std::size_t end) {
    const auto from = bump.polar(places[begin]->cl_axis), to = bump.polar(places[end]->cl_axis);
    const double way_rad = to.tilt_rad - from.tilt_rad;
    if (!(way_rad > least_noise)) return;
    const double turn_rad = wrapped_rad(to.azimuth_rad - from.azimuth_rad);
    const auto missing_rad = [&](std::size_t i) {
      const auto here = bump.polar(places[i]->cl_axis);
      const double share = std::clamp((here.tilt_rad - from.tilt_rad) / way_rad, 0.0, 1.0);
      return wrapped_rad(from.azimuth_rad + share * turn_rad - here.azimuth_rad);
    };
    double largest_rad = 0.0;
    for (std::size_t i = begin + 1; i < end; ++i)
      largest_rad = std::max(largest_rad, std::abs(missing_rad(i)) * to.tilt_rad);
    const double allowed_rad = largest_rounding * bump.delta_rad();
    const double share = largest_rad > allowed_rad ? allowed_rad / largest_rad : 1.0;
    for (std::size_t i = begin + 1; i < end; ++i)
      places[i]->azimuth_turn_rad += share * missing_rad(i);
  }

  static bool is_outside(const PoleBump& bump, const BentPoint& place) {
    return bump.x_of(place.cl_axis, place.side) >= PoleBump::core * (1.0 - PoleBump::same_share);
  }

  /// At all points and in the middle between them.
  static double largest_change_rad(const std::vector<BentPoint>& points) {
    double largest_rad = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const BentPoint &from = points[i - 1], &to = points[i];
      largest_rad = std::max({largest_rad, angle_between_rad(to.cl_axis, to.axis),
                              angle_between_rad(from.cl_axis + to.cl_axis, from.axis + to.axis)});
    }
    return largest_rad;
  }

  static bool is_better(const Vec3& pole, const std::vector<BentPoint>& points) {
    double was = 0.0, is = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const BentPoint &from = points[i - 1], &to = points[i];
      const double turned_rad = angle_between_rad(from.cl_axis, to.cl_axis);
      if (!(turned_rad > least_noise)) continue;
      const double stretched = angle_between_rad(from.axis, to.axis) / turned_rad;
      was = std::max(was, turn_ratio(pole, from.cl_axis, to.cl_axis));
      is = std::max(is, stretched * turn_ratio(pole, from.axis, to.axis));
    }
    return is <= largest_share_left * was;
  }

  const kinematics::Model& model_;
  const path::ToolPath& tool_path_;
  const double largest_rad_;
};

/// Bends the passages that the range of the second joint allows.
std::vector<Bend> chosen_bends(const kinematics::Model& model, const JointRanges& ranges,
                               const path::ToolPath& tool_path, const PoleZone& zone,
                               double largest_rad, const std::vector<NearPassage>& passages) {
  std::vector<Bend> bends;
  const Bender bender{model, tool_path, largest_rad};
  const double zone_chord = chord_of(zone.radius_rad);
  const auto all = sequences(tool_path);
  TiltSigns signs{model, ranges, tool_path};
  for (std::size_t i = 0; i < passages.size(); ++i) {
    const NearPassage& passage = passages[i];
    const bool is_first = i == 0 || passages[i - 1].sequence != passage.sequence;
    const bool is_last = i + 1 == passages.size() || passages[i + 1].sequence != passage.sequence;
    const PointRange range = all[passage.sequence].range;
    if (is_first) signs.start({range.begin, passage.nearest.point});
    const PointRange next{passage.nearest.point,
                          is_last ? range.end : passages[i + 1].nearest.point};
    if (passage.nearest.chord <= zone_chord) {
      if (!signs.pass(passage.pole, next)) signs.go_on(next);
      continue;
    }
    auto bend = bender.bend(passage);
    if (bend && signs.pass(passage.pole, next))
      bends.push_back(*std::move(bend));
    else
      signs.go_on(next);
  }
  return bends;
}

/// Puts the bends into a tool path.
class Rebuild {
 public:
  explicit Rebuild(const path::ToolPath& tool_path) : from_{tool_path} {}

  PoleBends run(const std::vector<Bend>& bends) {
    PoleBends result;
    for (const Bend& bend : bends) take(bend, result);
    copy_to(static_cast<std::uint32_t>(from_.size()));
    move_events();
    to_.program_name = from_.program_name;
    to_.axis_rounding_rad = from_.axis_rounding_rad;
    to_.has_tool_change = from_.has_tool_change;
    result.cl_axis_wp = std::move(cl_axis_);
    result.inserted_points = to_.size() - from_.size();
    result.tool_path = std::move(to_);
    return result;
  }

 private:
  void take(const Bend& bend, PoleBends& result) {
    for (std::size_t i = 0; i < bend.points.size(); ++i) {
      const BentPoint& each = bend.points[i];
      if (each.fraction < 1.0) {
        copy_to(each.point);
        insert(each);
      } else if (each.point >= next_) {
        copy_to(each.point);
        add(each.point, each.axis);
      }
      if (i == 0)
        comments_.push_back(
            {static_cast<std::uint32_t>(to_.size()), bend.what.cl_line,
             path::Comment{"the tool axis is changed by up to " +
                           number_text(bend.what.change_rad * deg_per_rad, 3) +
                           " deg near the pole at CL line " + std::to_string(bend.what.cl_line)}});
    }
    result.bends.push_back(bend.what);
    result.largest_change_rad = std::max(result.largest_change_rad, bend.what.change_rad);
  }

  void insert(const BentPoint& each) {
    if (first_new_.empty() || first_new_.back().first != each.point)
      first_new_.emplace_back(each.point, static_cast<std::uint32_t>(to_.size()));
    const Vec3 &from_mm = from_.tip_wp_mm[each.point - 1], &to_mm = from_.tip_wp_mm[each.point];
    to_.add_point(from_mm + each.fraction * (to_mm - from_mm), each.axis, from_.cl_line[each.point],
                  from_.move[each.point]);
    cl_axis_.push_back(each.cl_axis);
  }

  void add(std::uint32_t point, const Vec3& axis) {
    to_.add_point(from_.tip_wp_mm[point], axis, from_.cl_line[point], from_.move[point]);
    cl_axis_.push_back(from_.axis_wp[point]);
    next_ = point + 1;
  }

  void copy_to(std::uint32_t end) {
    while (next_ < end) add(next_, from_.axis_wp[next_]);
  }

  /// An event before a point comes before the points that were inserted on the move to it.
  void move_events() {
    std::size_t comment = 0, inserted = 0;
    std::uint32_t added = 0;
    const auto add_comments = [&](std::uint32_t before_point) {
      for (; comment < comments_.size() && comments_[comment].before_point < before_point;
           ++comment)
        to_.events.push_back(comments_[comment]);
    };
    for (path::Event event : from_.events) {
      for (; inserted < first_new_.size() && first_new_[inserted].first < event.before_point;
           ++inserted)
        added = added_by(inserted);
      event.before_point += added;
      add_comments(event.before_point);
      to_.events.push_back(std::move(event));
    }
    add_comments(static_cast<std::uint32_t>(to_.size()) + 1);
  }

  /// Points that were inserted up to and on the move of an entry of first_new_.
  std::uint32_t added_by(std::size_t entry) const {
    const std::uint32_t all = static_cast<std::uint32_t>(to_.size() - from_.size());
    if (entry + 1 == first_new_.size()) return all;
    return first_new_[entry + 1].second - first_new_[entry + 1].first;
  }

  const path::ToolPath& from_;
  path::ToolPath to_;
  std::vector<Vec3> cl_axis_;
  std::vector<path::Event> comments_;
  /// CL point, and the index of the first new point on the move to it.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> first_new_;
  std::uint32_t next_ = 0;  ///< CL point to be copied
};

}  // namespace

PoleBends bend_at_poles(const kinematics::Model& model, const JointRanges& ranges,
                        const Settings& settings, const path::ToolPath& tool_path) {
  if (!(settings.pole_axis_rad > 0.0) || model.rotary_count != 2) return {};
  const PoleZone zone = pole_zone(model, tool_path.axis_rounding_rad,
                                  axis_freedom_rad(settings.axis_tolerance_rad, settings.flank));
  const NearRule rule{.nearest_chord = chord_of(settings.pole_axis_rad),
                      .far_chord = chord_of(reach_rad(settings.pole_axis_rad)),
                      .noise_chord = 2.0 * tool_path.axis_rounding_rad + least_noise};
  const auto passages = near_passages(model, tool_path, zone, rule);
  const auto bends = chosen_bends(model, ranges, tool_path, zone, settings.pole_axis_rad, passages);
  if (bends.empty()) return {};
  return Rebuild{tool_path}.run(bends);
}

}  // namespace pentapost::plan
