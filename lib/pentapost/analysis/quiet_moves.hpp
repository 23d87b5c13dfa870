#pragma once

#include "pentapost/analysis/demand.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/plan/settings.hpp"

namespace pentapost::analysis {

/// Tells by upper bounds, without following the joints, that a move comes near no limit.
class QuietMoves {
 public:
  /// @param gauge_length_mm  of the tool that cuts.
  QuietMoves(const kinematics::Model& model, const plan::Settings& settings,
             const Allowance& allowance, double gauge_length_mm);

  /// Whether no axis reaches its limit, nor the allowed share of it, on a straight move that
  /// follows one branch. False: not known.
  /// @param tip_mm  an end of the move, frame of the tool path.
  /// @param axis_from, axis_to  unit, table frame.
  bool is_quiet(const Vec3& tip_mm, const Vec3& axis_from, const Vec3& axis_to, double length_mm,
                double time_s) const;

 private:
  bool is_within(double first_rad, double second_rad, const Vec3& tip_mm, double length_mm,
                 double time_s) const;

  const kinematics::Model& model_;
  Vec3 origin_from_a_mm_;
  double least_ratio_;  ///< from which a load counts
  double first_s_per_rad_, second_s_per_rad_, linear_s_per_mm_;
  double cos_lambda_cos_mu_, sin_lambda_, sin_lambda_sin_mu_;
  double b_from_a_mm_, tool_arm_mm_;
};

}  // namespace pentapost::analysis
