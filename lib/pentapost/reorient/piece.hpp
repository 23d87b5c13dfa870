#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <vector>

namespace pentapost::reorient {

/// What the tool does at one place of the path. CL coordinates.
struct ToolMotion {
  Vec3 axis = Vec3::UnitZ();       ///< unit
  Vec3 turn_rad_s = Vec3::Zero();  ///< angular velocity of the axis, perpendicular to it
  Vec3 tip_mm = Vec3::Zero();
  Vec3 tip_mm_s = Vec3::Zero();  ///< velocity of the tip
};

/// A short part of a cutting move, by the middle of its time; or, with no time, a point that the
/// tool is positioned at.
struct Piece {
  ToolMotion middle;
  double time_s = 0.0;  ///< at the programmed feed
  /// By which the tool axis turns in the move, from its start to the middle of the piece and on.
  float turn_before_rad = 0.0F, turn_after_rad = 0.0F;
  std::uint32_t point = 0;      ///< end of the move
  std::uint32_t station = 0;    ///< of ToolPieces
  float half_sweep_rad = 0.0F;  ///< of an arc, in the piece
  bool is_straight = true;      ///< the velocity of the tip is that of the whole piece

  double half_turn_rad() const { return 0.5 * time_s * middle.turn_rad_s.norm(); }
  /// At a time from the middle, at most half of time_s either way.
  ToolMotion at(double from_middle_s) const;
};

/// The tool axis in the middle of a piece, in the order of the path.
struct Station {
  Vec3 axis;
  double time_s;      ///< since the start of the run
  std::uint32_t run;  ///< of cutting moves that follow each other
};

/// What one tool cuts.
struct ToolPieces {
  double gauge_length_mm = 0.0;  ///< 0 where unknown
  std::vector<Piece> pieces;
  std::vector<Station> stations;  ///< one a piece
};

/// Divides the path so finely that the tool axis turns by no more than about a degree within a
/// piece, nor an arc.
///
/// @param tool_path  in CL coordinates; holes expanded. Moves without a feed have no time.
std::vector<ToolPieces> pieces_of(const path::ToolPath& tool_path, const plan::Settings& settings);

}  // namespace pentapost::reorient
