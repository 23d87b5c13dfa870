#include "five_axis_cl.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/core/units.hpp"

#include <array>
#include <cmath>

namespace pentapost::bench {
namespace {

constexpr std::size_t points_a_row = 1000;
constexpr int tip_decimals = 5;
constexpr int axis_decimals = 8;

/// Length of a row up to a point of it: steps of 0.1 to 1 mm, closer where the surface bends.
double along_row_mm(std::size_t column) {
  constexpr double mean_mm = 0.55, swing_mm = 0.45, period = 60.0;
  const auto count = static_cast<double>(column);
  return mean_mm * count + swing_mm * period * (1.0 - std::cos(count / period));
}

/// Tip and tool axis number `index` of the path.
std::array<double, 6> tool_at(std::size_t index) {
  const std::size_t row = index / points_a_row;
  const std::size_t along = index % points_a_row;
  const double u = along_row_mm(row % 2 == 0 ? along : points_a_row - 1 - along) - 275.0;
  const double v = 0.2 * static_cast<double>(row) - 100.0;
  // The rows lie askew, so that every axis moves.
  const double x = 0.8 * u - 0.6 * v;
  const double y = 0.6 * u + 0.8 * v;
  const double z = 12.0 * std::sin(x / 70.0) * std::cos(y / 55.0);
  const double tilt = rad_per_deg * (32.5 + 27.5 * std::sin(x / 60.0 + y / 45.0));
  const double direction = 0.9 + 0.8 * std::sin(x / 80.0) * std::cos(y / 65.0);
  return {x,
          y,
          z,
          std::sin(tilt) * std::cos(direction),
          std::sin(tilt) * std::sin(direction),
          std::cos(tilt)};
}

}  // namespace

std::string five_axis_cl(std::size_t points) {
  std::string text =
      "PARTNO / WAVES\nUNITS / MM\nMULTAX / ON\nLOADTL / 1\nSPINDL / RPM, 12000.0, CLW\n"
      "FEDRAT / 2000.0, MMPM\n";
  text.reserve(text.size() + 80 * points);
  for (std::size_t index = 0; index < points; ++index) {
    const auto numbers = tool_at(index);
    text += "GOTO / ";
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const int decimals = i < 3 ? tip_decimals : axis_decimals;
      if (i > 0) text += ", ";
      append_decimal(text, decimal_count(numbers[i], decimals), decimals, {.trailing_zeros = true});
    }
    text += '\n';
  }
  return text += "SPINDL / OFF\nFINI\n";
}

}  // namespace pentapost::bench
