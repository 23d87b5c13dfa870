#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/path/segment.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace pentapost::clearance {

/// A tip and a tool axis (unit), CL coordinates.
struct Pose {
  Vec3 tip_mm;
  Vec3 axis;
};

/// All that a stretch of the path stays within: tips in a ball, tool axes in a cone.
struct Neighbourhood {
  Pose middle;
  double tip_radius_mm = 0.0;
  double axis_chord = 0.0;  ///< largest |axis - middle.axis|; 0 to 2
};

/// Points of the path that are cut with one tool, without a positioning in between.
struct Stretch {
  std::uint32_t begin = 0, end = 0;  ///< points; end excluded
  double gauge_length_mm = 0.0;      ///< tool tip to gauge line; 0 where nothing depends on it
};

/// A CL move.
struct Way {
  path::Segment segment;
  double tip_mm = 0.0;    ///< upper bound of the tip's way, evenly over the fraction
  double axis_rad = 0.0;  ///< turn of the tool axis
};

/// The places where a path takes the tool, with neighbourhoods of ever larger parts of it.
class Places {
 public:
  static constexpr std::uint32_t points_per_leaf = 8;
  static constexpr std::uint32_t no_child = 0xffffffff;

  /// A part of a stretch: the points from `begin` and the moves that lead to them.
  struct Node {
    Neighbourhood around;
    std::uint32_t begin = 0, end = 0;
    std::uint32_t second = no_child;  ///< the first child follows its parent; no_child: a leaf
  };

  /// @param path  CL coordinates; holes as single moves.
  /// @param stretches  in order, each with one point at least, otherwise std::logic_error.
  Places(const path::ToolPath& path, std::vector<Stretch> stretches);

  std::span<const Stretch> stretches() const noexcept { return stretches_; }
  /// The root of the nodes of a stretch.
  std::uint32_t root(std::size_t stretch) const { return roots_[stretch]; }
  const Node& node(std::uint32_t index) const { return nodes_[index]; }
  const Pose& pose(std::uint32_t point) const { return points_[point].pose; }
  /// The move that leads to `point`; nullopt: the first of a stretch, or a rapid, whose way is the
  /// control's own.
  std::optional<Way> way_to(std::uint32_t point) const;
  /// Of the point and the move that leads to it.
  Neighbourhood around(std::uint32_t point) const;
  std::uint32_t cl_line(std::uint32_t point) const { return points_[point].cl_line; }
  /// How far a place of the tool travels in all that is at most `lever_mm` away from the tip.
  double travel_mm(double lever_mm) const { return tip_travel_mm_ + lever_mm * axis_travel_rad_; }

 private:
  struct Point {
    Pose pose;
    std::uint32_t cl_line = 0;
    bool from_previous = false;  ///< the tool comes from the point before along the CL move
  };
  const path::Arc* arc_to(std::uint32_t point) const;
  /// @return the index of the node.
  std::uint32_t add_node(std::uint32_t begin, std::uint32_t end);

  struct ArcTo {
    std::uint32_t point;
    path::Arc arc;
  };
  std::vector<Point> points_;
  std::vector<ArcTo> arcs_;  ///< by point
  std::vector<Stretch> stretches_;
  std::vector<std::uint32_t> roots_;
  std::vector<Node> nodes_;
  double tip_travel_mm_ = 0.0, axis_travel_rad_ = 0.0;
};

}  // namespace pentapost::clearance
