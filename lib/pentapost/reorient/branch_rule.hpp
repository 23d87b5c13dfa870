#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/settings.hpp"
#include "pentapost/reorient/axis_rates.hpp"

#include <optional>

namespace pentapost::reorient {

/// Where the tilt that a machine prefers settles the branch of a whole path: plan::choose() starts
/// with that tilt as long as the rest of its costs cannot add up to the wrong one's, and away from
/// the singularities no path leaves its branch but by a retract, which it never needs while the
/// first rotary axis stays within its range.
class BranchRule {
 public:
  /// Nothing is settled.
  BranchRule() = default;
  BranchRule(const kinematics::Model& model, const plan::JointRanges& ranges,
             const plan::Settings& settings, const path::ToolPath& tool_path);

  /// The branch of every path whose tool axes keep within `gamma_rad` of the pole all along;
  /// nullopt: not certain. The linear ranges are not looked at.
  ///
  /// @param origin_mm  the CL origin is no farther from the first rotary axis' point.
  std::optional<int> settled(const AxisRates& rates, const Range<double>& gamma_rad,
                             double origin_mm) const;

 private:
  std::optional<int> of_tilt(const Range<double>& opening_rad) const;
  bool is_settled_by_cost(const Range<double>& gamma_rad, const Range<double>& opening_rad,
                          double origin_mm) const;

  bool is_there_ = false;
  bool wants_negative_ = false;
  Range<double> second_range_rad_{};
  double first_reach_rad_ = 0.0;  ///< by which the first axis may turn from wherever it starts
  double beta_zero_rad_ = 0.0, sin_lambda_ = 0.0, sin_mu_ = 0.0;
  double margin_rad_ = 0.0;  ///< from the singularities, at which no plan changes its branch
  // of the whole path
  double turn_rad_ = 0.0, way_mm_ = 0.0, farthest_tip_mm_ = 0.0;
  int place_ = 0;
  double b_from_a_mm_ = 0.0, tool_mm_ = 0.0;
  double first_s_per_rad_ = 0.0, linear_s_per_mm_ = 0.0;
};

}  // namespace pentapost::reorient
