#pragma once

#include "pentapost/clearance/check.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "pentapost/jobs/setup_analysis.hpp"
#include "pentapost/reorient/path_loads.hpp"
#include "pentapost/reorient/search.hpp"
#include "pentapost/reorient/setup_domain.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace pentapost::jobs {

/// The search for the setups of one job: finds by bounds, answers by the analysis of the path.
class Reorientation {
 public:
  /// @param prepared  its tool path in CL coordinates, holes as single moves. Referred to, as job.
  /// @param clearance  nullopt: nothing to collide with is known.
  Reorientation(const ReorientJob& job, const PreparedJob& prepared, reorient::SetupDomain domain,
                std::optional<clearance::Check> clearance);

  ReorientReport run();

 private:
  bool is_clear(const reorient::SetupPoint& setup);
  std::optional<double> confirm(const reorient::SetupPoint& setup, reorient::Goal goal,
                                double value);
  reorient::SetupValues values(reorient::Goal goal) const;
  reorient::SetupChecks checks(reorient::Goal goal);
  reorient::SearchOptions options(reorient::Goal goal) const;
  reorient::SetupDomain domain(reorient::Goal goal) const;

  /// Kept, so that no setup is analysed twice for the answer; valid until the next call.
  const SetupReport& evaluated(const reorient::SetupPoint& setup);
  void add_accuracy(const reorient::SetupPoint& setup, SetupReport& report);
  /// All pairs of angles, with coarse values.
  std::vector<reorient::Trial> trials(const std::vector<double>& theta_x_deg,
                                      const std::vector<double>& theta_z_deg,
                                      const Vec3& origin_mm);
  reorient::SetupPoint within_bounds(const reorient::SetupPoint& setup) const;
  SetupMap map();
  std::vector<reorient::Trial> first_trials(double most_tilt_deg) const;
  void find_best(ReorientReport& report);
  void find_smallest_tilt(ReorientReport& report);
  void find_pareto(ReorientReport& report);
  std::optional<Obstacle> obstacle_of_all();

  const ReorientJob& job_;
  const PreparedJob& prepared_;
  reorient::SetupDomain domain_;
  std::optional<clearance::Check> clearance_;
  bool origin_known_;
  bool has_limits_;
  bool has_twins_;
  SetupAnalysis setups_;
  reorient::PathLoads loads_;
  std::size_t points_;
  reorient::SetupPoint baseline_;
  std::vector<reorient::Trial> trials_;
  std::vector<std::pair<reorient::SetupPoint, SetupReport>> reports_;
  std::optional<Obstacle> obstacle_;  ///< of the setup that was refused last
  std::uint64_t evaluated_ = 0, colliding_ = 0;
};

}  // namespace pentapost::jobs
