#include "five_axis_cl.hpp"

#include "pentapost/core/number_text.hpp"

#include <array>
#include <cmath>

namespace pentapost::bench {
namespace {

constexpr std::size_t points_a_row = 1000;
constexpr double step_mm = 0.2;

/// Tip and tool axis number `index` of the path.
std::array<double, 6> tool_at(std::size_t index) {
  const std::size_t row = index / points_a_row;
  const std::size_t along = index % points_a_row;
  const std::size_t column = row % 2 == 0 ? along : points_a_row - 1 - along;
  const double x = step_mm * static_cast<double>(column) - 100.0;
  const double y = step_mm * static_cast<double>(row % points_a_row) - 100.0;
  const double z = 5.0 * std::sin(x / 20.0) * std::cos(y / 25.0);
  const double slope_x = 0.25 * std::cos(x / 20.0) * std::cos(y / 25.0);
  const double slope_y = -0.2 * std::sin(x / 20.0) * std::sin(y / 25.0);
  const double i = 0.4 - slope_x;
  const double j = 0.2 - slope_y;
  const double length = std::sqrt(i * i + j * j + 1.0);
  return {x, y, z, i / length, j / length, 1.0 / length};
}

}  // namespace

std::string five_axis_cl(std::size_t points) {
  std::string text =
      "PARTNO / WAVES\nUNITS / MM\nMULTAX / ON\nLOADTL / 1\nSPINDL / RPM, 12000.0, CLW\n"
      "FEDRAT / 2000.0, MMPM\n";
  text.reserve(text.size() + 72 * points);
  for (std::size_t index = 0; index < points; ++index) {
    const auto numbers = tool_at(index);
    text += "GOTO / ";
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const int decimals = i < 3 ? 4 : 7;
      if (i > 0) text += ", ";
      append_decimal(text, decimal_count(numbers[i], decimals), decimals, {.trailing_zeros = true});
    }
    text += '\n';
  }
  return text += "SPINDL / OFF\nFINI\n";
}

}  // namespace pentapost::bench
