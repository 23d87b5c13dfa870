#pragma once

#include "pentapost/cl/dialects.hpp"
#include "pentapost/cl/words.hpp"
#include "pentapost/core/diagnostics.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::cl {

/// A CIRCLE or MOVARC that waits for its end point.
struct ArcStatement {
  Vec3 centre_mm = Vec3::Zero();
  Vec3 vector = Vec3::UnitZ();           ///< unit, as written
  std::optional<double> radius_mm = {};  ///< as stated
  int turns = 1;                         ///< TIMES: the sweep is at most this many whole turns
  std::optional<double> angle_rad = {};  ///< as stated, > 0
  ArcSense sense = ArcSense::from_neighbours;
  std::uint32_t line = 0;
};

/// Reads the words of a CIRCLE or MOVARC; nullopt with the reason in `fault`.
/// @param sense  of the dialect; a word in the statement comes first.
std::optional<ArcStatement> read_arc(const Words& words, ArcSense sense, double mm_per_unit,
                                     std::string& fault);

/// An arc between two points, or why there is none.
struct MadeArc {
  std::optional<path::Arc> arc = {};  ///< nullopt: a straight move, or an error
  bool sense_is_open = false;         ///< `arc` runs right-handed, its neighbours are to decide
  bool is_error = false;
  std::string remark = {};  ///< not empty: to be reported
};

/// @param resolution_mm  one unit in the last place of the coordinates.
MadeArc make_arc(const ArcStatement& statement, const Vec3& from_mm, const Vec3& to_mm,
                 double resolution_mm);

/// `arc` about the same centre between the same points the other way round.
path::Arc reversed(const path::Arc& arc);

/// Direction (unit) in which an arc leaves or reaches `point_mm`, which lies on it.
Vec3 arc_tangent(const path::Arc& arc, const Vec3& point_mm);

/// Gives the arcs of `open_events` (indices into path.events, rising) the sense that is tangent to
/// the moves before and behind, with a diagnostic each.
void settle_open_arcs(path::ToolPath& path, const std::vector<std::size_t>& open_events,
                      Diagnostics& diagnostics);

}  // namespace pentapost::cl
