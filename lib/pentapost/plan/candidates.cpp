#include "pentapost/plan/candidates.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pentapost::plan {
namespace {

using kinematics::Model;

constexpr double largest_freedom_rad = 0.01 * rad_per_deg;
/// Rounding of the axes after normalisation.
constexpr double least_radius_rad = 1e-12;
/// Tilt at which the way to the pole is read off: rounding of the angle and the turn of a nutating
/// axis on the way are both below 1e-7 rad there.
constexpr double beside_pole_rad = 1e-7;
constexpr double largest_turn_rad = 179.0 * rad_per_deg;
/// Steps of the first axis up to this are followed without a look in between.
constexpr double plain_step_rad = pi / 2.0;
constexpr int largest_depth = 60;

std::string vector_text(const Vec3& vector) {
  return "(" + number_text(vector.x(), 7) + ", " + number_text(vector.y(), 7) + ", " +
         number_text(vector.z(), 7) + ")";
}

/// The great circle between two tool axes.
struct AxisTurn {
  AxisTurn(const Vec3& axis_from, const Vec3& axis_to)
      : from{axis_from}, angle_rad{angle_between_rad(axis_from, axis_to)} {
    const Vec3 beside = axis_to - axis_from * axis_from.dot(axis_to);
    const double length = beside.norm();
    if (length > 0.0) across = beside / length;
  }
  Vec3 at(double fraction) const {
    const double turned_rad = fraction * angle_rad;
    return std::cos(turned_rad) * from + std::sin(turned_rad) * across;
  }
  /// Fraction at which the turn is nearest to `direction`; outside 0 to 1 where that is an end.
  double nearest_fraction(const Vec3& direction) const {
    return std::atan2(direction.dot(across), direction.dot(from)) / angle_rad;
  }

  Vec3 from;
  Vec3 across = Vec3::Zero();
  double angle_rad;
};

class Search {
 public:
  Search(const Model& model, const path::ToolPath& tool_path, PointRange range,
         const PoleZone& zone, double slack_rad)
      : model_{model},
        tool_path_{tool_path},
        zone_{zone},
        // The pole of a machine whose lambda and mu differ a little lies beyond its reach.
        slack_rad_{std::max(slack_rad, zone.radius_rad)} {
    found_.range = range;
    found_.branches = model.rotary_count == 2 ? 2 : 1;
    const std::size_t count = range.end - range.begin;
    for (int branch = 0; branch < found_.branches; ++branch)
      found_.first_rad[static_cast<std::size_t>(branch)].resize(count);
    found_.second_rad.resize(count);
    found_.link.resize(count, Link::start);
    found_.pole.resize(count, 0);
  }

  Result<Candidates> run() {
    for (std::uint32_t point = found_.range.begin; point < found_.range.end; ++point) {
      if (point > found_.range.begin &&
          tool_path_.axis_wp[point] == tool_path_.axis_wp[point - 1]) {
        repeat(point);
        continue;
      }
      if (auto status = add(point); !status) return std::move(status).error();
    }
    return std::move(found_);
  }

 private:
  std::size_t row(std::uint32_t point) const { return point - found_.range.begin; }

  /// The same tool axis as at the point before.
  void repeat(std::uint32_t point) {
    const std::size_t here = row(point);
    for (int branch = 0; branch < found_.branches; ++branch) {
      auto& first = found_.first_rad[static_cast<std::size_t>(branch)];
      first[here] = first[here - 1];
    }
    found_.second_rad[here] = found_.second_rad[here - 1];
    found_.pole[here] = found_.pole[here - 1];
    found_.link[here] = found_.pole[here] != 0 ? Link::start : Link::continuous;
    if (found_.pole[here] == 0) last_off_pole_ = point;
  }

  Status add(std::uint32_t point) {
    const Vec3& axis = tool_path_.axis_wp[point];
    const auto solutions = kinematics::inverse_rotary(model_, axis, slack_rad_);
    if (solutions.count == 0) return out_of_reach(point, solutions.beyond_rad);
    const std::size_t here = row(point);
    found_.pole[here] = pole_at(solutions);
    if (found_.pole[here] == 0)
      found_.largest_freedom_rad = std::max(found_.largest_freedom_rad, solutions.beyond_rad);
    if (here > 0 && (found_.pole[here] != 0 || found_.pole[here - 1] != 0)) {
      const double turned_rad = angle_between_rad(tool_path_.axis_wp[point - 1], axis);
      if (turned_rad > largest_turn_rad) return half_turn(point, turned_rad);
    }
    if (found_.pole[here] != 0) return ok();

    found_.second_rad[here] = solutions.branch[0].second_rad;
    std::array<double, 2> first{solutions.branch[0].first_rad, solutions.branch[1].first_rad};
    if (!last_off_pole_) {
      store(point, first, Link::start);
      return ok();
    }
    if (*last_off_pole_ + 1 < point) {
      store(point, near_before(first), Link::over_pole);
      return ok();
    }
    return follow(point, first);
  }

