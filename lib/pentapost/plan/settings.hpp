#pragma once

#include "pentapost/core/output.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/machine/definition.hpp"

#include <map>
#include <string>

namespace pentapost::plan {

/// What the planning must know of the job, the machine and the control.
struct Settings {
  double tip_tolerance_mm = 0.01;
  double axis_tolerance_rad = 0.05 * rad_per_deg;
  bool flank = false;          ///< the tool axis has no freedom at the pole
  double pole_axis_rad = 0.0;  ///< by which the tool axis may be changed to pass through a pole
  Output output = Output::tcp;
  Vec3 origin_mm = Vec3::Zero();               ///< CL origin in the table frame
  bool origin_known = false;                   ///< with a gauge length: linear ranges are checked
  std::map<int, double> gauge_length_mm = {};  ///< by tool number
  machine::Preferences preferences = {};
  std::map<std::string, machine::AxisLimits> limits = {};  ///< by joint name; rad, mm

  // of the control
  int decimals_mm = 3;
  int decimals_deg = 3;
  bool inverse_time = false;          ///< feed of moves with rotary axes and without TCP as 1/time
  double largest_inverse_time = 0.0;  ///< 1/min; 0: no bound
  bool adds_length_always = false;  ///< without TCP the control adds the length of the tool in use
  bool arcs = false;                ///< circular blocks in the plane across Z
  bool helices = false;             ///< arcs that move along Z as well
  bool arcs_with_tcp = false;       ///< arcs while TCP is on
  bool native_cycles = false;
  /// TCP ends after the safe retract: its end may move the axes by the tool length.
  bool retracts_with_tcp = false;
  bool retract_needs_tool = false;   ///< no safe retract before the first tool call
  int feed_decimals = 0;             ///< of feeds per minute
  double largest_feed = 0.0;         ///< per minute; 0: no bound
  double rotary_feed_rad_min = 0.0;  ///< for turning in place where no limit gives one; 0: none
  double retract_mm = 100.0;         ///< along the tool axis, where no travel bounds it
  double plunge_feed_mm_min = 0.0;   ///< 0: the feed that is active
};

}  // namespace pentapost::plan
