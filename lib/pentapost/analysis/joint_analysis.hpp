#pragma once

#include "pentapost/analysis/joint_path.hpp"
#include "pentapost/analysis/joint_stretch.hpp"
#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/analysis/recorder.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/plan/settings.hpp"

#include <optional>

namespace pentapost::analysis {

/// Analyses the blocks of a program one by one, as the control runs them (see JointStretch). Keeps
/// the posture, not the blocks.
///
/// A rapid, and a block whose tip stands still, is a repositioning. Where all joints run evenly a
/// tip stands still that ends within the last digits of where it was, without leaving it by more
/// than the tip's tolerance.
class JointAnalysis {
 public:
  /// Model and settings must outlive the analysis. Of the settings: limits, origin, gauge lengths,
  /// tip tolerance, decimals.
  JointAnalysis(const kinematics::Model& model, const plan::Settings& settings,
                const AnalysisOptions& options);
  JointAnalysis(const JointAnalysis&) = delete;
  JointAnalysis& operator=(const JointAnalysis&) = delete;

  /// The next blocks belong to this tool. Where the machine stands is not known after a change.
  void use_tool(int number);
  /// Where the machine stands is not known.
  void interrupt();
  /// Whether the machine's posture is known.
  bool is_placed() const { return posture_.has_value(); }
  /// The path starts at a posture.
  void begin(const JointPosture& posture);
  /// Goes from the posture that is known.
  /// @return Problem no_feed with the line in its message.
  Status move(const JointMove& move);

  PathAnalysis finish() && { return std::move(recorder_).finish(); }

 private:
  void reposition(Repositioning::Kind kind, const JointMove& move);
  Status cut(const JointMove& move);
  bool stands_still(const JointStretch& stretch, const JointStretch::Ends& ends, bool words_are_tip,
                    double length_mm) const;
  double resolved_turn_rad(double turn_rad);
  std::optional<PerAxis> joints(const JointPosture& posture) const;

  const kinematics::Model& model_;
  const plan::Settings& settings_;
  Recorder recorder_;
  JointStretch::Frame frame_;
  std::optional<JointPosture> posture_;
  std::optional<kinematics::JointMotion> met_;  ///< the joints' motion at posture_, if it is known
  double s_mm_ = 0.0;
  double turn_allowance_rad_;  ///< that is left, for blocks of more than a turn
};

}  // namespace pentapost::analysis