  std::uint8_t pole_at(const kinematics::RotarySolutions& solutions) {
    if (model_.rotary_count == 0 || (model_.rotary_count == 1 && solutions.first_is_free)) return 1;
    if (model_.rotary_count == 1) return 0;
    const double from_zero_rad = solutions.gamma_rad;
    const double from_pi_rad = pi - solutions.gamma_rad;
    if (zone_.at_zero && from_zero_rad <= zone_.radius_rad) return use_freedom(from_zero_rad, 1);
    if (zone_.at_pi && from_pi_rad <= zone_.radius_rad) return use_freedom(from_pi_rad, 2);
    return 0;
  }

  std::uint8_t use_freedom(double angle_rad, std::uint8_t pole) {
    found_.largest_freedom_rad = std::max(found_.largest_freedom_rad, angle_rad);
    return pole;
  }

  /// Both values moved by whole turns to the last ones before a passage of the pole.
  std::array<double, 2> near_before(std::array<double, 2> first) const {
    const double before = found_.first_of(*last_off_pole_, 0);
    for (double& value : first) value += 2.0 * pi * std::round((before - value) / (2.0 * pi));
    return first;
  }

  void store(std::uint32_t point, const std::array<double, 2>& first, Link link) {
    for (std::size_t branch = 0; branch < static_cast<std::size_t>(found_.branches); ++branch)
      found_.first_rad[branch][row(point)] = first[branch];
    found_.link[row(point)] = link;
    last_off_pole_ = point;
  }

  /// From the point before, which is off the pole too.
  Status follow(std::uint32_t point, std::array<double, 2> first) {
    std::array<double, 2> step{};
    bool plain = true;
    for (std::size_t branch = 0; branch < static_cast<std::size_t>(found_.branches); ++branch) {
      step[branch] = wrapped_rad(first[branch] - found_.first_rad[branch][row(point) - 1]);
      plain = plain && std::abs(step[branch]) <= plain_step_rad;
    }
    if (!plain) {
      const AxisTurn turn{tool_path_.axis_wp[point - 1], tool_path_.axis_wp[point]};
      if (turn.angle_rad > largest_turn_rad) {
        if (tool_path_.move[point] != path::Move::rapid) return half_turn(point, turn.angle_rad);
        store(point, near_before(first), Link::broken);
        return ok();
      }
      if (const auto crossing = crossing_of(point, turn)) {
        found_.crossings.push_back(*crossing);
        store(point, near_before(first), Link::over_pole);
        return ok();
      }
      for (int branch = 0; branch < found_.branches; ++branch) {
        const auto index = static_cast<std::size_t>(branch);
        const double before = found_.first_rad[index][row(point) - 1];
        const auto followed =
            followed_step(turn, branch, 0.0, before, 1.0, first[index], largest_depth);
        if (!followed) return out_of_reach(point, 0.0);
        step[index] = *followed;
      }
    }
    for (std::size_t branch = 0; branch < static_cast<std::size_t>(found_.branches); ++branch)
      first[branch] = found_.first_rad[branch][row(point) - 1] + step[branch];
    store(point, first, Link::continuous);
    return ok();
  }

  /// Change of the first axis over a part of the turn, by halving until each step is plain.
  std::optional<double> followed_step(const AxisTurn& turn, int branch, double fraction_from,
                                      double first_from, double fraction_to, double first_to,
                                      int depth) const {
    const double step = wrapped_rad(first_to - first_from);
    if (std::abs(step) <= plain_step_rad || depth == 0) return step;
    // The nearest point to the pole parts a swift turn best.
    const double nearest = turn.nearest_fraction(
        turn.at(0.5 * (fraction_from + fraction_to)).dot(model_.a) < 0.0 ? Vec3{-model_.a}
                                                                         : model_.a);
    const double margin = 1e-3 * (fraction_to - fraction_from);
    const bool inside = nearest > fraction_from + margin && nearest < fraction_to - margin;
    const double middle = inside ? nearest : 0.5 * (fraction_from + fraction_to);
    const auto solutions = kinematics::inverse_rotary(model_, turn.at(middle), slack_rad_);
    if (solutions.count == 0) return std::nullopt;
    const double first_middle = solutions.branch[static_cast<std::size_t>(branch)].first_rad;
    const auto lower =
        followed_step(turn, branch, fraction_from, first_from, middle, first_middle, depth - 1);
    const auto upper =
        followed_step(turn, branch, middle, first_middle, fraction_to, first_to, depth - 1);
    if (!lower || !upper) return std::nullopt;
    return *lower + *upper;
  }

