#include "pentapost/jobs/setup_steps.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>

namespace pentapost::jobs {
namespace {

/// In CL coordinates as they lie on the table with all axes at zero.
std::string turn_step(double turn_deg) {
  if (turn_deg == 0.0)
    return "Lay the part on the table as the CL file has it; don't turn it about Z.";
  return "Turn the part by " + number_text(std::abs(turn_deg)) +
         " deg about the Z axis of the machine, " +
         (turn_deg > 0.0 ? "counterclockwise" : "clockwise") + " seen from above (" +
         (turn_deg > 0.0 ? "+" : "-") + number_text(std::abs(turn_deg)) +
         " deg, right-handed about +Z).";
}

std::string tilt_step(double tilt_deg) {
  if (tilt_deg == 0.0) return "Don't tilt it.";
  return "Then tilt it by " + number_text(std::abs(tilt_deg)) +
         " deg about the X axis of the machine, so that its side towards +Y " +
         (tilt_deg > 0.0 ? "rises" : "sinks") + " (" + (tilt_deg > 0.0 ? "+" : "-") +
         number_text(std::abs(tilt_deg)) + " deg, right-handed about +X).";
}

std::string datum_step(const Setup& setup) {
  if (!setup.origin_mm)
    return "Measure the CL origin again as the part lies now: it is the work offset.";
  const Vec3& origin_mm = *setup.origin_mm;
  return "The CL origin is then the work offset: X " + number_text(origin_mm.x()) + ", Y " +
         number_text(origin_mm.y()) + ", Z " + number_text(origin_mm.z()) +
         " mm in the machine's coordinates with all axes at zero.";
}

}  // namespace

std::vector<std::string> setup_steps(const Setup& setup) {
  return {turn_step(-setup.theta_z_deg), tilt_step(-setup.theta_x_deg), datum_step(setup),
          "Post the CL file unchanged with this setup; the program's X, Y and Z are those of the "
          "part as it lies now."};
}

}  // namespace pentapost::jobs
