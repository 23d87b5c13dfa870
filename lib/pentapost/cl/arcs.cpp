#include "pentapost/cl/arcs.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::cl {
namespace {

constexpr int most_turns = 1000;
constexpr double whole_turn_rad = 2.0 * pi;
/// Radii of a file with four decimals differ by some 1e-4; more than this is a wrong arc.
constexpr double radius_warning_ratio = 0.005, radius_warning_mm = 0.02;
constexpr double radius_error_ratio = 0.10, radius_error_mm = 0.2;
/// A stated angle is the geometry's when it differs by less.
constexpr double same_angle_rad = 0.01;

std::optional<ArcSense> sense_by_word(const Words& words) {
  for (const Word& word : words) {
    if (word.is("CCLW") || word.is("COUNTERCLOCKWISE") || word.is("CCW"))
      return ArcSense::right_handed;
    if (word.is("CLW") || word.is("CLOCKWISE") || word.is("CW")) return ArcSense::left_handed;
  }
  return std::nullopt;
}

/// The numbers before the first word that takes a number of its own.
std::vector<double> leading_numbers(const Words& words) {
  std::vector<double> numbers;
  for (const Word& word : words) {
    if (word.is("TIMES") || word.is("ANGLE")) break;
    if (word.is_number()) numbers.push_back(word.number);
  }
  return numbers;
}

/// Turn from `from` to `to` about `normal`, right-handed, in [0, 2 pi).
double turn_rad(const Vec3& normal, const Vec3& from, const Vec3& to) {
  const double angle_rad = std::atan2(normal.dot(from.cross(to)), from.dot(to));
  return angle_rad < 0.0 ? angle_rad + whole_turn_rad : angle_rad;
}

std::string length_text(double length_mm) { return number_text(length_mm, 4) + " mm"; }

/// Reports radii that disagree; true: so much that there is no arc.
bool radii_disagree(const ArcStatement& statement, double start_mm, double end_mm, MadeArc& made) {
  const double stated_mm = statement.radius_mm.value_or(start_mm);
  const double spread_mm =
      std::max({start_mm, end_mm, stated_mm}) - std::min({start_mm, end_mm, stated_mm});
  if (spread_mm <= std::max(radius_warning_mm, radius_warning_ratio * start_mm)) return false;
  made.is_error = spread_mm > std::max(radius_error_mm, radius_error_ratio * start_mm);
  made.remark = "The arc starts " + length_text(start_mm) + " and ends " + length_text(end_mm) +
                " from its centre";
  if (statement.radius_mm) made.remark += ", its stated radius is " + length_text(stated_mm);
  made.remark += ".";
  return made.is_error;
}

/// Sweep of an arc whose statement gives the angle; sets the normal, and `made` where they
/// disagree.
double sweep_by_angle_rad(double angle_rad, double right_rad, Vec3& normal, MadeArc& made) {
  const auto fits = [&](double turn) {
    return std::abs(wrapped_rad(angle_rad - turn)) < same_angle_rad;
  };
  const bool right_fits = fits(right_rad), left_fits = fits(-right_rad);
  if (right_fits && left_fits && std::abs(wrapped_rad(right_rad)) > 1.0) made.sense_is_open = true;
  if (!right_fits && left_fits) {
    // Older APT writers leave the vector as it is for clockwise arcs.
    normal = -normal;
    right_rad = whole_turn_rad - right_rad;
  } else if (!right_fits) {
    made.remark = "The arc turns by " + number_text(right_rad * deg_per_rad, 3) +
                  " deg, its stated angle is " + number_text(angle_rad * deg_per_rad, 3) + " deg.";
    return right_rad;
  }
  return right_rad + whole_turn_rad * std::round((angle_rad - right_rad) / whole_turn_rad);
}

}  // namespace

