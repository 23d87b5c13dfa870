#include "pentapost/reorient/piece_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pentapost::reorient {
namespace {

constexpr std::uint32_t fewest_pieces = 8;
constexpr std::size_t columns = 12;

double column(const Piece& piece, std::size_t which) {
  const ToolMotion& motion = piece.middle;
  const auto index = static_cast<Eigen::Index>(which % 3);
  switch (which / 3) {
    case 0:
      return motion.axis[index];
    case 1:
      return motion.turn_rad_s[index];
    case 2:
      return motion.tip_mm[index];
    default:
      return motion.tip_mm_s[index];
  }
}

struct Extent {
  std::array<double, columns> lower{}, upper{};
};

Extent extent_of(std::span<const Piece> pieces) {
  Extent extent;
  for (std::size_t i = 0; i < columns; ++i)
    extent.lower[i] = extent.upper[i] = column(pieces.front(), i);
  for (const Piece& piece : pieces)
    for (std::size_t i = 0; i < columns; ++i) {
      const double value = column(piece, i);
      extent.lower[i] = std::min(extent.lower[i], value);
      extent.upper[i] = std::max(extent.upper[i], value);
    }
  return extent;
}

Vec3 middle_of(const Extent& extent, std::size_t first) {
  const auto at = [&](std::size_t i) { return 0.5 * (extent.lower[i] + extent.upper[i]); };
  return {at(first), at(first + 1), at(first + 2)};
}

/// Angle between two unit vectors by their distance, at most a little too large.
double angle_by_chord_rad(double chord) { return 2.0 * std::asin(std::min(1.0, 0.5 * chord)); }

}  // namespace

PieceTree::PieceTree(std::vector<Piece> pieces) : pieces_{std::move(pieces)} {
  if (pieces_.empty()) return;
  double turn_rad_s = 0.0, speed_mm_s = 0.0;
  for (const Piece& piece : pieces_) {
    turn_rad_s = std::max(turn_rad_s, piece.middle.turn_rad_s.squaredNorm());
    speed_mm_s = std::max(speed_mm_s, piece.middle.tip_mm_s.squaredNorm());
  }
  turn_rad_s = std::sqrt(turn_rad_s);
  speed_mm_s = std::sqrt(speed_mm_s);
  turn_scale_ = turn_rad_s > 0.0 ? 1.0 / turn_rad_s : 0.0;
  speed_scale_ = speed_mm_s > 0.0 ? 1.0 / speed_mm_s : 0.0;
  // The arm turns a rotary speed into one of the tip.
  tip_scale_ = std::min(turn_rad_s * speed_scale_, 0.01);
  nodes_.reserve(4 * pieces_.size() / fewest_pieces + 1);
  build(0, static_cast<std::uint32_t>(pieces_.size()));
}

void PieceTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t place = nodes_.size();
  nodes_.push_back(node_of(begin, end));
  if (end - begin <= fewest_pieces) return;
  const Extent extent = extent_of({pieces_.data() + begin, pieces_.data() + end});
  const std::array<double, 4> scale{1.0, turn_scale_, tip_scale_, speed_scale_};
  std::size_t widest = 0;
  double width = -1.0;
  for (std::size_t i = 0; i < columns; ++i)
    if (const double each = scale[i / 3] * (extent.upper[i] - extent.lower[i]); each > width) {
      widest = i;
      width = each;
    }
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(pieces_.begin() + begin, pieces_.begin() + middle, pieces_.begin() + end,
                   [&](const Piece& x, const Piece& y) {
                     const double at_x = column(x, widest), at_y = column(y, widest);
                     return at_x != at_y ? at_x < at_y : x.point < y.point;
                   });
  build(begin, middle);
  nodes_[place].second_half = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

PieceTree::Node PieceTree::node_of(std::uint32_t begin, std::uint32_t end) const {
  const std::span<const Piece> pieces{pieces_.data() + begin, pieces_.data() + end};
  const Extent extent = extent_of(pieces);
  Node node;
  node.begin = begin;
  node.end = end;
  const Vec3 axis = middle_of(extent, 0);
  node.group.centre.axis =
      axis.squaredNorm() > 1e-6 ? Vec3{axis.normalized()} : pieces.front().middle.axis;
  node.group.centre.turn_rad_s = middle_of(extent, 3);
  node.group.centre.tip_mm = middle_of(extent, 6);
  node.group.centre.tip_mm_s = middle_of(extent, 9);
  double axis_chord = 0.0;
  for (const Piece& piece : pieces) {
    const ToolMotion& motion = piece.middle;
    const double turn_rad_s = motion.turn_rad_s.norm(), half_s = 0.5 * piece.time_s;
    // An angle is at most pi / 2 of its chord, and this small one hardly more than it.
    axis_chord =
        std::max(axis_chord, (motion.axis - node.group.centre.axis).norm() + half_s * turn_rad_s);
    node.group.spread.turn_rad_s = std::max(
        node.group.spread.turn_rad_s, (motion.turn_rad_s - node.group.centre.turn_rad_s).norm());
    node.group.spread.tip_mm =
        std::max(node.group.spread.tip_mm, (motion.tip_mm - node.group.centre.tip_mm).norm() +
                                               half_s * motion.tip_mm_s.norm());
    node.group.spread.tip_mm_s =
        std::max(node.group.spread.tip_mm_s, (motion.tip_mm_s - node.group.centre.tip_mm_s).norm() +
                                                 piece.half_sweep_rad * motion.tip_mm_s.norm());
    node.group.largest_turn_rad_s = std::max(node.group.largest_turn_rad_s, turn_rad_s);
    node.group.largest_tip_mm_s = std::max(node.group.largest_tip_mm_s, motion.tip_mm_s.norm());
    node.time_s += piece.time_s;
    node.farthest_turn_rad =
        std::max({node.farthest_turn_rad, static_cast<double>(piece.turn_before_rad),
                  static_cast<double>(piece.turn_after_rad)});
  }
  node.group.spread.axis_rad = angle_by_chord_rad(axis_chord);
  const double angle_rad = std::min(node.group.spread.axis_rad, 0.5 * pi);
  node.group.axis_sine = std::sin(angle_rad);
  node.group.axis_cosine = std::cos(angle_rad);
  return node;
}

}  // namespace pentapost::reorient
