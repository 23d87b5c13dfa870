#include "pentapost/cl/nurbs.hpp"

#include "pentapost/cl/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pentapost::cl {
namespace {

constexpr std::size_t highest_degree = 15;
constexpr int deepest_division = 14;  // 2^14 chords a knot span
constexpr double axis_error_rad = 1e-4;

/// Weight and weighted values: x, y, z and, where the curve has one, the tool axis.
using Homogeneous = Eigen::Matrix<double, 7, 1>;

struct Curve {
  std::size_t degree = 0;
  bool has_axis = false;
  std::vector<double> knots;
  std::vector<Homogeneous> controls;
};

CurvePoint project(const Homogeneous& point, bool has_axis) {
  CurvePoint found{point.segment<3>(1) / point[0], std::nullopt};
  if (has_axis) found.axis = point.segment<3>(4).stableNormalized();
  return found;
}

/// De Boor's algorithm on knot span `span`.
CurvePoint evaluate(const Curve& curve, std::size_t span, double u) {
  std::array<Homogeneous, highest_degree + 1> d;
  const std::size_t p = curve.degree;
  for (std::size_t j = 0; j <= p; ++j) d[j] = curve.controls[j + span - p];
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const double left = curve.knots[j + span - p], right = curve.knots[j + 1 + span - r];
      const double alpha = right > left ? (u - left) / (right - left) : 0.0;
      d[j] = (1.0 - alpha) * d[j - 1] + alpha * d[j];
    }
  }
  return project(d[p], curve.has_axis);
}

/// Divides one knot span by halving until chords are close enough.
class SpanDivision {
 public:
  SpanDivision(const Curve& curve, std::size_t span, double chord_error_mm, std::size_t most_points,
               DividedCurve& divided)
      : curve_{curve},
        span_{span},
        chord_error_mm_{chord_error_mm},
        most_points_{most_points},
        divided_{divided} {}

  void divide(double from, const CurvePoint& start, double to, const CurvePoint& end, int depth) {
    if (divided_.points.size() >= most_points_ || depth > deepest_division) {
      divided_.fault = "it needs too many points";
      return;
    }
    const double middle = 0.5 * (from + to);
    const CurvePoint centre = evaluate(curve_, span_, middle);
    // An S-shaped piece may meet its chord in the middle: the quarters tell, and no piece is longer
    // than half a span.
    const bool is_close = depth > 0 && near_chord(centre, start, end) &&
                          near_chord(evaluate(curve_, span_, 0.5 * (from + middle)), start, end) &&
                          near_chord(evaluate(curve_, span_, 0.5 * (middle + to)), start, end);
    if (is_close) {
      divided_.points.push_back(end);
      return;
    }
    divide(from, start, middle, centre, depth + 1);
    if (divided_.fault.empty()) divide(middle, centre, to, end, depth + 1);
  }

 private:
  bool near_chord(const CurvePoint& point, const CurvePoint& start, const CurvePoint& end) const {
    const Vec3 chord = end.tip_mm - start.tip_mm;
    const double squared = chord.squaredNorm();
    const double t = squared > 0.0
                         ? std::clamp(chord.dot(point.tip_mm - start.tip_mm) / squared, 0.0, 1.0)
                         : 0.0;
    // Half of what is allowed: three points do not see the largest distance.
    if (!((point.tip_mm - start.tip_mm - t * chord).norm() <= 0.5 * chord_error_mm_)) return false;
    if (!curve_.has_axis) return true;
    const double whole_rad = angle_between_rad(*start.axis, *end.axis);
    const Vec3 even = whole_rad < 1e-9 ? *start.axis
                                       : Vec3{(std::sin((1.0 - t) * whole_rad) * *start.axis +
                                               std::sin(t * whole_rad) * *end.axis) /
                                              std::sin(whole_rad)};
    return (even - *point.axis).norm() <= 0.5 * axis_error_rad;
  }

  const Curve& curve_;
  std::size_t span_;
  double chord_error_mm_;
  std::size_t most_points_;
  DividedCurve& divided_;
};

/// Values of one control point: 3, 4, 6 or 7; 0: the numbers do not tell.
std::size_t values_of_control(const NurbsBlock& block) {
  if (block.control_statements > 1 || block.values_in_first <= 7) {
    const std::size_t values = block.values_in_first;
    const bool is_even = block.controls.size() == values * block.control_statements;
    if (is_even && (values == 3 || values == 4 || values == 6 || values == 7)) return values;
  }
  // Several points a statement: the count of points is among the header's numbers.
  for (const std::size_t values : std::array<std::size_t, 4>{3, 4, 6, 7}) {
    const double count = static_cast<double>(block.controls.size()) / static_cast<double>(values);
    for (const double number : block.header)
      if (number == count && count < static_cast<double>(block.knots.size())) return values;
  }
  const bool threes = block.header.empty() && block.controls.size() % 3 == 0;
  return threes ? 3 : 0;
}

