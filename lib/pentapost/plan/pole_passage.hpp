#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/axis_path.hpp"
#include "pentapost/plan/candidates.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace pentapost::plan {

/// The way over the pole from one off-pole point to the next: through the inside of a move, or by
/// points that lie at the pole. The first axis is free there.
class PolePassage {
 public:
  /// @param before  off-pole point that the path comes from; nullopt: the path starts at the pole.
  /// @param after  off-pole point that it goes to; nullopt: it ends at the pole.
  PolePassage(const kinematics::Model& model, const path::ToolPath& tool_path,
              const Candidates& candidates, std::optional<std::uint32_t> before,
              std::optional<std::uint32_t> after);

  /// Rotary values at the pole, coming on `branch` from the values at the point before.
  RotaryPair pair_in(const RotaryPair& pair_before, int branch) const;
  /// Rotary values at the pole, going on `branch` to the values at the point after.
  RotaryPair pair_out(const RotaryPair& pair_after, int branch) const;
  /// Time of the turn between them, in seconds.
  double turn_cost_s(const RotaryPair& in, const RotaryPair& out, double speed_rad_s) const;

  /// Writes the points at the pole, the moves to them and to the point after into `axis_path`:
  /// the turn from `in` to `out` evenly over air moves that rest on the pole, else over straight
  /// cutting moves that do, never over arcs and holes, else in place.
  void write(const RotaryPair& in, const RotaryPair& out, int branch_in, int branch_out,
             AxisPath& axis_path) const;

 private:
  double weight(std::uint32_t point, bool air) const;

  const kinematics::Model& model_;
  const path::ToolPath& tool_path_;
  const Candidates& candidates_;
  std::optional<std::uint32_t> before_, after_;
  std::uint32_t first_, end_;  ///< points at the pole
  std::optional<Candidates::Crossing> crossing_;
  std::uint8_t pole_ = 1;
  std::array<double, 2> first_in_rad_{}, first_out_rad_{};
};

}  // namespace pentapost::plan
