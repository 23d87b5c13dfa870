#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/reorient/axis_rates.hpp"
#include "pentapost/reorient/piece.hpp"
#include "pentapost/reorient/piece_tree.hpp"

#include <cstdint>
#include <vector>

namespace pentapost::reorient {

/// Angles between the pole and the tool axis while it turns from `from_rad` to `to_rad`, counted
/// from a motion's axis.
Range<double> gammas(const ToolMotion& motion, const Vec3& pole, double from_rad, double to_rad);

/// In the whole move that a piece is of.
Range<double> gammas_of_move(const Piece& piece, const Vec3& pole);

/// How far a motion and a clamping may be off together.
Spread together(const Spread& of_motion, const Spread& of_clamping);

/// Of the motions in a piece from its middle.
Spread spread_of(const Piece& piece);
MotionGroup group_of(const Piece& piece);

/// Goes down the tree: `enter(node)` says whether to go on below a node, `take(piece)` gets pieces.
template <class Enter, class Take>
void descend(const PieceTree& tree, const Enter& enter, const Take& take) {
  if (tree.nodes().empty()) return;
  std::vector<std::uint32_t> waiting{0};
  while (!waiting.empty()) {
    const std::uint32_t place = waiting.back();
    waiting.pop_back();
    const PieceTree::Node& node = tree.nodes()[place];
    if (!enter(node)) continue;
    if (node.second_half == 0) {
      for (std::uint32_t piece = node.begin; piece < node.end; ++piece) take(piece);
    } else {
      waiting.push_back(node.second_half);
      waiting.push_back(place + 1);
    }
  }
}

}  // namespace pentapost::reorient
