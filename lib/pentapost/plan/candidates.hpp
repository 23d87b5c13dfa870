#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace pentapost::plan {

/// Where on the sphere the first rotary axis is free (lib/README.md section 4).
struct PoleZone {
  double radius_rad = 0.0;  ///< tilts up to this are the pole
  bool at_zero = false;     ///< the pole gamma = 0 is within reach
  bool at_pi = false;       ///< the pole gamma = pi is within reach
};

/// @param rounding_rad  of the tool axes as written.
/// @param freedom_rad  bound of what the axis may be changed by in all; 0 for a flank cut.
PoleZone pole_zone(const kinematics::Model& model, double rounding_rad, double freedom_rad);

/// What the tool axis may be changed by at a pole or at the edge of the reach: 0.01 deg, at most
/// half of the tolerance; 0 for a flank cut.
double axis_freedom_rad(double axis_tolerance_rad, bool flank);

/// A half-open run of CL points that one tool cuts.
struct PointRange {
  std::uint32_t begin = 0, end = 0;
};

/// How the move to a point continues the ways to reach the points before it.
enum class Link : std::uint8_t {
  start,       ///< nothing before it, or only points at the pole
  continuous,  ///< both branches go on
  over_pole,   ///< the pole lies between: a point, a stretch, or the inside of the move
  broken,      ///< the axis turns about by a rapid: nothing goes on
};

/// All ways to reach every point of a range, unwrapped so that each branch is continuous along the
/// path between two passages of the pole.
struct Candidates {
  PointRange range;
  int branches = 1;  ///< 1 with fewer than two rotary joints
  // columns over the range
  std::array<std::vector<double>, 2> first_rad;  ///< by branch; unwrapped; not used at the pole
  std::vector<double> second_rad;  ///< of branch 0; the other one is 2 beta_zero - this
  std::vector<Link> link;
  std::vector<std::uint8_t> pole;  ///< 0: off the pole; 1: gamma = 0; 2: gamma = pi

  /// A move that passes the pole between its points.
  struct Crossing {
    std::uint32_t point;  ///< the move's end
    double fraction;
    std::uint8_t pole;  ///< 1 or 2
  };
  std::vector<Crossing> crossings;
  double largest_freedom_rad =
      0.0;  ///< largest change of a tool axis: to the pole, or to the edge of the reach

  double second_of(const kinematics::Model& model, std::uint32_t point, int branch) const {
    const double plus = second_rad[point - range.begin];
    return branch == 0 ? plus : 2.0 * model.beta_zero_rad - plus;
  }
  double first_of(std::uint32_t point, int branch) const {
    return first_rad[static_cast<std::size_t>(branch)][point - range.begin];
  }
};

/// @param tool_path  in the table's orientation.
/// @param slack_rad  see kinematics::inverse_rotary.
/// @return Problem out_of_reach or half_turn with the CL line.
Result<Candidates> find_candidates(const kinematics::Model& model, const path::ToolPath& tool_path,
                                   PointRange range, const PoleZone& zone, double slack_rad);

/// Direction of the pole 1 or 2 in the table frame.
Vec3 pole_axis(const kinematics::Model& model, std::uint8_t pole);

/// Value of the first rotary joint, in [-pi, pi], with which `branch` comes to the pole or leaves
/// it along the great circle through `towards` (lib/README.md section 4; Sun et al. 2023 Table 1, n
/// = 1).
double first_at_pole_rad(const kinematics::Model& model, std::uint8_t pole, const Vec3& towards,
                         int branch);

/// Value of the second rotary joint at the pole, as `branch` gets there.
double second_at_pole_rad(const kinematics::Model& model, std::uint8_t pole, int branch);

}  // namespace pentapost::plan
