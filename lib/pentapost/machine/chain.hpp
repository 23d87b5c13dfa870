#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/core/units.hpp"

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace pentapost::machine {

struct LinearJoint {
  UnitVector direction;  ///< base frame, all joints at zero; + moves the carried body along it
  std::optional<Range<double>> range_mm;  ///< nullopt: no source gives one
};
struct RotaryJoint {
  UnitVector direction;               ///< base frame; + turns the carried body right-handed
  Vec3 point_mm;                      ///< any point on the rotary axis, base frame
  std::optional<Range<Angle>> range;  ///< nullopt: endless
};
struct Joint {
  std::string name;                             ///< as the control writes it: "X", "A"
  std::variant<LinearJoint, RotaryJoint> kind;  ///< a new kind breaks every std::visit: intended
  bool is_rotary() const { return std::holds_alternative<RotaryJoint>(kind); }
};

/// Kinematic chain workpiece -> base -> tool (ISO 10791-6). Immutable, so threads share it freely.
class Chain {
 public:
  /// @param table  joints that carry the workpiece, from the workpiece to the base.
  /// @param head   joints that carry the tool, from the base to the tool.
  /// @param tool_axis  tool tip to spindle, base frame, all joints at zero.
  /// @return Problem chain_shape unless there are 3 linear joints that span space and 0 to 2 rotary
  ///         joints, with sines of the angles between the rotary axes, and between the tool-side
  ///         one and the tool axis, of at least 1e-6, and names that differ (lib/README.md section
  ///         2).
  static Result<Chain> make(std::vector<Joint> table, std::vector<Joint> head,
                            UnitVector tool_axis);

  std::span<const Joint> table() const noexcept { return table_; }
  std::span<const Joint> head() const noexcept { return head_; }
  const UnitVector& tool_axis() const noexcept { return tool_axis_; }
  int rotary_count() const noexcept { return rotary_count_; }
  bool head_turns() const noexcept;  ///< a rotary joint carries the tool

 private:
  Chain(std::vector<Joint> table, std::vector<Joint> head, UnitVector tool_axis, int rotary_count)
      : table_{std::move(table)},
        head_{std::move(head)},
        tool_axis_{tool_axis},
        rotary_count_{rotary_count} {}
  std::vector<Joint> table_, head_;
  UnitVector tool_axis_;
  int rotary_count_ = 0;
};

}  // namespace pentapost::machine
