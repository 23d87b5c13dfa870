#pragma once

#include "pentapost/reorient/axis_rates.hpp"
#include "pentapost/reorient/piece.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace pentapost::reorient {

/// Pieces of a path, those of like motion together: halves of halves, down to a few. A search for
/// the largest of something leaves out whole halves that cannot hold it.
class PieceTree {
 public:
  struct Node {
    MotionGroup group;                 ///< the motions of all pieces, through their whole time
    double time_s = 0.0;               ///< of all pieces
    double farthest_turn_rad = 0.0;    ///< from a piece to an end of its move, the most
    std::uint32_t begin = 0, end = 0;  ///< pieces
    std::uint32_t second_half = 0;     ///< the first follows the node itself; 0: not divided
  };

  explicit PieceTree(std::vector<Piece> pieces);

  const std::vector<Node>& nodes() const { return nodes_; }  ///< the first is the whole path
  std::span<const Piece> pieces_of(const Node& node) const {
    return {pieces_.data() + node.begin, pieces_.data() + node.end};
  }
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  void build(std::uint32_t begin, std::uint32_t end);
  Node node_of(std::uint32_t begin, std::uint32_t end) const;

  std::vector<Piece> pieces_;
  std::vector<Node> nodes_;
  double turn_scale_ = 0.0, tip_scale_ = 0.0, speed_scale_ = 0.0;  ///< against an axis of length 1
};

}  // namespace pentapost::reorient
