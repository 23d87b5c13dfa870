#pragma once

#include "pentapost/analysis/demand.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/segment.hpp"

#include <optional>
#include <vector>

namespace pentapost::analysis {

/// Where and how the joints move along a part of a CL move, at the places between its fractions.
/// Refers to model and segment.
class ClStretch {
 public:
  enum class Follows {
    branch,  ///< the rotary joints follow the tool axis on one solution
    even,  ///< the rotary joints turn evenly: the tool axis rests on a singularity, or they cannot
           ///< follow it but within the slack
  };
  /// Both ends, with the rotary values there.
  struct Ends {
    double fraction_from = 0.0, fraction_to = 1.0;
    double first_from_rad = 0.0, first_to_rad = 0.0;
    double second_from_rad = 0.0, second_to_rad = 0.0;
  };

  /// @param segment  in the table's orientation; from or to the pole itself where it is passed.
  /// @param origin_mm  CL origin in the table frame.
  /// @param slack_rad  see kinematics::inverse_rotary.
  /// @param at_end  takes the joints' motion at the end, for the stretch that goes on from there.
  /// @param at_start  the joints' motion at the start, where the stretch before had its end;
  ///        nullptr: not known.
  ClStretch(const kinematics::Model& model, const path::Segment& segment, Follows follows,
            int branch, const Ends& ends, double gauge_length_mm, const Vec3& origin_mm,
            double slack_rad, std::optional<kinematics::JointMotion>& at_end,
            const kinematics::JointMotion* at_start = nullptr);

  double from() const { return ends_.fraction_from; }
  double to() const { return ends_.fraction_to; }
  /// @return nullopt where the joints have no rates: at a singularity itself, out of reach.
  std::optional<Demand> at(double fraction) const;
  /// Rates that the tool's motion asks for by itself: the rotary rates of `demand`, which is of the
  /// same fraction, divided by their amplification.
  PerAxis asked(double fraction, const Demand& demand) const;
  /// At an even feed; nullopt: a singularity.
  std::optional<PerAxis> acceleration(double fraction, const Demand& demand) const;
  Vec3 axis(double fraction) const { return segment_.axis(fraction); }
  Vec3 tip_mm(double fraction) const { return segment_.tip_mm(fraction); }
  /// Fractions inside where the tool axis is nearest to the first rotary axis or farthest from it:
  /// there the singularities are nearest.
  std::vector<double> turning_places() const;
  /// Bound, but for a factor near 1, of what the rates change by between two places, relative to
  /// themselves.
  double relative_change(const Demand& from, const Demand& to, double length) const;

 private:
  struct Rotary {
    double first_rad, second_rad;
  };
  std::optional<Rotary> rotary(double fraction) const;
  const kinematics::JointMotion* motion(double fraction) const;
  bool rests_on_singularity() const;
  Rotary even_rates() const;  ///< by the fraction

  const kinematics::Model& model_;
  const path::Segment& segment_;
  Follows follows_;
  int branch_;
  Ends ends_;
  double gauge_length_mm_;
  Vec3 origin_mm_;
  double slack_rad_;
  std::optional<kinematics::JointMotion>& at_end_;
  const kinematics::JointMotion* at_start_;
  mutable std::optional<kinematics::JointMotion> inside_;  ///< as computed last, at
  mutable double inside_fraction_ = -1.0;
};

}  // namespace pentapost::analysis
