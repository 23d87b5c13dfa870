#pragma once

#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/core/diagnostics.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/jobs/report_head.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pentapost::jobs {

/// Places have their tips in CL coordinates, mm; their points count those of the path from 0.
using analysis::PathPlace;

/// What the cutting moves ask of an axis at the programmed feed. mm or degrees, per second.
struct AxisDemandReport {
  std::string name;
  bool rotary = false;
  std::optional<Range<double>> span = {};  ///< nullopt: it depends on an origin that is not known
  double peak_speed = 0.0;
  /// What the tool's motion asks for there by itself, and what the singularity multiplies it by;
  /// rotary axes only. nullopt: at a singularity, where a speed is no product any more.
  std::optional<double> asked_speed = {}, amplification = {};
  std::optional<double> speed_limit = {};
  std::optional<double> peak_ratio = {};         ///< nullopt: there is no limit
  std::optional<PathPlace> peak_at = {};         ///< nullopt: the axis does not move
  std::optional<double> peak_acceleration = {};  ///< inside the moves; nullopt: not asked for
  std::optional<double> acceleration_limit = {};
};

/// What can be done about a zone, and what it costs.
struct Cure {
  enum class Kind {
    feed,           ///< a lower feed through the zone
    solution,       ///< the other tilt of the rotary axes
    axis_change,    ///< the tool axis led through the pole
    reorientation,  ///< the part clamped in another way
  };
  Kind kind = Kind::feed;
  double time_lost_s = 0.0;  ///< that is left in and about the zone, against the programmed feed
  double peak_ratio = 0.0;   ///< that is left there
  double feed_mm_min = 0.0;  ///< feed: through the zone
  double axis_change_deg = 0.0;  ///< axis_change: of the tool axis, at most
  /// reorientation: of the setup, in place of the job's.
  double theta_x_deg = 0.0, theta_z_deg = 0.0;
};

struct ZoneReport {
  std::string axis;  ///< of the largest ratio among those that are over it for that cause
  bool rotary = false;
  std::optional<kinematics::SingularityKind> kind = {};  ///< nullopt: no singularity causes it
  PathPlace from, to;
  std::optional<double> closest_deg = {};  ///< nullopt: the machine has no singularity
  double peak_speed = 0.0;                 ///< mm/s or deg/s
  double peak_ratio = 0.0;
  /// Of that axis at the peak; nullopt: a linear axis, or the singularity itself.
  std::optional<double> amplification = {};
  double lowest_feed_mm_min = 0.0;  ///< that the axes can hold all through
  double programmed_time_s = 0.0;
  double time_lost_s = 0.0;
  std::vector<Cure> cures = {};  ///< of singular zones; the least time lost first
};

/// Zones of one kind.
struct ZonesReport {
  static constexpr std::size_t most = 1000;

  std::vector<ZoneReport> zones;  ///< in order of the path; of more than `most` the worst
  std::uint64_t total = 0;
  double time_lost_s = 0.0;  ///< in all of them
};

/// Tool axes at which the machine is singular: one, or the circle at an angle about it.
struct SingularDirection {
  kinematics::SingularityKind kind = kinematics::SingularityKind::pole;
  Vec3 direction = Vec3::UnitZ();  ///< unit, CL coordinates
  double half_angle_deg = 0.0;     ///< 0 at a pole
};

/// A column of samples, mm or degrees, per second.
struct AxisColumns {
  std::string name;
  bool rotary = false;
  std::vector<double> position;  ///< empty: it depends on an origin that is not known
  std::vector<double> speed;
  std::vector<std::optional<double>> acceleration;  ///< nullopt: at a singularity
};

/// Places along the path in columns, for plots.
struct SampleColumns {
  std::vector<double> s_mm, feed_mm_min;
  std::vector<std::uint32_t> line;
  std::vector<bool> goes_on;  ///< from the sample before, without a repositioning between
  /// Of the first rotary axis, the larger one; nullopt: at a singularity.
  std::vector<std::optional<double>> amplification;
  std::vector<Vec3> axis;  ///< tool axis, CL coordinates
  std::vector<AxisColumns> axes;
};

struct ToolTime {
  double length_mm = 0.0;
  double programmed_time_s = 0.0, predicted_time_s = 0.0;
};

struct AnalyseReport : ReportHead {
  std::uint64_t points = 0;           ///< of the path, holes as their single moves
  double length_mm = 0.0;             ///< of the tip's cutting path
  double programmed_time_s = 0.0;     ///< of the cutting path at the programmed feed
  double predicted_time_s = 0.0;      ///< of it, slowed down to the speed limits
  double repositioning_time_s = 0.0;  ///< of all repositionings whose axes have limits
  std::optional<double> pole_axis_change_deg = {};  ///< nullopt: the CL's own path is analysed
  std::optional<double> closest_approach_deg = {};  ///< nullopt: none, or no cutting path
  std::optional<double> peak_ratio = {};            ///< nullopt: no axis has a limit
  std::vector<AxisDemandReport> axes;
  ZonesReport zones, over_demands;
  std::vector<analysis::OperationTime> operations;
  std::map<int, ToolTime> tools;                        ///< by number
  std::vector<analysis::Repositioning> repositionings;  ///< tips in CL coordinates
  std::vector<SingularDirection> singular_directions;   ///< that the rotary ranges allow
  std::optional<SampleColumns> samples;
  Diagnostics diagnostics;
};

}  // namespace pentapost::jobs
