#include "pentapost/plan/plain_choice.hpp"

#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/plan/choice_costs.hpp"
#include "pentapost/plan/state_space.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {
namespace {

constexpr double turn_rad = 2.0 * pi;
/// Distance from the ends of the triangle, where the two branches merge.
constexpr double least_opening_rad = 1e-6;
constexpr double least_sine = 1e-6;
/// Steps of the first axis up to this are the ones that the axis takes.
constexpr double plain_step_rad = pi / 2.0;
/// By this much, in seconds, a start must be better than another with other turns.
constexpr double clear_s = 1e-3;
// Wider ranges hold so many turns that not all of them are looked at.
constexpr double largest_first_width_rad = 4.0 * turn_rad;
constexpr double largest_second_width_rad = 1.25 * turn_rad;

struct Turns {
  int first = 0, second = 0;
};

class Plain {
 public:
  Plain(const kinematics::Model& model, const JointRanges& ranges, const path::ToolPath& tool_path,
        PointRange range, const PoleZone& zone, const Settings& settings, double gauge_length_mm,
        bool check_linear)
      : model_{model},
        ranges_{ranges},
        tool_path_{tool_path},
        range_{range},
        least_sine_{std::max(least_sine, 8.0 * zone.radius_rad)},
        settings_{settings},
        gauge_length_mm_{gauge_length_mm},
        check_linear_{check_linear},
        speeds_{ordering_speeds(model, settings)} {}

  std::optional<AxisPath> run() {
    if (!is_of_the_kind() || !start()) return std::nullopt;
    path_.range = range_;
    const std::size_t count = range_.end - range_.begin;
    path_.arrival.reserve(count);
    for (std::uint32_t point = range_.begin; point < range_.end; ++point) {
      if (point == range_.begin || tool_path_.axis_wp[point] != tool_path_.axis_wp[point - 1])
        if (!go_to(point)) return std::nullopt;
      if (!is_within_ranges(point)) return std::nullopt;
      path_.arrival.push_back(
          {first_rad_ + turn_rad * turns_.first, second_rad_ + turn_rad * turns_.second});
    }
    if (!is_cheapest()) return std::nullopt;
    path_.branch.assign(count, static_cast<std::uint8_t>(branch_));
    path_.pole.assign(count, 0);
    return std::move(path_);
  }

 private:
  bool is_of_the_kind() const {
    const auto is_wider = [](const std::optional<Range<double>>& range, double width_rad) {
      return range && range->upper - range->lower > width_rad;
    };
    return model_.rotary_count == 2 && range_.begin < range_.end && settings_.preferences.tilt &&
           model_.fixed.linear_place >= 0 &&
           !is_wider(ranges_.rotary_rad[0], largest_first_width_rad) &&
           !is_wider(ranges_.rotary_rad[1], largest_second_width_rad);
  }

  double second_of(double opening_rad, int branch) const {
    const double plus = model_.beta_zero_rad + opening_rad;
    return branch == 0 ? plus : 2.0 * model_.beta_zero_rad - plus;
  }

  /// Finds the one start that the preferences want; false: there is none, or a choice.
  bool start() {
    const auto solutions = kinematics::inverse_rotary(model_, tool_path_.axis_wp[range_.begin]);
    if (solutions.count != 2) return false;
    int found = 0;
    for (const int branch : {0, 1}) {
      const double second = second_of(solutions.opening_rad, branch);
      const int most = ranges_.rotary_rad[1] ? 2 : 0;
      for (int turns = -most; turns <= most; ++turns) {
        const double turned_rad = second + turn_rad * turns;
        if (!in_range(ranges_.rotary_rad[1], turned_rad) || !has_right_tilt(turned_rad)) continue;
        ++found;
        branch_ = branch;
        turns_.second = turns;
      }
    }
    return found == 1 && start_first(solutions.branch[static_cast<std::size_t>(branch_)].first_rad);
  }

  bool has_right_tilt(double second_rad) const {
    return *settings_.preferences.tilt == machine::Preferences::Tilt::positive ? second_rad >= 0.0
                                                                               : second_rad <= 0.0;
  }

  /// Turns of the first axis: the only ones at no cost.
  bool start_first(double first_rad) {
    const auto window = start_window_rad(settings_.preferences);
    const double moved_rad = moved_to_window_rad(first_rad, window);
    turns_.first = static_cast<int>(std::lround((moved_rad - first_rad) / turn_rad));
    if (moved_rad < window.lower || moved_rad > window.upper) return false;
    if (!ranges_.rotary_rad[0]) return true;
    const double clear_rad = turn_rad * clear_s / outside_window_s;
    return moved_rad + turn_rad > window.upper + clear_rad &&
           moved_rad - turn_rad < window.lower - clear_rad;
  }

  /// False where the way from the point before may pass a pole, or the point lies near one.
  bool go_to(std::uint32_t point) {
    const Vec3& axis = tool_path_.axis_wp[point];
    const auto inside = kinematics::inverse_rotary_inside(model_, axis, branch_);
    if (!(inside.opening_rad > least_opening_rad && inside.opening_rad < pi - least_opening_rad &&
          inside.sin_gamma > least_sine_))
      return false;
    const double second = second_of(inside.opening_rad, branch_);
    if (point == range_.begin) {
      first_rad_ = inside.first_rad;
    } else {
      if (may_pass_pole(tool_path_.axis_wp[point - 1], axis,
                        std::min(inside.sin_gamma, sin_gamma_)))
        return false;
      const double step_rad = wrapped_rad(inside.first_rad - first_rad_);
      if (!(std::abs(step_rad) <= plain_step_rad)) return false;
      first_rad_ += step_rad;
    }
    second_rad_ = second;
    sin_gamma_ = inside.sin_gamma;
    return true;
  }

