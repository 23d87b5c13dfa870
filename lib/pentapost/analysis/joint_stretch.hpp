#pragma once

#include "pentapost/analysis/demand.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/segment.hpp"

#include <optional>
#include <vector>

namespace pentapost::analysis {

/// A block as a control runs it. The rotary joints run evenly; the tip runs evenly on its line or
/// arc while the linear joints follow it (TCP), or all joints run evenly. Refers to model and
/// segment.
class JointStretch {
 public:
  /// The joints at both ends. The linear ones are read only where all joints run evenly.
  struct Ends {
    kinematics::Joints from, to;
  };
  /// Where the block is run.
  struct Frame {
    double gauge_length_mm = 0.0;
    Vec3 origin_mm = Vec3::Zero();  ///< of the path in the table frame
  };

  /// @param tip  way of the tip, whose tool axes are not read; nullptr: all joints run evenly.
  /// @param resolved_turn_rad  a block that turns farther is no denser than one that turns so far:
  ///        a bound of the work for words of thousands of turns.
  /// @param at_start  the joints' motion at the start, where the block before had its end; nullptr:
  ///        not known.
  JointStretch(const kinematics::Model& model, const path::Segment* tip, const Ends& ends,
               const Frame& frame, double resolved_turn_rad,
               const kinematics::JointMotion* at_start = nullptr);

  double from() const { return 0.0; }
  double to() const { return 1.0; }
  /// @return nullopt where the linear axes do not span space. At a pole the joints have their
  ///         rates: the words set them.
  std::optional<Demand> at(double fraction) const;
  /// The joints' motion at the end, for the block that goes on from there; nullopt: at() was not
  /// asked for it.
  const std::optional<kinematics::JointMotion>& at_end() const { return at_end_; }
  /// Rates that the tool's motion asks for by itself: the rotary rates of `demand`, which is of the
  /// same fraction, divided by their amplification.
  PerAxis asked(double fraction, const Demand& demand) const;
  std::optional<PerAxis> acceleration(double fraction, const Demand& demand) const;
  Vec3 axis(double fraction) const;
  Vec3 tip_mm(double fraction) const;
  /// Fractions inside where the second joint passes a singularity, in order.
  std::vector<double> turning_places() const;
  /// Bound, but for a factor near 1, of what the rates change by between two places, relative to
  /// the largest of them: by the turn of the joints, which carry the linear axes along.
  double relative_change(const Demand& from, const Demand& to, double length) const;

  /// Length of the tip's path.
  double length_mm() const;
  /// Turn of both joints and of the arc, as far as it is resolved.
  static double turn_rad(const path::Segment* tip, const Ends& ends);

 private:
  /// The joints if all ran evenly; the rotary ones do always.
  kinematics::Joints joints_by_words(double fraction) const;
  const kinematics::JointMotion* motion(double fraction) const;
  /// Of the tip, by the fraction.
  Vec3 tip_rate_mm(const kinematics::JointMotion& motion, double fraction) const;

  const kinematics::Model& model_;
  const path::Segment* tip_;
  Ends ends_;
  kinematics::JointRates change_;
  Frame frame_;
  double turn_rad_;
  const kinematics::JointMotion* at_start_;
  mutable std::optional<kinematics::JointMotion> at_end_, inside_;  ///< as computed last
  mutable double inside_fraction_ = -1.0;
};

}  // namespace pentapost::analysis
