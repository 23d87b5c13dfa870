#pragma once

#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/jobs/setup_report.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/reorient/setup_domain.hpp"

#include <optional>

namespace pentapost::jobs {

/// Analyses the path of a job in any setup, as POST /analyse does with the job's own.
class SetupAnalysis {
 public:
  /// @param prepared  its tool path in CL coordinates, holes as single moves. Referred to.
  /// @param origin_known  the setups' origins are where the part will lie.
  SetupAnalysis(const PreparedJob& prepared, bool origin_known)
      : prepared_{prepared}, origin_known_{origin_known} {}

  /// @return Problem where the machine can't.
  Result<analysis::PathAnalysis> analyse(const reorient::SetupPoint& setup,
                                         const analysis::AnalysisOptions& options) const;

  /// The whole report but for what the accuracy of the setup and the clearance add.
  SetupReport report(const reorient::SetupPoint& setup) const;

 private:
  plan::Settings settings(const reorient::SetupPoint& setup) const;
  void fill(SetupReport& report, const reorient::SetupPoint& setup,
            analysis::PathAnalysis analysis) const;

  const PreparedJob& prepared_;
  bool origin_known_;
};

/// What the planning refuses a setup with.
Obstacle obstacle_of(const Problem& problem);

/// nullopt: no axis has a limit to exceed.
bool is_within_limits(std::optional<double> peak_ratio);

/// Largest ratio of any axis.
double peak_ratio_of(const analysis::PathAnalysis& analysis);

}  // namespace pentapost::jobs
