#pragma once

#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/core/diagnostics.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/report_head.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pentapost::jobs {

struct AnalyseJob {
  PostJob job;
  double zone_share = 1.0;  ///< of a speed limit, from which a stretch counts as a zone; > 0
};

/// Places have their tips in CL coordinates, mm; their points count those of the tool path from 0.
using analysis::PathPlace;

/// What the cutting moves ask of an axis at the programmed feed. In mm/s or deg/s.
struct AxisDemandReport {
  std::string name;
  bool rotary = false;
  double peak_speed = 0.0;
  std::optional<double> speed_limit = {};
  std::optional<double> peak_ratio = {};  ///< nullopt: there is no limit
  std::optional<PathPlace> peak_at = {};  ///< nullopt: the axis does not move
};

struct ZoneReport {
  std::string axis;  ///< of the largest ratio
  bool rotary = false;
  std::optional<kinematics::SingularityKind> kind = {};  ///< nullopt: no singularity causes it
  PathPlace from, to;
  std::optional<double> closest_deg = {};  ///< nullopt: the machine has no singularity
  double peak_speed = 0.0;                 ///< mm/s or deg/s
  double peak_ratio = 0.0;
  double lowest_feed_mm_min = 0.0;  ///< that the axes can hold all through
  double time_lost_s = 0.0;
};

/// Tool axes at which the machine is singular: one, or the circle at an angle about it.
struct SingularDirection {
  kinematics::SingularityKind kind = kinematics::SingularityKind::pole;
  Vec3 direction = Vec3::UnitZ();  ///< unit, CL coordinates
  double half_angle_deg = 0.0;     ///< 0 at a pole
};

struct AnalyseReport : ReportHead {
  std::uint64_t points = 0;        ///< of the tool path, holes as their single moves
  double length_mm = 0.0;          ///< of the tip's cutting path
  double programmed_time_s = 0.0;  ///< of the cutting path at the programmed feed
  double predicted_time_s = 0.0;   ///< of it, slowed down to the speed limits
  std::optional<double> closest_approach_deg = {};  ///< nullopt: none, or no cutting path
  std::optional<double> peak_ratio = {};            ///< nullopt: no axis has a limit
  std::vector<AxisDemandReport> axes;
  std::vector<ZoneReport> zones, over_demands;
  std::vector<analysis::OperationTime> operations;
  std::vector<analysis::Repositioning> repositionings;  ///< tips in CL coordinates
  std::vector<SingularDirection> singular_directions;   ///< that the rotary ranges allow
  Diagnostics diagnostics;
};

/// Where and why the path of a job is singular on its machine, and what it asks of the axes.
///
/// @return Problem: CL data or a number of the job (400), or this machine can't (422).
Result<AnalyseReport> analyse(const AnalyseJob& job);

}  // namespace pentapost::jobs
