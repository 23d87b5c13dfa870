#pragma once

#include "pentapost/analysis/demand.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/reorient/clamping.hpp"
#include "pentapost/reorient/piece.hpp"

#include <array>
#include <optional>

namespace pentapost::reorient {

using analysis::axis_count;
using analysis::first_axis;
using analysis::PerAxis;
using analysis::second_axis;

/// How far a clamping and the tool's motion may be from those that are given.
struct Spread {
  // of the clamping
  double pole_rad = 0.0;   ///< of its pole
  double turn_rad = 0.0;   ///< of its whole orientation
  double origin_mm = 0.0;  ///< of origin_from_a_mm, the change by the turn included
  // of the motion
  double axis_rad = 0.0, turn_rad_s = 0.0, tip_mm = 0.0, tip_mm_s = 0.0;
};

/// Motions that are alike: all within a spread of one.
struct MotionGroup {
  ToolMotion centre;
  Spread spread;  ///< of the motions alone
  double largest_turn_rad_s = 0.0, largest_tip_mm_s = 0.0;
  double axis_sine = 0.0, axis_cosine = 1.0;  ///< of spread.axis_rad, up to 90 deg
};

/// 1 / speed limit of each axis; 0: there is none.
struct SpeedShares {
  PerAxis time_per_way_s{};
  bool has_linear = false;  ///< a linear axis has a limit
};

/// Bounds of magnitudes, mm/s and rad/s.
struct RateBounds {
  PerAxis lower{}, upper{};        ///< upper: infinite where a singularity may be met
  double least_linear_mm_s = 0.0;  ///< of all linear axes together, the root of their squares
  bool may_be_reached = true;      ///< false: no place within the spread is within reach
};

/// Joint speeds by the tool's motion and the direction of the pole alone, without joint values: the
/// second rotary axis follows from the pole and the tool axis, and the linear axes from all three
/// (lib/README.md section 7). For two rotary joints and linear joints in one place of the chain;
/// of others the linear speeds have no bounds: 0 and infinite.
class AxisRates {
 public:
  AxisRates(const kinematics::Model& model, double gauge_length_mm);

  /// Magnitudes, mm/s and rad/s.
  /// @param branch  0 or 1, as in kinematics::RotarySolutions.
  /// @return nullopt at a singularity, but for a tool axis at rest, or out of reach.
  std::optional<PerAxis> at(const ToolMotion& motion, const Clamping& clamping, int branch) const;

  /// Largest ratio to a limit; nullopt as at().
  std::optional<double> ratio(const ToolMotion& motion, const Clamping& clamping, int branch,
                              const SpeedShares& shares) const;

  /// Whether a motion of the group may exceed a ratio in a clamping within `about`, of which
  /// pole_rad, turn_rad and origin_mm count. True: not known.
  bool may_exceed(double ratio, const MotionGroup& group, const Clamping& clamping, int branch,
                  const Spread& about, const SpeedShares& shares) const;

  /// Bounds over all motions and clampings within the spread.
  RateBounds bounds(const ToolMotion& motion, const Clamping& clamping, int branch,
                    const Spread& spread) const;

  /// Values of the linear joints, mm.
  std::optional<Vec3> linear_mm(const ToolMotion& motion, const Clamping& clamping,
                                int branch) const;
  /// By how much these change at most within the spread; infinite where there is no bound.
  Vec3 linear_change_mm(const ToolMotion& motion, const Clamping& clamping, int branch,
                        const Spread& spread) const;

  /// Whether both branches have the same rotary speeds.
  bool has_equal_branches() const { return is_right_angled_; }
  /// The opening of the triangle (RotarySolutions::opening_rad) at an angle between pole and tool
  /// axis; nullopt: out of reach.
  std::optional<double> opening_rad(double gamma_rad) const;
  /// The openings over a range of such angles; nullopt: all of it is out of reach.
  std::optional<Range<double>> openings_rad(const Range<double>& gamma_rad) const;
  /// Distance of an angle between pole and tool axis from the nearest singular one.
  double singularity_distance_rad(double gamma_rad) const;
  /// Whether an angle of that cosine is farther than this from every singular one; a "no" is not
  /// certain, and cheap.
  bool is_far_from_singularity(double cos_gamma, double within_rad) const {
    return cos_gamma < cos_least_gamma_ - within_rad && cos_gamma > cos_most_gamma_ + within_rad;
  }
  /// Whether a singular angle lies within a range.
  bool has_singularity_between(const Range<double>& gamma_rad) const;

 private:
  struct Posture;
  struct Freedom;
  struct Frame {
    Vec3 along, aside, across;
    Vec3 components(const Vec3& vector) const {
      return {along.dot(vector), aside.dot(vector), across.dot(vector)};
    }
    Vec3 vector(const Vec3& components) const {
      return components.x() * along + components.y() * aside + components.z() * across;
    }
  };
  static Frame frame(const Vec3& along, const Vec3& other);
  /// Of the unit vectors along pole, second rotary axis and tool axis at an angle between the first
  /// and the last: sin(lambda) sin(mu) sin(opening), all digits kept next to its zeros.
  double volume(double gamma_rad) const;
  std::optional<Posture> posture(const ToolMotion& motion, const Clamping& clamping,
                                 int branch) const;
  bool may_exceed_right_angled(double ratio, const MotionGroup& group, const Clamping& clamping,
                               const Spread& about, const SpeedShares& shares) const;
  Freedom freedom(const Posture& posture, const Spread& spread) const;
  const Frame& linear_frame(const Posture& posture) const;
  double frame_change(const Freedom& freedom, const Spread& spread) const;
  Vec3 linear_arm_mm(const Posture& posture) const;
  double largest_corner_change(double gamma_rad, double low_rad, double high_rad, double cos_near,
                               double cos_far, double sin_near) const;

  double least_gamma_rad_, most_gamma_rad_;  ///< of the reach: both singular
  double cos_least_gamma_, cos_most_gamma_;
  double lambda_rad_, mu_rad_, cos_lambda_, sin_lambda_, cos_mu_, sin_mu_;
  bool is_right_angled_;
  double sign_of_branch_0_;
  int place_;
  Mat3 linear_per_component_;  ///< linear joints by components of the frame that carries them
  Vec3 row_norms_;
  double largest_tip_per_linear_;  ///< way of the tip by a way of 1 mm of the linear joints
  double b_from_a_mm_, tool_mm_;
  Vec3 b_from_a_components_;  ///< in the frame of both rotary axes
  Vec3 tool_components_;      ///< from the second rotary axis to the tip, in that axis' and the
                              ///< tool's frame
  Vec3 linear_offset_mm_;     ///< subtracted from the linear joints
};

}  // namespace pentapost::reorient
