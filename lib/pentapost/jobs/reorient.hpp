#pragma once

#include "pentapost/clearance/model.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/report_head.hpp"
#include "pentapost/jobs/setup_report.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pentapost::jobs {

/// Values that a jig allows an angle.
struct AngleChoice {
  std::optional<double> step_deg = {};   ///< whole multiples of it; > 0
  std::vector<double> allowed_deg = {};  ///< these alone; empty: no list. Excludes step_deg.
};

/// Setups that are not to be used: both angles within, ends included. nullopt: any value.
struct ForbiddenAngles {
  std::optional<Range<double>> theta_x_deg = {}, theta_z_deg = {};
};

inline constexpr double largest_setup_accuracy_deg = 5.0;
inline constexpr double smallest_angle_step_deg = 0.001;
inline constexpr double smallest_map_step_deg = 0.25, largest_map_step_deg = 45.0;

struct ReorientJob {
  static constexpr std::size_t most_candidates = 1000;
  static constexpr std::size_t most_allowed = 10'000;
  static constexpr std::size_t most_forbidden = 100;

  PostJob job;  ///< its setup is the baseline
  Objective objective = Objective::peak_ratio;
  double max_tilt_deg = 30.0;  ///< of |theta_x_deg|; 0 to 180
  AngleChoice theta_x = {}, theta_z = {};
  std::vector<ForbiddenAngles> forbidden = {};
  /// How exactly the part can be clamped: the ratio of a setup is the largest over all setups whose
  /// singular direction is within this; 0 to largest_setup_accuracy_deg.
  double setup_accuracy_deg = 0.02;
  std::vector<SetupAngles> candidates = {};  ///< to be evaluated besides
  /// Where the CL origin may lie, of each coordinate; nullopt: where job.setup has it.
  std::optional<std::array<Range<double>, 3>> origin_mm = {};
  std::optional<double> map_step_deg = {};  ///< nullopt: no map
  /// What may collide; replaces parts of the definition's. nullopt: the definition's alone.
  std::optional<clearance::Model> clearance = {};
};

/// The objective over the setups, for a plot: [x][z].
struct SetupMap {
  std::vector<double> theta_x_deg, theta_z_deg;
  /// Ratio, seconds or degrees; nullopt: not possible, or without bound.
  std::vector<std::vector<std::optional<double>>> value;
};

struct ReorientReport : ReportHead {
  Objective objective = Objective::peak_ratio;
  SetupReport baseline;
  std::optional<SetupReport> best;           ///< nullopt: no setup within the bounds is possible
  std::optional<SetupReport> smallest_tilt;  ///< of the least tilt within limits; nullopt: none
  /// By how much less tilt another setup could be within limits; nullopt: there is no smallest.
  std::optional<double> smallest_tilt_gap_deg;
  std::vector<SetupReport> pareto;      ///< least tilt first, each with a better objective
  std::vector<SetupReport> candidates;  ///< those asked for, in order
  std::optional<SetupMap> map;
  /// By how much a better setup than `best` could be better yet, in the unit of the objective.
  std::optional<double> optimality_gap;
  std::uint64_t setups_evaluated = 0;
  std::uint64_t setups_colliding = 0;
  /// What stands in the way where no setup is within limits; nullopt: one is.
  std::optional<Obstacle> obstacle;
  Diagnostics diagnostics;
};

/// How to clamp the workpiece so that the singularities of its machine are out of the way.
///
/// @return Problem: CL data or a number of the job (400), or a machine that cannot be reoriented
///         for, or that has no limit to measure by (422).
Result<ReorientReport> reorient(const ReorientJob& job);

}  // namespace pentapost::jobs
