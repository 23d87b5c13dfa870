#include "pentapost/plan/native_arc.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/kinematics/forward.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {
namespace {

constexpr double direction_tolerance = 1e-9;  ///< of unit vectors that are to be the same
constexpr double largest_single_sweep_rad = 350.0 * rad_per_deg;
constexpr double smallest_radius_digits = 10.0;
constexpr double largest_sweep_error_rad = pi / 4.0;
/// Far above any real need, so that no input exhausts the memory.
constexpr double largest_sweep_rad = 1e5 * pi;

/// How a displacement of the tip shows in the linear words; nullopt: not as a rigid motion.
std::optional<Mat3> words_from_tip(const kinematics::Model& model, const Settings& settings,
                                   const RotaryPair& printed, double gauge_mm) {
  if (settings.output == Output::tcp) return Mat3::Identity();
  const Mat3 matrix =
      kinematics::linear_map(model, printed.first_rad, printed.second_rad, gauge_mm).matrix;
  const Mat3 product = matrix.transpose() * matrix;
  if ((product - Mat3::Identity()).cwiseAbs().maxCoeff() > direction_tolerance) return std::nullopt;
  return matrix.transpose();
}

/// Words of a point on the arc's plane, mm.
Eigen::Vector2d plane_words(const Posture& posture, int decimals_mm) {
  return {decimal_value(posture.word[0], decimals_mm), decimal_value(posture.word[1], decimals_mm)};
}

/// The centre moved onto the bisector of the printed ends, so that both radii are the same.
Eigen::Vector2d equal_radius_centre(const Eigen::Vector2d& start, const Eigen::Vector2d& end,
                                    const Eigen::Vector2d& centre) {
  const Eigen::Vector2d chord = end - start;
  const double square = chord.squaredNorm();
  if (square == 0.0) return centre;
  return centre - chord * (chord.dot(centre - 0.5 * (start + end)) / square);
}

/// From one arm to another, in the sense of the arc; 0 to 2 pi.
double swept_rad(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool clockwise) {
  const double turn_rad = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  const double way_rad = clockwise ? -turn_rad : turn_rad;
  return way_rad < 0.0 ? way_rad + 2.0 * pi : way_rad;
}

}  // namespace

std::optional<std::vector<ArcPiece>> native_arc(const kinematics::Model& model,
                                                const Settings& settings, BlockMaker& maker,
                                                const path::Segment& segment,
                                                const RotaryPair& rotary, const Posture& from,
                                                std::uint32_t cl_line) {
  if (!settings.arcs || !segment.is_arc() || segment.axis_angle_rad() != 0.0) return std::nullopt;
  if (segment.normal().cross(segment.axis_from()).norm() > 1e-6) return std::nullopt;
  if (settings.output == Output::tcp && model.rotary_count > 0 && !settings.arcs_with_tcp)
    return std::nullopt;
  const auto turn = words_from_tip(model, settings, from.printed, maker.gauge_in_words_mm());
  if (!turn) return std::nullopt;
  const Vec3 normal_words = *turn * segment.normal();
  if (normal_words.cross(Vec3::UnitZ()).norm() > 1e-6) return std::nullopt;
  // Mirrored words run the other way round.
  const bool clockwise = normal_words.z() * turn->determinant() < 0.0;

  const double sweep_rad = segment.sweep_rad();
  if (!(sweep_rad <= largest_sweep_rad)) return std::nullopt;
  const int count =
      sweep_rad > largest_single_sweep_rad ? static_cast<int>(std::ceil(sweep_rad / pi)) : 1;
  std::vector<ArcPiece> pieces;
  Posture start = from;
  double fraction_from = 0.0;
  for (int i = 1; i <= count; ++i) {
    ArcPiece piece;
    piece.fraction = i == count ? 1.0 : static_cast<double>(i) / count;
    piece.clockwise = clockwise;
    auto posture = maker.posture(segment.tip_mm(piece.fraction), rotary, cl_line);
    if (!posture) return std::nullopt;
    piece.posture = *posture;

    const Eigen::Vector2d start_words = plane_words(start, settings.decimals_mm);
    const Eigen::Vector2d end_words = plane_words(piece.posture, settings.decimals_mm);
    if (start_words == end_words) return std::nullopt;
    if (!settings.helices && start.word[2] != piece.posture.word[2]) return std::nullopt;
    const Vec3 to_centre = -(*turn * segment.arm_mm(fraction_from));
    const Eigen::Vector2d centre = equal_radius_centre(
        start_words, end_words, start_words + Eigen::Vector2d{to_centre.x(), to_centre.y()});
    piece.centre.i = decimal_count(centre.x() - start_words.x(), settings.decimals_mm);
    piece.centre.j = decimal_count(centre.y() - start_words.y(), settings.decimals_mm);

    // Both centre and radius as the control will have them, against the CL arc.
    const Eigen::Vector2d printed_centre{
        start_words.x() + decimal_value(piece.centre.i, settings.decimals_mm),
        start_words.y() + decimal_value(piece.centre.j, settings.decimals_mm)};
    const Eigen::Vector2d asked_centre =
        start_words + Eigen::Vector2d{to_centre.x(), to_centre.y()};
    const double off_centre_mm = (printed_centre - asked_centre).norm();
    const double start_radius_mm = (start_words - printed_centre).norm();
    const double off_radius_mm =
        std::max({std::abs(start_radius_mm - (end_words - printed_centre).norm()),
                  std::abs(start_radius_mm - segment.largest_radius_mm()),
                  std::abs(start_radius_mm - segment.smallest_radius_mm())});
    const double rounding_mm = std::pow(10.0, -settings.decimals_mm);
    if (start_radius_mm < smallest_radius_digits * rounding_mm) return std::nullopt;
    if (off_centre_mm + off_radius_mm + rounding_mm > 0.9 * settings.tip_tolerance_mm)
      return std::nullopt;
    // The digits of a tiny arc may turn its chord round, and with it a small sweep into a whole
    // turn.
    const double asked_rad = (piece.fraction - fraction_from) * sweep_rad;
    const double printed_rad =
        swept_rad(start_words - printed_centre, end_words - printed_centre, clockwise);
    if (std::abs(printed_rad - asked_rad) > largest_sweep_error_rad) return std::nullopt;
    pieces.push_back(piece);
    start = piece.posture;
    fraction_from = piece.fraction;
  }
  return pieces;
}

}  // namespace pentapost::plan
