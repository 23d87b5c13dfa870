#pragma once

#include "pentapost/analysis/samples.hpp"
#include "pentapost/analysis/spans.hpp"
#include "pentapost/analysis/survey.hpp"
#include "pentapost/analysis/window_loads.hpp"
#include "pentapost/kinematics/singularity.hpp"
#include "pentapost/plan/settings.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pentapost::analysis {

/// A move in which the tip does not cut along the path: a rapid, a turn in place, a retract.
struct Repositioning {
  enum class Kind { rapid, turn_in_place, retract };
  Kind kind = Kind::rapid;
  PathPlace at;                  ///< where it ends
  std::optional<double> time_s;  ///< by the axis limits; nullopt: no moving axis has one
};

/// Cutting time of one operation with one tool.
struct OperationTime {
  int tool_number = 1;
  std::string operation;  ///< as the CL data name it; empty: before the first name
  double length_mm = 0.0;
  double programmed_time_s = 0.0, predicted_time_s = 0.0;
};

/// What of a path is asked for.
struct AnalysisOptions {
  double share = 1.0;  ///< of a limit, from which a stretch counts as a zone
  /// Most samples for plots, at least Samples::fewest; nullopt: none, and no accelerations.
  std::optional<std::size_t> most_samples = {};
  /// Moves that can be near no limit are only timed: peaks, spans and the closest approach are
  /// those of the other moves alone.
  bool zones_only = false;
  std::vector<Window> windows = {};  ///< to be measured apart; in order, without overlap
};

/// What a path asks of a machine's axes at the programmed feed.
struct PathAnalysis {
  std::vector<kinematics::Singularity> singularities;  ///< in workpiece coordinates of the setup
  std::vector<std::optional<Approach>> approaches;     ///< to each of them, over all cutting moves
  std::array<AxisPeak, axis_count> peaks{};            ///< over all cutting moves
  /// Largest inside the moves at an even feed, mm/s^2 or rad/s^2; nullopt: not asked for.
  std::optional<PerAxis> peak_accelerations;
  Spans spans;                     ///< over all moves
  std::vector<Zone> zones;         ///< caused by a singularity
  std::vector<Zone> over_demands;  ///< not caused by one
  std::vector<Repositioning> repositionings;
  double length_mm = 0.0;                 ///< of the tip's way over all cutting moves
  double programmed_time_s = 0.0;         ///< of these at the programmed feed
  double predicted_time_s = 0.0;          ///< of these, slowed down to the speed limits
  std::vector<OperationTime> operations;  ///< in order; those that cut
  std::vector<Sample> samples;            ///< in order
  std::vector<WindowLoad> window_loads;   ///< of the windows asked for
};

/// Limits by the order of the model's axes, from those of the settings.
SpeedLimits speed_limits(const kinematics::Model& model, const plan::Settings& settings);

}  // namespace pentapost::analysis
