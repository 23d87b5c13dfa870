#pragma once

#include "pentapost/core/diagnostics.hpp"
#include "pentapost/core/output.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/jobs/analysis_report.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "pentapost/jobs/report_head.hpp"
#include "pentapost/machine/definition.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pentapost::jobs {

/// One path for many machines.
struct CompareJob {
  static constexpr std::size_t most_machines = 200;

  /// For every machine; its own machine counts for nothing. A limit is of the axis of that name,
  /// where a machine has it.
  PostJob job;
  std::vector<machine::Definition> machines =
      {};                   ///< 1 to most_machines; one may stand there twice
  double zone_share = 1.0;  ///< of a speed limit, from which a stretch counts as a zone; > 0
  /// By what the best setup on each machine is looked for; nullopt: it is not. Its job, candidates
  /// and map count for nothing.
  std::optional<ReorientJob> reorient = {};
};

/// How many of a machine's axes have a known speed limit.
enum class LimitsKnown { all, some, none };

/// What the path asks of a machine. As analyse() says; without a known limit there is no ratio, no
/// zone, and the predicted time is the programmed one.
struct CompareFigures {
  LimitsKnown limits_known = LimitsKnown::none;
  std::vector<std::string> axes_without_limit = {};
  bool within_limits = true;                  ///< no axis is over a known speed limit
  double programmed_time_s = 0.0;             ///< of the cutting path at the programmed feed
  double predicted_time_s = 0.0;              ///< of it, slowed down to the speed limits
  double repositioning_time_s = 0.0;          ///< of rapids, turns in place and retracts
  std::uint64_t retracts = 0;                 ///< in which the axes unwind or change their solution
  std::optional<AxisDemandReport> peak = {};  ///< axis of the largest ratio; nullopt: no limit
  std::optional<double> closest_approach_deg = {};  ///< nullopt: no singularity, or nothing is cut
  std::optional<double> pole_axis_change_deg = {};  ///< nullopt: the CL's own path was analysed
  std::uint64_t zones = 0, over_demands = 0;
  double zones_time_lost_s = 0.0, over_demands_time_lost_s = 0.0;
  /// Of this machine, beside those of the path; gauge_length_missing: what a program would need.
  Diagnostics diagnostics = {};
};

/// The best setup on a machine.
struct CompareReorientation {
  std::optional<SetupReport> best = {};       ///< nullopt: no setup within the bounds is possible
  std::optional<double> optimality_gap = {};  ///< in the unit of the objective
  std::optional<Obstacle> obstacle = {};      ///< to being within limits; nullopt: `best` is
};

struct CompareRow {
  std::size_t index = 0;  ///< of CompareJob::machines
  std::string name, version, title, sha256;
  std::string dialect;  ///< that the program would be posted with
  Output output = Output::tcp;
  /// The Problem: why the machine cannot follow the path or write such a program. Code::defect is
  /// a defect of ours, which its message names.
  Result<CompareFigures> figures;
  std::optional<Result<CompareReorientation>> reorientation = {};  ///< nullopt: was not looked for
};

/// The head has no machine.
struct CompareReport : ReportHead {
  std::optional<Objective> objective = {};  ///< of the reorientations; nullopt: none were asked for
  std::vector<CompareRow> rows;             ///< in the order of compare_rows.hpp
  Diagnostics diagnostics;                  ///< of the path
};

/// Which machine suits a path. The path is read once; one machine's failure, a defect too, is its
/// row and leaves the others as they are.
///
/// @return Problem: CL data or a number of the job, which no machine could mend (400). Its pointer
///         is that of the job; of a number for the setups it starts with /reorient.
Result<CompareReport> compare(const CompareJob& job);

}  // namespace pentapost::jobs