std::string fill_controls(const NurbsBlock& block, double mm_per_unit, Curve& curve) {
  const std::size_t values = values_of_control(block);
  if (values == 0) return "its control points have neither 3, 4, 6 nor 7 values each";
  curve.has_axis = values >= 6;
  const bool has_weight = values == 4 || values == 7;
  for (std::size_t i = 0; i + values <= block.controls.size(); i += values) {
    const double weight = has_weight ? block.controls[i + values - 1] : 1.0;
    if (!(weight > 1e-9 && weight < 1e9)) return "a weight is not above 0";
    Homogeneous control = Homogeneous::Zero();
    control[0] = 1.0;
    for (std::size_t k = 0; k < 3; ++k) {
      control[static_cast<Eigen::Index>(1 + k)] = mm_per_unit * block.controls[i + k];
      if (curve.has_axis) control[static_cast<Eigen::Index>(4 + k)] = block.controls[i + 3 + k];
    }
    if (!(control.cwiseAbs().maxCoeff() < 1e9)) return "a coordinate is beyond 1e9 mm";
    curve.controls.push_back(weight * control);
  }
  return {};
}

std::string make_curve(const NurbsBlock& block, double mm_per_unit, Curve& curve) {
  if (block.damaged) return "a number of it is damaged";
  if (block.controls.empty()) return "it has no control points";
  if (auto fault = fill_controls(block, mm_per_unit, curve); !fault.empty()) return fault;
  const std::size_t controls = curve.controls.size();
  curve.knots = block.knots;
  if (curve.knots.size() < controls + 2 || curve.knots.size() - controls - 1 > highest_degree)
    return "it has " + std::to_string(curve.knots.size()) + " knots for " +
           std::to_string(controls) + " control points";
  curve.degree = curve.knots.size() - controls - 1;
  if (controls <= curve.degree) return "it has fewer control points than its degree needs";
  if (!std::is_sorted(curve.knots.begin(), curve.knots.end())) return "its knots do not rise";
  if (!(curve.knots[controls] - curve.knots[curve.degree] > 0.0)) return "its knots are all equal";
  return {};
}

bool is_usable(const CurvePoint& point) {
  return point.tip_mm.allFinite() && (!point.axis || std::abs(point.axis->norm() - 1.0) < 1e-6);
}

}  // namespace

bool NurbsBlock::append_numbers(std::string_view text, std::vector<double>& numbers) {
  const char* at = text.data();
  const char* const end = at + text.size();
  const auto skip = [&] {
    while (at != end && (is_blank(*at) || *at == ',')) ++at;
  };
  for (skip(); at != end; skip()) {
    const Decimal number = read_decimal(at, end);
    if (number.state != Decimal::State::number) {
      if (!is_letter(*at)) return false;
      while (at != end && *at != ',' && !is_blank(*at)) ++at;
      continue;
    }
    numbers.push_back(number.value);
    at = number.next;
    if (at != end && *at != ',' && !is_blank(*at)) return false;
  }
  return true;
}

void NurbsBlock::add_controls(std::string_view text) {
  const std::size_t before = controls.size();
  damaged |= !append_numbers(text, controls);
  if (control_statements++ == 0) values_in_first = controls.size() - before;
}

DividedCurve divide_nurbs(const NurbsBlock& block, double mm_per_unit, double chord_error_mm,
                          std::size_t most_points) {
  DividedCurve divided;
  Curve curve;
  divided.fault = make_curve(block, mm_per_unit, curve);
  if (!divided.fault.empty()) return divided;
  for (std::size_t span = curve.degree; span < curve.controls.size(); ++span) {
    const double from = curve.knots[span], to = curve.knots[span + 1];
    if (!(to > from)) continue;
    const CurvePoint start = evaluate(curve, span, from), end = evaluate(curve, span, to);
    if (!is_usable(start) || !is_usable(end)) {
      divided.fault = "its tool axis has no direction";
      return divided;
    }
    if (divided.points.empty()) divided.points.push_back(start);
    SpanDivision{curve, span, chord_error_mm, most_points, divided}.divide(from, start, to, end, 0);
    if (!divided.fault.empty()) return divided;
  }
  const bool usable = std::all_of(divided.points.begin(), divided.points.end(), is_usable);
  if (!usable) divided.fault = "its tool axis has no direction";
  return divided;
}

}  // namespace pentapost::cl