  /// Whether the great circle between two tool axes may pass near a pole, or is not certain.
  bool may_pass_pole(const Vec3& from, const Vec3& to, double smaller_sine) const {
    if ((to - from).squaredNorm() <= 0.25 * smaller_sine * smaller_sine) return false;
    constexpr double near_sine = 1e-3, half_turn_cosine = -0.99;
    const Vec3 normal = from.cross(to);
    return least_sine_ > near_sine || from.dot(to) < half_turn_cosine ||
           std::abs(model_.a.dot(normal)) <= near_sine * normal.norm();
  }

  bool is_within_ranges(std::uint32_t point) const {
    if (!in_range(ranges_.rotary_rad[0], first_rad_ + turn_rad * turns_.first) ||
        !in_range(ranges_.rotary_rad[1], second_rad_ + turn_rad * turns_.second))
      return false;
    if (!check_linear_) return true;
    const Vec3 linear_mm = *kinematics::inverse_linear(model_, tip_table_mm(point), first_rad_,
                                                       second_rad_, gauge_length_mm_);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& range = ranges_.linear_mm[i];
      if (range && !range->contains(linear_mm[static_cast<Eigen::Index>(i)])) return false;
    }
    return true;
  }

  Vec3 tip_table_mm(std::uint32_t point) const {
    return tool_path_.tip_wp_mm[point] + settings_.origin_mm;
  }

  /// The other branch starts with the wrong tilt, and its second axis moves as this one does: it is
  /// dearer as long as the rest of the way costs less than the tilt.
  bool is_cheapest() const {
    constexpr double most_s = 0.99 * wrong_tilt_s;
    double rest_s = 0.0;
    for (std::uint32_t point = range_.begin + 1; point < range_.end; ++point)
      rest_s += rest_of_step_s(point, largest_linear_s(point));
    if (rest_s < most_s) return true;
    // Exact times take the place of bounds until they suffice.
    Vec3 before_mm = linear_mm(range_.begin);
    for (std::uint32_t point = range_.begin + 1; point < range_.end && rest_s >= most_s; ++point) {
      const Vec3 here_mm = linear_mm(point);
      const double exact_s =
          (here_mm - before_mm).cwiseAbs().cwiseQuotient(speeds_.linear_mm_s).maxCoeff();
      rest_s -= rest_of_step_s(point, largest_linear_s(point)) - rest_of_step_s(point, exact_s);
      before_mm = here_mm;
    }
    return rest_s < most_s;
  }

  /// Time of a step beyond that of the second axis.
  double rest_of_step_s(std::uint32_t point, double linear_s) const {
    const RotaryPair &from = path_.at(point - 1), &to = path_.at(point);
    const double first_s = std::abs(to.first_rad - from.first_rad) / speeds_.rotary_rad_s[0];
    const double second_s = std::abs(to.second_rad - from.second_rad) / speeds_.rotary_rad_s[1];
    return std::max({first_s, second_s, linear_s}) - second_s;
  }

  Vec3 linear_mm(std::uint32_t point) const {
    const RotaryPair& pair = path_.at(point);
    return *kinematics::inverse_linear(model_, tip_table_mm(point), pair.first_rad, pair.second_rad,
                                       gauge_length_mm_);
  }

  /// Upper bound of the time of the linear axes: by the tip's way, and by the arms at which each
  /// rotary axis carries the tip or, where the linear axes stand on the table's side, the tool.
  double largest_linear_s(std::uint32_t point) const {
    const RotaryPair &from = path_.at(point - 1), &to = path_.at(point);
    const double tip_mm = (tip_table_mm(point - 1) - model_.a_point_mm).norm();
    const int place = model_.fixed.linear_place;
    const double first_arm_mm = place > 0 ? tip_mm : b_from_a_mm_ + tool_arm_mm_;
    const double second_arm_mm = place > 1 ? tip_mm + b_from_a_mm_ : tool_arm_mm_;
    const double way_mm = (tool_path_.tip_wp_mm[point] - tool_path_.tip_wp_mm[point - 1]).norm() +
                          std::abs(to.first_rad - from.first_rad) * first_arm_mm +
                          std::abs(to.second_rad - from.second_rad) * second_arm_mm;
    return way_mm * linear_s_per_mm_;
  }

  const kinematics::Model& model_;
  const JointRanges& ranges_;
  const path::ToolPath& tool_path_;
  const PointRange range_;
  const double least_sine_;
  const Settings& settings_;
  const double gauge_length_mm_;
  const bool check_linear_;
  const OrderingSpeeds speeds_;
  const double b_from_a_mm_ = (model_.b_point_mm - model_.a_point_mm).norm();
  const double tool_arm_mm_ = model_.b_point_mm.norm() + std::abs(gauge_length_mm_);
  const double linear_s_per_mm_ =
      model_.fixed.linear_inverse.norm() / speeds_.linear_mm_s.minCoeff();

  AxisPath path_;
  int branch_ = 0;
  Turns turns_;
  double first_rad_ = 0.0, second_rad_ = 0.0;  ///< without the turns, unwrapped
  double sin_gamma_ = 0.0;                     ///< at the last point
};

}  // namespace

std::optional<AxisPath> plain_choice(const kinematics::Model& model, const JointRanges& ranges,
                                     const path::ToolPath& tool_path, PointRange range,
                                     const PoleZone& zone, const Settings& settings,
                                     double gauge_length_mm, bool check_linear) {
  return Plain{model, ranges, tool_path, range, zone, settings, gauge_length_mm, check_linear}
      .run();
}

}  // namespace pentapost::plan
