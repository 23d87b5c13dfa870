#pragma once

#include "pentapost/analysis/grid.hpp"
#include "pentapost/analysis/path_analysis.hpp"

#include <optional>
#include <string>
#include <vector>

namespace pentapost::analysis {

/// Makes a PathAnalysis out of the moves of a path, in order.
class Recorder {
 public:
  Recorder(const kinematics::Model& model, const plan::Settings& settings,
           const AnalysisOptions& options);

  /// What the cutting moves belong to from now on.
  void begin_operation(int tool_number, const std::string& name);
  /// One stretch of a cutting move; a Grid says what a stretch is.
  /// @return false where it has no rates anywhere, and nothing was taken.
  template <class Stretch>
  bool cut(const Stretch& stretch, const SurveyedMove& move) {
    Grid{stretch, move.time_s, allowance_, samples_.has_value()}.fill(places_);
    if (places_.empty()) return false;
    take_places(move);
    return true;
  }
  /// Whether no more than its time is to be known of a cutting move that is near no limit.
  bool may_pass(const SurveyedMove& move) { return windows_.is_outside(move); }
  /// Takes such a move.
  void pass(const SurveyedMove& move) { survey_.pass(move); }
  const Allowance& allowance() const { return allowance_; }
  /// Counts a cutting move, all its stretches.
  void account(const SurveyedMove& move);
  /// A move from one posture to another without a feed along the path.
  void reposition(Repositioning::Kind kind, const PathPlace& at,
                  const std::optional<PerAxis>& from_joints,
                  const std::optional<PerAxis>& to_joints);
  /// The path starts anew: what lies between is no part of it.
  void interrupt();

  PathAnalysis finish() &&;

 private:
  void take_places(const SurveyedMove& move);
  std::optional<double> time_s(const PerAxis& from, const PerAxis& to) const;

  Allowance allowance_;
  PathAnalysis analysis_;
  Survey survey_;
  std::optional<Samples> samples_;
  WindowLoads windows_;
  std::vector<Place> places_;
  OperationTime operation_;  ///< joins the others with its first cut
  bool has_cut_ = false;     ///< in this operation
  double accounted_s_ = 0.0;
};

}  // namespace pentapost::analysis
