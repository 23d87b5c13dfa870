#pragma once

#include "pentapost/core/units.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::cl {

/// The statements of one NURBS block as they come in: NURBS/, KNOT/ and CNTRL/.
///
/// The degree follows from the counts (knots - control points - 1). Control points have 3 values, 4
/// with a weight, 6 with a tool axis or 7 with both.
struct NurbsBlock {
  std::uint32_t line = 0;      ///< of the NURBS statement
  std::vector<double> header;  ///< numbers of the NURBS statement
  std::vector<double> knots;
  std::vector<double> controls;     ///< numbers of all CNTRL statements
  std::size_t values_in_first = 0;  ///< of the first CNTRL statement
  std::size_t control_statements = 0;
  bool damaged = false;  ///< a number of it could not be read

  void add_header(std::string_view text) { damaged |= !append_numbers(text, header); }
  void add_knots(std::string_view text) { damaged |= !append_numbers(text, knots); }
  void add_controls(std::string_view text);

 private:
  static bool append_numbers(std::string_view text, std::vector<double>& numbers);
};

/// A point of the divided curve.
struct CurvePoint {
  Vec3 tip_mm;
  std::optional<Vec3> axis;  ///< unit; nullopt where the curve has no tool axis
};

/// A curve divided into chords, or why there is none.
struct DividedCurve {
  std::vector<CurvePoint> points;  ///< first and last are the curve's ends
  std::string fault;               ///< not empty: bad_nurbs
};

/// @param chord_error_mm  most distance between curve and chord; tool axes differ from the even
///                        turn between two points by at most 1e-4 rad.
/// @param most_points  more are a fault.
DividedCurve divide_nurbs(const NurbsBlock& block, double mm_per_unit, double chord_error_mm,
                          std::size_t most_points);

}  // namespace pentapost::cl
