#include "pentapost/cl/interpreter.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pentapost::cl {
namespace {

constexpr double farthest_mm = 1e9;

Vec3 tip_of(const Coordinates& found) { return {found.value[0], found.value[1], found.value[2]}; }
Vec3 axis_of(const Coordinates& found) { return {found.value[3], found.value[4], found.value[5]}; }

bool is_point(const Coordinates& found) {
  return found.fault == Coordinates::Fault::none && (found.count == 3 || found.count == 6);
}

}  // namespace

void Interpreter::report_damage(Severity severity, Code code, std::string_view expected) {
  report(severity, code, [&] {
    return quoted_excerpt(statement_->text) + " is damaged: expected " + std::string{expected} +
           ".";
  });
}

void Interpreter::report_coordinates(const Coordinates& found, std::string_view expected) {
  const bool finite = found.fault != Coordinates::Fault::not_finite;
  report(Severity::error, finite ? Code::damaged_motion : Code::bad_number, [&] {
    std::string text = quoted_excerpt(statement_->text);
    if (!finite) return text + " holds a number that is not finite.";
    text += " is damaged: expected " + std::string{expected};
    if (found.fault == Coordinates::Fault::none)
      return text + ", found " + std::to_string(found.count) + " numbers.";
    return text + ", number " + std::to_string(found.count + 1) + " is not readable.";
  });
}

bool Interpreter::is_in_range(const Vec3& tip_mm) {
  if (tip_mm.cwiseAbs().maxCoeff() <= farthest_mm) return true;
  report(Severity::error, Code::bad_number,
         [&] { return quoted_excerpt(statement_->text) + " holds a coordinate beyond 1e9 mm."; });
  return false;
}

bool Interpreter::set_axis(const Vec3& written) {
  const double squared = written.squaredNorm();
  if (squared == 1.0) {
    axis_ = written;
    return true;
  }
  const double length = std::isfinite(squared) ? std::sqrt(squared) : written.stableNorm();
  constexpr double shortest = 1e-6, unit_tolerance = 1e-3;
  if (!(length > shortest) || !std::isfinite(length)) {
    report(Severity::error, Code::zero_tool_axis, [&] {
      return quoted_excerpt(statement_->text) + " has a tool axis vector without a direction.";
    });
    return false;
  }
  if (std::abs(length - 1.0) > unit_tolerance) {
    report(Severity::warning, Code::axis_not_unit, [&] {
      return quoted_excerpt(statement_->text) + " has a tool axis vector of length " +
             number_text(length, 6) + " instead of 1: its direction was taken.";
    });
  }
  axis_length_error_ = std::max(axis_length_error_, std::abs(length - 1.0));
  axis_ = written / length;
  return true;
}

void Interpreter::go_to(std::string_view coordinates) {
  ++result_.points;
  const Coordinates found = read_coordinates(coordinates);
  if (!is_point(found)) {
    report_coordinates(found, "3 or 6 numbers");
    arc_.reset();
    return;
  }
  tip_decimals_ = std::max(tip_decimals_, found.tip_decimals);
  if (found.count == 6) {
    axis_decimals_ = std::max(axis_decimals_, found.axis_decimals);
    axis_written_ = true;
    if (!set_axis(axis_of(found))) return;
  }
  const Vec3 tip_mm = mm_ * tip_of(found);
  if (is_in_range(tip_mm)) move_to(tip_mm);
}

void Interpreter::go_to_statement(const Major& major) {
  if (major.slash) return go_to(major.rest);
  ++result_.points;
  report_damage(Severity::error, Code::damaged_motion, "\"/\" behind GOTO");
}

void Interpreter::from(const Major& major) {
  const Coordinates found = read_coordinates(major.rest);
  if (!major.slash || !is_point(found))
    return report_coordinates(found, "FROM / and 3 or 6 numbers");
  if (found.count == 6 && !set_axis(axis_of(found))) return;
  const Vec3 tip_mm = mm_ * tip_of(found);
  if (!is_in_range(tip_mm)) return;
  tip_mm_ = tip_mm;
  tip_is_known_ = true;
  path_.add_event(line_, path::StartPoint{tip_mm, axis_});
}

