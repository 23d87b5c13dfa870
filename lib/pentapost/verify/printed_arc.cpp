#include "pentapost/verify/printed_arc.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>

namespace pentapost::verify {
namespace {

constexpr double length_rounding = 1e-9;
/// More turns than this are no arc that a CL file holds.
constexpr int most_turns = 100'000;

/// Angle from one arm to the other about +Z, in [0, 2 pi).
double angle_about_z_rad(const Vec3& from, const Vec3& to) {
  const double angle_rad =
      std::atan2(from.x() * to.y() - from.y() * to.x(), from.x() * to.x() + from.y() * to.y());
  return angle_rad < 0.0 ? angle_rad + 2.0 * pi : angle_rad;
}

}  // namespace

std::optional<path::Segment> printed_arc(const nc::ReadMotion& motion, const Stop& from,
                                         const Stop& to, const Mat3& to_cl, std::string& wrong) {
  if ((to_cl * to_cl.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() > length_rounding) {
    wrong = "an arc on linear axes that do not stand square";
    return std::nullopt;
  }
  if (from.joints.first_rad != to.joints.first_rad ||
      from.joints.second_rad != to.joints.second_rad) {
    wrong = "a rotary axis moves within an arc";
    return std::nullopt;
  }
  if (motion.whole_turns < 0 || motion.whole_turns > most_turns) {
    wrong = "an arc of " + std::to_string(motion.whole_turns) + " whole turns";
    return std::nullopt;
  }
  const Vec3& start = from.joints.linear_mm;
  const Vec3 centre{motion.centre_x_mm, motion.centre_y_mm, start.z()};
  const Vec3 arm_from = start - centre, arm_to = to.joints.linear_mm - centre;
  const double way_rad =
      motion.clockwise ? angle_about_z_rad(arm_to, arm_from) : angle_about_z_rad(arm_from, arm_to);
  const double sweep_rad = way_rad + 2.0 * pi * motion.whole_turns;
  if (!(sweep_rad > 0.0)) {
    wrong = "an arc without a way";
    return std::nullopt;
  }
  const Vec3 normal{0.0, 0.0, motion.clockwise ? -1.0 : 1.0};
  // A normal is no vector of the plane: it changes sides where the words are left-handed.
  const double side = to_cl.determinant() < 0.0 ? -1.0 : 1.0;
  const path::Arc arc{.centre_wp_mm = from.station.tip_mm - to_cl * arm_from,
                      .normal_wp = side * (to_cl * normal),
                      .sweep_rad = sweep_rad};
  return path::Segment{from.station.tip_mm, from.station.axis, to.station.tip_mm, to.station.axis,
                       &arc};
}

std::string wrong_turning(const path::Segment& printed, const path::Segment& move,
                          double part_of_move) {
  if (!move.is_arc()) return {};
  if (!(printed.normal().dot(move.normal()) > 0.0)) return "the arc runs in the wrong sense";
  const double expected_rad = part_of_move * move.sweep_rad();
  if (!(std::abs(printed.sweep_rad() - expected_rad) < pi))
    return "the arc turns by " + number_text(printed.sweep_rad() * deg_per_rad, 6) +
           " deg, expected are " + number_text(expected_rad * deg_per_rad, 6) + " deg";
  return {};
}

}  // namespace pentapost::verify