  std::optional<Candidates::Crossing> crossing_of(std::uint32_t point, const AxisTurn& turn) {
    for (const std::uint8_t pole : {std::uint8_t{1}, std::uint8_t{2}}) {
      if (!(pole == 1 ? zone_.at_zero : zone_.at_pi)) continue;
      const Vec3 direction = pole_axis(model_, pole);
      const double fraction = turn.nearest_fraction(direction);
      if (!(fraction > 0.0 && fraction < 1.0)) continue;
      const double miss_rad = angle_between_rad(turn.at(fraction), direction);
      if (miss_rad > zone_.radius_rad) continue;
      use_freedom(miss_rad, pole);
      return Candidates::Crossing{point, fraction, pole};
    }
    return std::nullopt;
  }

  Problem out_of_reach(std::uint32_t point, double beyond_rad) const {
    const std::uint32_t line = tool_path_.cl_line[point];
    std::string message = "the tool axis " + vector_text(tool_path_.axis_wp[point]) +
                          " at CL line " + std::to_string(line);
    message += beyond_rad > 0.0
                   ? " lies " + number_text(beyond_rad * deg_per_rad, 4) +
                         " deg beyond the reach of the rotary axes"
                   : " is reached only by leaving the reach of the rotary axes on the way";
    return {.code = Code::out_of_reach, .message = std::move(message), .cl_line = line};
  }

  Problem half_turn(std::uint32_t point, double angle_rad) const {
    const std::uint32_t line = tool_path_.cl_line[point];
    return {.code = Code::half_turn,
            .message = "the tool axis turns by " + number_text(angle_rad * deg_per_rad, 3) +
                       " deg in the move to CL line " + std::to_string(line) +
                       "; above 179 deg its way is not defined",
            .cl_line = line};
  }

  const Model& model_;
  const path::ToolPath& tool_path_;
  const PoleZone zone_;
  const double slack_rad_;
  Candidates found_;
  std::optional<std::uint32_t> last_off_pole_;
};

}  // namespace

double axis_freedom_rad(double axis_tolerance_rad, bool flank) {
  // Half of the tolerance is left to the interpolation between the points.
  return flank ? 0.0 : std::min(0.5 * axis_tolerance_rad, largest_freedom_rad);
}

PoleZone pole_zone(const Model& model, double rounding_rad, double freedom_rad) {
  PoleZone zone;
  if (model.rotary_count != 2) return zone;
  const double off_zero_rad = std::abs(model.lambda_rad - model.mu_rad);
  const double off_pi_rad = std::abs(pi - model.lambda_rad - model.mu_rad);
  const double bound_rad = std::max(freedom_rad, least_radius_rad);
  zone.at_zero = off_zero_rad <= bound_rad;
  zone.at_pi = off_pi_rad <= bound_rad;
  double wanted_rad = std::max(rounding_rad, least_radius_rad);
  if (zone.at_zero) wanted_rad = std::max(wanted_rad, off_zero_rad);
  if (zone.at_pi) wanted_rad = std::max(wanted_rad, off_pi_rad);
  zone.radius_rad = std::min(wanted_rad, bound_rad);
  return zone;
}

Vec3 pole_axis(const Model& model, std::uint8_t pole) {
  return (pole == 1) == model.a_flipped ? Vec3{-model.a} : model.a;
}

double second_at_pole_rad(const Model& model, std::uint8_t pole, int branch) {
  if (pole == 1) return model.beta_zero_rad;
  return model.beta_zero_rad + (branch == 0 ? pi : -pi);
}

double first_at_pole_rad(const Model& model, std::uint8_t pole, const Vec3& towards, int branch) {
  const Vec3 axis = pole_axis(model, pole);
  const Vec3 beside = (towards - axis * axis.dot(towards)).normalized();
  // Where lambda and mu differ, the first axis swings by a right angle just off the pole: look
  // beyond.
  const double off_pole_rad = pole == 1 ? std::abs(model.lambda_rad - model.mu_rad)
                                        : std::abs(pi - model.lambda_rad - model.mu_rad);
  const double tilt_rad = std::max(beside_pole_rad, 100.0 * off_pole_rad);
  const Vec3 near_axis = std::cos(tilt_rad) * axis + std::sin(tilt_rad) * beside;
  return kinematics::inverse_rotary(model, near_axis, off_pole_rad)
      .branch[static_cast<std::size_t>(branch)]
      .first_rad;
}

Result<Candidates> find_candidates(const Model& model, const path::ToolPath& tool_path,
                                   PointRange range, const PoleZone& zone, double slack_rad) {
  return Search{model, tool_path, range, zone, slack_rad}.run();
}

}  // namespace pentapost::plan