void Interpreter::go_delta(const Major& major) {
  const Coordinates found = read_coordinates(major.rest);
  const bool along_axis = found.fault == Coordinates::Fault::none && found.count == 1;
  if (!major.slash || !(along_axis || is_point(found)))
    return report_coordinates(found, "GODLTA / and 1, 3 or 6 numbers");
  if (!tip_is_known_)
    return report_damage(Severity::error, Code::damaged_motion, "a point before it to start from");
  if (found.count == 6 && !set_axis(axis_of(found))) return;
  const Vec3 step = along_axis ? Vec3{found.value[0] * axis_} : tip_of(found);
  const Vec3 tip_mm = tip_mm_ + mm_ * step;
  if (is_in_range(tip_mm)) move_to(tip_mm);
}

void Interpreter::go_home(const Major&) {
  drop_arc();
  path_.add_event(line_, path::GoHome{});
  tip_is_known_ = false;
}

void Interpreter::rapid(const Major&) { rapid_ = true; }

void Interpreter::tool_axis(const Major& major) {
  const Coordinates found = read_coordinates(major.rest);
  if (found.fault != Coordinates::Fault::none || found.count != 3)
    return report_coordinates(found, "TLAXIS / and 3 numbers");
  set_axis(tip_of(found));
}

void Interpreter::multax(const Major& major) {
  words_.read(major.rest);
  if (words_.has("OFF")) axis_ = Vec3::UnitZ();
}

void Interpreter::unreadable_motion(const Major&) {
  report(Severity::error, Code::damaged_motion, [&] {
    return quoted_excerpt(statement_->text) +
           " is a motion along part surfaces, which CL data of points cannot hold: expected GOTO.";
  });
}

/// RETRCT and PLUNGE go to and from a clearance plane, which CL data of points do not hold.
void Interpreter::clearance_motion(const Major& major) {
  words_.read(major.rest);
  if (words_.has("ON") || words_.has("OFF")) return without_effect(major);
  report_damage(Severity::error, Code::damaged_motion, "a GOTO to the place that it leads to");
}

/// Statements that move or turn the frame of the points behind them. Leaving one out would put all
/// of these points in another place; one that changes nothing is harmless.
void Interpreter::frame_change(const Major& major) {
  words_.read(major.rest);
  const auto numbers = words_.numbers();
  const std::vector<double> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  const bool all_zero = !numbers.empty() && std::all_of(numbers.begin(), numbers.end(),
                                                        [](double n) { return n == 0.0; });
  const bool ends = words_.has("NOMORE") || words_.has("OFF");
  const bool changes_nothing = ends || all_zero || numbers == identity;
  if (changes_nothing && !words_.has_damage()) return without_effect(major);
  report(Severity::error, Code::damaged_motion, [&] {
    return quoted_excerpt(statement_->text) +
           " changes the frame of the points behind it, which is not understood: expected all "
           "points in one frame.";
  });
}

void Interpreter::coordinate_mode(const Major& major) {
  words_.read(major.rest);
  if (words_.has("INCR") || words_.has("INCREM")) {
    report(Severity::error, Code::damaged_motion, [&] {
      return quoted_excerpt(statement_->text) +
             " asks for incremental coordinates: expected absolute ones.";
    });
  }
}

void Interpreter::add_feed_point(const Vec3& tip_mm) {
  if (!feed_is_known_ && !no_feed_reported_) {
    no_feed_reported_ = true;
    report(Severity::warning, Code::no_feed,
           [] { return std::string{"The first cutting motion has no feed before it."}; });
  }
  path_.add_point(tip_mm, axis_, line_, path::Move::feed);
}

void Interpreter::move_to(const Vec3& tip_mm) {
  if (cycle_is_on_) {
    add_hole(tip_mm);
  } else {
    if (arc_) finish_arc(tip_mm);
    if (rapid_)
      path_.add_point(tip_mm, axis_, line_, path::Move::rapid);
    else
      add_feed_point(tip_mm);
  }
  rapid_ = false;
  tip_mm_ = tip_mm;
  tip_is_known_ = true;
}

double Interpreter::resolution_mm() const {
  // Fewer digits are exact rather than rounded.
  constexpr int fewest_decimals = 3;
  return std::max(1e-9, mm_ * std::pow(10.0, -std::max(fewest_decimals, tip_decimals_)));
}

double Interpreter::axis_rounding_rad() const {
  // Few digits and unit length all the same: such axes (0, 0.6, 0.8) were not rounded.
  constexpr int few_decimals = 4;
  constexpr double exact = 1e-9;
  if (!axis_written_ || axis_decimals_ == 0) return 0.0;
  if (axis_decimals_ <= few_decimals && axis_length_error_ < exact) return 0.0;
  return 2.0 * std::pow(10.0, -axis_decimals_);
}

}  // namespace pentapost::cl