std::optional<ArcStatement> read_arc(const Words& words, ArcSense sense, double mm_per_unit,
                                     std::string& fault) {
  if (words.has_damage()) {
    fault = "a number is damaged";
    return std::nullopt;
  }
  const std::vector<double> numbers = leading_numbers(words);
  if (numbers.size() != 4 && numbers.size() < 6) {
    fault = "expected centre, vector and radius (6 numbers or more), found " +
            std::to_string(numbers.size());
    return std::nullopt;
  }
  ArcStatement statement;
  statement.centre_mm = mm_per_unit * Vec3{numbers[0], numbers[1], numbers[2]};
  if (numbers.size() >= 6) statement.vector = Vec3{numbers[3], numbers[4], numbers[5]};
  const double length = statement.vector.stableNorm();
  if (!(length > 1e-6) || !std::isfinite(length) || !statement.centre_mm.allFinite()) {
    fault = "the vector has no direction";
    return std::nullopt;
  }
  statement.vector /= length;
  if (numbers.size() == 4 || numbers.size() >= 7)
    statement.radius_mm = mm_per_unit * numbers[numbers.size() == 4 ? 3 : 6];
  statement.sense = sense_by_word(words).value_or(sense);
  if (const auto times = words.number_after("TIMES")) {
    if (!(*times >= 1.0 && *times <= most_turns && *times == std::floor(*times))) {
      fault = "TIMES must be a whole number from 1 to " + std::to_string(most_turns);
      return std::nullopt;
    }
    statement.turns = static_cast<int>(*times);
  }
  if (const auto angle_deg = words.number_after("ANGLE")) {
    if (!(std::abs(*angle_deg) > 0.0 && std::abs(*angle_deg) <= 360.0 * most_turns)) {
      fault = "ANGLE must not be 0 nor more than " + std::to_string(most_turns) + " turns";
      return std::nullopt;
    }
    statement.angle_rad = std::abs(*angle_deg) * rad_per_deg;
  }
  return statement;
}

MadeArc make_arc(const ArcStatement& statement, const Vec3& from_mm, const Vec3& to_mm,
                 double resolution_mm) {
  MadeArc made;
  Vec3 normal =
      statement.sense == ArcSense::left_handed ? Vec3{-statement.vector} : statement.vector;
  const auto in_plane = [&](const Vec3& point_mm) -> Vec3 {
    const Vec3 from_centre = point_mm - statement.centre_mm;
    return from_centre - normal.dot(from_centre) * normal;
  };
  const Vec3 start_mm = in_plane(from_mm), end_mm = in_plane(to_mm);
  const double radius_mm = start_mm.norm();
  if (radii_disagree(statement, radius_mm, end_mm.norm(), made)) return made;
  const double chord_mm = (end_mm - start_mm).norm();
  if (std::min(radius_mm, end_mm.norm()) <= 2.0 * resolution_mm) return made;
  double sweep_rad = turn_rad(normal, start_mm, end_mm);
  if (statement.angle_rad) {
    sweep_rad = sweep_by_angle_rad(*statement.angle_rad, sweep_rad, normal, made);
  } else {
    made.sense_is_open = statement.sense == ArcSense::from_neighbours;
    if (chord_mm <= 1e-9 * radius_mm + 1e-9)
      sweep_rad = whole_turn_rad;
    else if (chord_mm <= 2.0 * resolution_mm && statement.turns == 1)
      return made;  // shorter than the file's digits can tell, perhaps backwards: a straight move
    sweep_rad += whole_turn_rad * (statement.turns - 1);
  }
  if (!(sweep_rad > 0.0)) return made;
  made.arc = path::Arc{statement.centre_mm, normal, sweep_rad};
  return made;
}

path::Arc reversed(const path::Arc& arc) {
  const double turns_before = std::ceil(arc.sweep_rad / whole_turn_rad - 1e-12) - 1.0;
  const double part_rad = arc.sweep_rad - whole_turn_rad * turns_before;
  const double other_rad = whole_turn_rad - part_rad;
  const bool is_whole = other_rad < 1e-12;
  return {arc.centre_wp_mm, -arc.normal_wp,
          (is_whole ? whole_turn_rad : other_rad) + whole_turn_rad * turns_before};
}

Vec3 arc_tangent(const path::Arc& arc, const Vec3& point_mm) {
  return arc.normal_wp.cross(point_mm - arc.centre_wp_mm).normalized();
}

}  // namespace pentapost::cl
