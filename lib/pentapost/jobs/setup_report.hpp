#pragma once

#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/jobs/analysis_report.hpp"
#include "pentapost/jobs/post.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pentapost::jobs {

/// What a reorientation is chosen by.
enum class Objective {
  peak_ratio,     ///< largest demand of any axis over its speed limit
  time,           ///< of the cutting path, slowed down to the speed limits
  rotary_travel,  ///< way of all rotary axes over the cutting path
};

/// A reorientation, signs of Cripps et al. 2017 (lib/README.md section 7).
struct SetupAngles {
  double theta_x_deg = 0.0, theta_z_deg = 0.0;
};

/// An axis over the whole path of a setup: its demand, and how far it stays from its ends.
struct SetupAxisReport {
  AxisDemandReport demand;
  std::optional<Range<double>> range = {};  ///< of the definition; nullopt: endless or not given
  std::optional<double> margin = {};        ///< from the nearer end of the range; >= 0
};

/// Why a setup is not possible, or not within limits.
struct Obstacle {
  enum class Kind { speed, problem, collision };
  Kind kind = Kind::speed;
  std::string axis;               ///< speed: whose; else empty
  std::string message;            ///< value, limit, unit, place
  std::uint32_t cl_line = 0;      ///< 0: none
  std::optional<Code> code = {};  ///< problem: what the planning refuses it with
};

/// The path in one setup.
struct SetupReport {
  Setup setup;  ///< ready for a PostJob
  /// The same setup by other angles, the part turned by half a turn with its jig; nullopt: other
  /// angles are another setup on this machine.
  std::optional<SetupAngles> twin = {};
  double tilt_deg = 0.0;                  ///< |theta_x_deg|
  std::optional<Obstacle> obstacle = {};  ///< that keeps it from being possible or within limits
  bool possible = false;       ///< within reach and ranges, no collision; else no figures follow
  bool within_limits = false;  ///< possible, and no axis over its speed limit
  /// Largest over the setups that setup_accuracy_deg allows; nullopt: no axis has a limit, or it
  /// has no bound (the singularity itself can be met).
  std::optional<double> peak_ratio = {};
  bool peak_unbounded = false;  ///< the singularity can be met within the accuracy
  std::optional<double> nominal_peak_ratio = {};  ///< of the setup itself
  std::optional<std::string> peak_axis = {};      ///< of the largest nominal ratio
  bool peak_rotary = false;
  double peak_speed = 0.0;  ///< of that axis in the setup itself, mm/s or deg/s
  std::optional<PathPlace> peak_at = {};
  double predicted_time_s = 0.0;      ///< of the cutting path, slowed down to the speed limits
  double programmed_time_s = 0.0;     ///< of it at the programmed feed
  double rotary_travel_deg = 0.0;     ///< of all rotary axes over the cutting path
  double repositioning_time_s = 0.0;  ///< of rapids, turns in place and retracts
  std::uint64_t retracts = 0, zones = 0;
  std::optional<double> closest_approach_deg = {};
  std::vector<SingularDirection> singular_directions;  ///< in CL coordinates
  std::vector<SetupAxisReport> axes;
  std::vector<std::string> instructions;  ///< how to clamp the part, one step each
};

}  // namespace pentapost::jobs
