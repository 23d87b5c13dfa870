#pragma once

#include "pentapost/clearance/model.hpp"
#include "pentapost/clearance/places.hpp"
#include "pentapost/clearance/shapes.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pentapost::clearance {

/// Where a piece of holder or spindle comes too near to something, first along the path.
struct Collision {
  std::uint32_t point = 0;    ///< of the checked path: there, or on the CL move that leads there
  std::uint32_t cl_line = 0;  ///< 1-based; 0: none
  std::string what;           ///< "holder 1", "spindle 2", by the order in the model
  std::string with;           ///< "table", "jig 1"
  double distance_mm = 0.0;   ///< to 1e-3 mm; 0: they touch or overlap
};

/// A coarse check for collisions of holder and spindle with table and jig: built once for a path,
/// then asked for any setup. Immutable, so threads share it freely.
///
/// Checked are all CL points, and on the CL moves in between places so close that no part of
/// holder or spindle goes further than step_mm() from one of them. Not seen: the way of rapids and
/// of positioning moves that the program adds, the tool itself, the workpiece, the machine's other
/// parts, and what comes within safety_mm by less than step_mm() between two places.
class Check {
 public:
  /// @param path  CL coordinates; holes as single moves.
  /// @param stretches  in order, each with one point at least, otherwise std::logic_error.
  ///        Gauge lengths count where the model has a spindle.
  Check(const path::ToolPath& path, std::vector<Stretch> stretches, const Model& model);

  /// The setup: a point of CL coordinates p lies at turn * p + origin_mm in the base frame, all
  /// joints at zero. Needs no inverse kinematics: the table is where the workpiece is.
  std::optional<Collision> first_collision(const Mat3& turn, const Vec3& origin_mm) const;

  /// Whether the place of the CL origin counts; if not, any serves.
  bool needs_origin() const { return !in_table_frame_.empty(); }
  /// See above. Grows beyond the usual for very long paths, to bound the work.
  double step_mm() const { return step_mm_; }

 private:
  struct Part {
    std::string name;
    machine::ToolCylinder cylinder;
    bool from_gauge_line = false;
  };
  struct Thing {
    std::string name;
    Obstacle shape;
  };
  /// The earlier of `known` and the first collision with `things`, which are in CL coordinates.
  std::optional<Collision> earliest(const std::vector<Thing>& things,
                                    std::optional<Collision> known) const;

  Places places_;
  std::vector<Part> parts_;
  std::vector<Thing> in_table_frame_;
  double safety_mm_ = default_safety_mm;
  double step_mm_ = 0.0;
  std::optional<Collision> with_workpiece_jig_;  ///< the same in every setup
};

}  // namespace pentapost::clearance
