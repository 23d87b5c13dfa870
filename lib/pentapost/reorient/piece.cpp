#include "pentapost/reorient/piece.hpp"

#include "pentapost/analysis/cl_setting.hpp"
#include "pentapost/path/segment.hpp"
#include "pentapost/plan/sequences.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace pentapost::reorient {
namespace {

/// Turn of the tool axis, or sweep of an arc, in a piece; more where the path turns so much that
/// the pieces would outnumber its points many times.
class PieceTurn {
 public:
  explicit PieceTurn(const path::ToolPath& tool_path) {
    constexpr double finest_rad = 1.0 * rad_per_deg;
    constexpr double pieces_per_point = 2.0, spare_pieces = 50'000.0;
    double total_rad = 0.0;
    for (std::size_t point = 1; point < tool_path.size(); ++point)
      total_rad += angle_between_rad(tool_path.axis_wp[point - 1], tool_path.axis_wp[point]);
    for (const path::Event& event : tool_path.events)
      if (const auto* arc = std::get_if<path::Arc>(&event.what)) total_rad += arc->sweep_rad;
    const double pieces = pieces_per_point * static_cast<double>(tool_path.size()) + spare_pieces;
    largest_rad_ = std::max(finest_rad, total_rad / pieces);
  }

  int pieces(const path::Segment& segment) const {
    const double sweep_rad = segment.is_arc() ? segment.sweep_rad() : 0.0;
    const double turn_rad = std::max(segment.axis_angle_rad(), sweep_rad);
    return std::max(1, static_cast<int>(std::ceil(turn_rad / largest_rad_)));
  }

 private:
  double largest_rad_;
};

/// Adds the pieces of one sequence.
class SequencePieces {
 public:
  SequencePieces(const path::ToolPath& tool_path, ToolPieces& tool)
      : tool_path_{tool_path}, tool_{tool}, run_{next_run(tool)} {}

  /// The tool is positioned at the point, or turned there.
  void add_position(std::uint32_t point) {
    Piece piece;
    piece.point = point;
    piece.middle.axis = tool_path_.axis_wp[point];
    piece.middle.tip_mm = tool_path_.tip_wp_mm[point];
    run_ = next_run(tool_);
    time_s_ = 0.0;
    add(piece);
  }

  void add_move(const path::Segment& segment, double time_s, std::uint32_t point, int count) {
    const double turn_rad = segment.axis_angle_rad();
    Piece piece;
    piece.time_s = time_s / count;
    piece.point = point;
    piece.is_straight = !segment.is_arc();
    if (segment.is_arc())
      piece.half_sweep_rad = static_cast<float>(0.5 * segment.sweep_rad() / count);
    for (int i = 0; i < count; ++i) {
      const double middle = (i + 0.5) / count;
      piece.middle = {.axis = segment.axis(middle).normalized(),
                      .turn_rad_s = Vec3::Zero(),
                      .tip_mm = segment.tip_mm(middle),
                      .tip_mm_s = segment.tip_rate_mm(middle) / time_s};
      piece.turn_before_rad = static_cast<float>(middle * turn_rad);
      piece.turn_after_rad = static_cast<float>((1.0 - middle) * turn_rad);
      if (turn_rad > 0.0)
        piece.middle.turn_rad_s = piece.middle.axis.cross(segment.axis_rate(middle)) / time_s;
      add(piece);
    }
  }

 private:
  static std::uint32_t next_run(const ToolPieces& tool) {
    return tool.stations.empty() ? 0 : tool.stations.back().run + 1;
  }

  void add(Piece piece) {
    piece.station = static_cast<std::uint32_t>(tool_.stations.size());
    tool_.stations.push_back({piece.middle.axis, time_s_ + 0.5 * piece.time_s, run_});
    time_s_ += piece.time_s;
    tool_.pieces.push_back(piece);
  }

  const path::ToolPath& tool_path_;
  ToolPieces& tool_;
  std::uint32_t run_;
  double time_s_ = 0.0;
};

}  // namespace

ToolMotion Piece::at(double from_middle_s) const {
  const double speed_rad_s = middle.turn_rad_s.norm();
  ToolMotion motion = middle;
  motion.tip_mm += from_middle_s * middle.tip_mm_s;
  if (speed_rad_s == 0.0) return motion;
  const double angle_rad = from_middle_s * speed_rad_s;
  motion.axis = (std::cos(angle_rad) * middle.axis +
                 std::sin(angle_rad) / speed_rad_s * middle.turn_rad_s.cross(middle.axis))
                    .normalized();
  return motion;
}

std::vector<ToolPieces> pieces_of(const path::ToolPath& tool_path, const plan::Settings& settings) {
  const PieceTurn piece_turn{tool_path};
  std::map<double, std::size_t> by_gauge_length;
  std::vector<ToolPieces> tools;
  analysis::ClSetting setting{tool_path};
  for (const plan::Sequence& sequence : plan::sequences(tool_path)) {
    const auto gauge = settings.gauge_length_mm.find(sequence.tool_number);
    const double gauge_mm = gauge == settings.gauge_length_mm.end() ? 0.0 : gauge->second;
    const auto [place, is_new] = by_gauge_length.try_emplace(gauge_mm, tools.size());
    if (is_new) tools.push_back({.gauge_length_mm = gauge_mm, .pieces = {}, .stations = {}});
    SequencePieces pieces{tool_path, tools[place->second]};
    for (std::uint32_t point = sequence.range.begin; point < sequence.range.end; ++point) {
      setting.advance_to(point);
      if (point == sequence.range.begin || tool_path.move[point] != path::Move::feed) {
        pieces.add_position(point);
        continue;
      }
      const path::Segment segment{tool_path.tip_wp_mm[point - 1], tool_path.axis_wp[point - 1],
                                  tool_path.tip_wp_mm[point], tool_path.axis_wp[point],
                                  setting.arc()};
      const auto feed_mm_min = setting.feed_mm_min();
      if (segment.length_mm() == 0.0 || !feed_mm_min)
        pieces.add_position(point);
      else
        pieces.add_move(segment, 60.0 * segment.length_mm() / *feed_mm_min, point,
                        piece_turn.pieces(segment));
    }
  }
  return tools;
}

}  // namespace pentapost::reorient
