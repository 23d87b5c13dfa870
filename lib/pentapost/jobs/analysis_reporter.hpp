#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/analysis_report.hpp"
#include "pentapost/jobs/prepared_job.hpp"

namespace pentapost::jobs {

/// What the values of an analysis are reported in.
struct ReportFrame {
  const kinematics::Model& model;
  const plan::JointRanges& ranges;
  const plan::Settings& settings;
  Mat3 to_cl;  ///< turns the table's orientation into CL coordinates
  /// Values of the linear axes are known: they do not rest on an assumed origin.
  bool linear_known = false;
};

/// Turns an analysis into what its caller sees: CL coordinates, degrees, names of axes.
///
/// @return Problem where a speed, ratio or time is no number any more.
Status report_analysis(const ReportFrame& frame, analysis::PathAnalysis analysis,
                       AnalyseReport& report);

/// The zones as reported, in the order of the path. All of them singular, or none.
ZonesReport report_zones(const ReportFrame& frame, const std::vector<analysis::Zone>& zones,
                         bool singular);

}  // namespace pentapost::jobs
