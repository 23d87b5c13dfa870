#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/kinematics/rotate.hpp"
#include "pentapost/path/segment.hpp"

#include <array>
#include <optional>

namespace pentapost::verify {

/// A chain with what the bounds need of it. Refers to the model.
struct ChainShape {
  explicit ChainShape(const kinematics::Model& chain_model);
  const kinematics::Model& model;
  double tool_cosine, tool_sine;  ///< of the angle between second rotary axis and tool axis
};

/// How the rotary joints hold the tool: what the tip's way follows from where the words are joint
/// values. Frame: table, but where it says otherwise.
struct Arms {
  Vec3 first_mm;            ///< first rotary axis to tip
  Vec3 first_turned_mm;     ///< the same, seen from the body that the first joint moves against
  Vec3 second_mm;           ///< second rotary axis to tip, seen from the body before it
  double second_length_mm;  ///< distance of the tip from the second rotary axis
  kinematics::SineCosine first_turn, second_turn;
};

/// Where the tool is at one place of a block. Frame: CL.
struct Station {
  Vec3 tip_mm = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double cosine = 1.0,
         sine = 0.0;  ///< of the angle between first rotary axis and tool axis, |cosine| and sine
  std::optional<Arms> arms = {};  ///< only where the words are joint values
};

/// The tool where X Y Z are the tip.
Station tip_station(const ChainShape& shape, const Vec3& tip_mm, double first_rad,
                    double second_rad);

/// The tool where the words are joint values.
/// @param origin_mm  CL origin in the table frame.
Station joint_station(const ChainShape& shape, const kinematics::Joints& joints,
                      double gauge_length_mm, const Vec3& origin_mm);

/// The way of tool tip and tool axis over one block, as the control runs it; s from 0 to 1.
class BlockCurve {
 public:
  /// TCP is on: the tip runs straight, the rotary joints evenly. `tip_mm` of `joints` is not read.
  static BlockCurve tip_line(const ChainShape& shape, const Vec3& tip_from_mm,
                             const Vec3& tip_to_mm, const kinematics::Joints& from,
                             const kinematics::Joints& to);
  /// All joints run evenly.
  static BlockCurve joint_line(const ChainShape& shape, const kinematics::Joints& from,
                               const kinematics::Joints& to, double gauge_length_mm,
                               const Vec3& origin_mm);
  /// The tip runs on `arc` (CL frame), the rotary joints stand still.
  static BlockCurve arc(const ChainShape& shape, const path::Segment& arc,
                        const kinematics::Joints& joints);

  Station at(double s) const;
  /// Printed arc; nullptr: the block is no arc.
  const path::Segment* printed_arc() const { return arc_ ? &*arc_ : nullptr; }
  /// The words are joint values, so that the tip's speed along its path is not even.
  bool runs_in_joints() const { return kind_ == Kind::joint_line; }

  /// Upper bound of |d2 tip / du2| between two stations, u from 0 to 1 over the share `h` of the
  /// block between them. `infinity` where no bound is known yet: h is to be made smaller.
  double tip_acceleration_mm(const Station& from, const Station& to, double h) const;
  /// d tip / ds at a station of joint_line().
  Vec3 tip_velocity_mm(const Station& station) const;
  /// Upper bound of |d4 tip / ds4| over the whole block of joint_line() between its end stations.
  double tip_snap_mm(const Station& from, const Station& to) const;

  struct AxisRates {
    double speed;  ///< upper bound of |d axis / du|
    double
        acceleration;  ///< upper bound of the part of d2 axis / du2 that is tangent to the sphere
    double reach;      ///< upper bound of the way from either end, however often the joints turn
  };
  /// Bounds between two stations, u as above.
  AxisRates axis_rates(const Station& from, const Station& to, double h) const;

 private:
  enum class Kind { tip_line, joint_line, arc };
  BlockCurve(Kind kind, const ChainShape& shape, const kinematics::Joints& from,
             const kinematics::Joints& to);

  Kind kind_;
  const ChainShape* shape_;
  kinematics::Joints from_, change_;
  Vec3 tip_from_mm_ = Vec3::Zero(), tip_change_mm_ = Vec3::Zero();
  double gauge_length_mm_ = 0.0;
  Vec3 origin_mm_ = Vec3::Zero();
  std::array<Vec3, 3> linear_way_mm_;  ///< of joint_line(), by Model::linear_columns
  double before_second_mm_ = 0.0;      ///< way of the linear joints between the rotary ones
  double after_second_mm_ = 0.0;       ///< way of those beyond both
  double across_second_mm_ = 0.0;      ///< part of it across the second rotary axis
  std::optional<path::Segment> arc_;
};

}  // namespace pentapost::verify
