#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/plan/block_maker.hpp"
#include "pentapost/plan/settings.hpp"

namespace pentapost::plan {

/// Tells at little cost that a straight CL move needs no division: a bound by the ends of the block
/// and its curvature, wider than bound_block(), which needs the posture in the middle.
class PlainBlock {
 public:
  /// All must outlive it.
  PlainBlock(const kinematics::Model& model, const Settings& settings, const BlockMaker& maker);

  struct ClMove {
    const Vec3 &tip_from_mm, &axis_from, &tip_to_mm, &axis_to;  ///< axes unit
    double length_mm;
  };
  /// Whether one block keeps both tolerances for the whole move; false: it may all the same.
  bool suffices(const ClMove& move, const Posture& from, const Posture& to) const;

 private:
  double tip_curvature_mm(double turn_rad, const Posture& from, const Posture& to) const;

  const kinematics::Model& model_;
  const Settings& settings_;
  double arms_mm_;        ///< between the rotary axes and the tool
  double stretch_;        ///< most that the linear joints move the tool for a length
  double resolution_mm_;  ///< distance that the digits printed leave open
};

}  // namespace pentapost::plan
