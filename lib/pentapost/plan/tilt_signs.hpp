#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/candidates.hpp"

#include <bitset>
#include <cstdint>

namespace pentapost::plan {

/// Follows which signs of tilt, and whole turns, the range of the second joint allows along a path
/// whose tilt changes its sign at some poles.
class TiltSigns {
 public:
  TiltSigns(const kinematics::Model& model, const JointRanges& ranges,
            const path::ToolPath& tool_path)
      : model_{model}, ranges_{ranges}, tool_path_{tool_path} {}

  /// A path that goes on with these points.
  void start(PointRange points);
  /// The path passes a pole, where the tilt changes its sign, and goes on with these points.
  /// @return false, and nothing taken, where the range forbids it.
  bool pass(std::uint8_t pole, PointRange points);
  /// It goes on with these points without a change of sign.
  void go_on(PointRange points);

 private:
  static constexpr int most_turns = 2;
  static constexpr std::size_t count = 2UL * (2UL * most_turns + 1UL);
  using Ways = std::bitset<count>;

  Ways allowed(PointRange points) const;

  const kinematics::Model& model_;
  const JointRanges& ranges_;
  const path::ToolPath& tool_path_;
  Ways ways_;
};

}  // namespace pentapost::plan
