#include "pentapost/plan/cutting.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/plan/choice.hpp"
#include "pentapost/plan/drilling.hpp"
#include "pentapost/plan/feed.hpp"
#include "pentapost/plan/linearise.hpp"
#include "pentapost/plan/move_curve.hpp"
#include "pentapost/plan/native_arc.hpp"
#include "pentapost/plan/plain_block.hpp"
#include "pentapost/plan/retract.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {
namespace {

using path::Block;

/// Share of a move that a turn in place takes: the tip does not get further in it.
constexpr double standing_share = 1e-9;
/// How closely rapids keep their line where joint values run evenly.
constexpr double rapid_tolerance_mm = 1.0;
constexpr double rapid_tolerance_rad = 2.0 * rad_per_deg;
/// Blocks of a program beyond one a point: far above any real need, so that no input exhausts the
/// memory.
constexpr std::uint64_t largest_inserted_count = 10'000'000;
/// Rotary values this close are the same posture.
constexpr double same_rad = 1e-6;

bool same(const RotaryPair& x, const RotaryPair& y) {
  return std::abs(x.first_rad - y.first_rad) <= same_rad &&
         std::abs(x.second_rad - y.second_rad) <= same_rad;
}

class Cutting {
 public:
  Cutting(const kinematics::Model& model, const JointRanges& ranges,
          const path::ToolPath& tool_path, const Settings& settings, const AxisPath& axis_path,
          double slack_rad, double gauge_length_mm, bool check_linear, Frame& frame,
          Program& program)
      : model_{model},
        ranges_{ranges},
        tool_path_{tool_path},
        settings_{settings},
        axis_path_{axis_path},
        slack_rad_{slack_rad},
        check_linear_{check_linear},
        maker_{model, ranges, settings, gauge_length_mm, check_linear},
        plain_block_{model, settings, maker_},
        feed_rule_{model, settings, maker_.columns()},
        frame_{frame},
        program_{program},
        departure_{axis_path.departures.begin()},
        crossing_{axis_path.crossings.begin()} {}

  Status run() {
    const std::uint32_t begin = axis_path_.range.begin;
    rotary_ = axis_path_.at(begin);
    auto posture = maker_.posture(tool_path_.tip_wp_mm[begin], rotary_, tool_path_.cl_line[begin]);
    if (!posture) return std::move(posture).error();
    posture_ = *posture;
    const bool by_feed = tool_path_.move[begin] == path::Move::feed && frame_.feed_mm_min();
    // A feed down from far would take minutes.
    constexpr double feed_down_mm = 10.0;
    const double distance_mm =
        by_feed ? std::min(feed_down_mm, settings_.retract_mm) : settings_.retract_mm;
    frame_.approach(*posture, posture_above(place_of(begin), rotary_, distance_mm, maker_), begin,
                    by_feed);
    for (std::uint32_t point = begin; point < axis_path_.range.end; ++point) {
      if (point > begin) {
        frame_.take_events(point);
        if (auto status = move_to(point); !status) return status;
      }
      if (auto status = depart(point); !status) return status;
    }
    withdraw();
    return ok();
  }

 private:
  std::uint8_t pole_at(std::uint32_t point) const {
    return axis_path_.pole[point - axis_path_.range.begin];
  }
  /// Whether the point is taken as the pole.
  bool is_pole(std::uint32_t point) const {
    return pole_at(point) != 0 && model_.rotary_count == 2;
  }
  Vec3 planned_axis(std::uint32_t point) const {
    return is_pole(point) ? pole_axis(model_, pole_at(point)) : tool_path_.axis_wp[point];
  }

  /// Where the tool is once the move to `point` is done: over a hole at its retract level.
  const Vec3& reached_mm(std::uint32_t point) const {
    return tool_path_.move[point] == path::Move::hole ? hole_retract_mm_
                                                      : tool_path_.tip_wp_mm[point];
  }

  PlannedMove planned_move(std::uint32_t point) const {
    const Vec3 &from_mm = reached_mm(point - 1), &to_mm = tool_path_.tip_wp_mm[point];
    PlannedMove move{.cl = {from_mm, tool_path_.axis_wp[point - 1], to_mm,
                            tool_path_.axis_wp[point], frame_.arc()}};
    if (is_pole(point - 1) || is_pole(point))
      move.by_pole.emplace(from_mm, planned_axis(point - 1), to_mm, planned_axis(point),
                           frame_.arc());
    return move;
  }

  /// A head that has turned takes the tool out along its axis: the machine's own way up would not.
  void withdraw() {
    if (!model_.head_turns || posture_.printed == RotaryPair{}) return;
    const std::uint32_t last = axis_path_.range.end - 1;
    if (const auto away = posture_above(place_of(last), rotary_, settings_.retract_mm, maker_))
      frame_.add_block(*away, last, Block::Kind::rapid).on_path = false;
  }

  void warn_of_spindle(std::uint32_t point) {
    if (!frame_.spindle_is_missing()) return;
    const std::uint32_t line = tool_path_.cl_line[point];
    frame_.comment("warning: the spindle is off, the CL data do not start it", line);
    program_.diagnostics.add({Severity::warning, Code::spindle_off, line,
                              "the tool cuts at CL line " + std::to_string(line) +
                                  " with the spindle off: the CL data do not start it"});
  }

  Status move_to(std::uint32_t point) {
    if (tool_path_.move[point] != path::Move::rapid) warn_of_spindle(point);
    const RotaryPair& arrival = axis_path_.at(point);
    switch (tool_path_.move[point]) {
      case path::Move::rapid:
        return rapid_to(point, arrival);
      case path::Move::hole:
        return drill_at(point, arrival);
      case path::Move::feed:
        break;
    }
    if (auto done = cut_plainly(point, arrival)) return *std::move(done);
    const PlannedMove move = planned_move(point);
    account(move.cl.length_mm());
    if (same(rotary_, arrival) && !crosses(point)) {
      if (const auto pieces = native_arc(model_, settings_, maker_, move.planned(), rotary_,
                                         posture_, tool_path_.cl_line[point]))
        return write_arc(point, move.cl, *pieces);
    }
    return cut(point, move, arrival);
  }

  bool crosses(std::uint32_t point) const {
    return crossing_ != axis_path_.crossings.end() && crossing_->point == point;
  }

  void account(double length_mm) {
    program_.length_mm += length_mm;
    if (const auto feed = frame_.feed_mm_min(); feed && length_mm > 0.0)
      program_.programmed_time_s += 60.0 * length_mm / *feed;
  }

  /// The usual move: a line that one block follows; nullopt: cut() has to look closer.
  std::optional<Status> cut_plainly(std::uint32_t point, const RotaryPair& arrival) {
    if (frame_.arc() != nullptr || turn_before_move_ || pending_rewind_ || crosses(point))
      return std::nullopt;
    const Vec3 &tip_from_mm = reached_mm(point - 1), &tip_to_mm = tool_path_.tip_wp_mm[point];
    auto end = maker_.posture(tip_to_mm, arrival, tool_path_.cl_line[point]);
    if (!end) return std::move(end).error();
    const double length_mm = (tip_to_mm - tip_from_mm).norm();
    if (!plain_block_.suffices({tip_from_mm, tool_path_.axis_wp[point - 1], tip_to_mm,
                                tool_path_.axis_wp[point], length_mm},
                               posture_, *end))
      return std::nullopt;
    account(length_mm);
    const bool moves = end->word != posture_.word;
    Block& block = frame_.add_block(*end, point, Block::Kind::line);
    if (moves || frame_.feed_mm_min())
      if (auto status = feed_rule_.set(block, posture_, *end, length_mm, frame_.feed_mm_min());
          !status)
        return status;
    posture_ = *end;
    rotary_ = arrival;
    return ok();
  }

  RetractPlace place_of(std::uint32_t point) const {
    return {reached_mm(point), tool_path_.axis_wp[point], point, tool_path_.cl_line[point]};
  }

  Status rapid_to(std::uint32_t point, const RotaryPair& arrival) {
    if (pending_rewind_) return rapid_by_safe_end(point, arrival);
    if (settings_.output == Output::axes && !same(rotary_, arrival)) {
      auto status = rapid_in_parts(point, arrival);
      if (status || status.error().code == Code::too_large) return status;
      return rapid_by_safe_end(point, arrival);
    }
    if (crosses(point)) ++crossing_;
    turn_before_move_.reset();  // the rapid turns the axis on its way
    return rapid_block(point, arrival);
  }

  Status rapid_block(std::uint32_t point, const RotaryPair& arrival) {
    auto posture = maker_.posture(tool_path_.tip_wp_mm[point], arrival, tool_path_.cl_line[point]);
    if (!posture) return std::move(posture).error();
    frame_.add_block(*posture, point, Block::Kind::rapid);
    posture_ = *posture;
    rotary_ = arrival;
    return ok();
  }

  /// With joint values for words a turning rapid would take the tool off its line by far, and into
  /// the part: it is divided like a cut, though not as finely.
  /// @return a Problem, and nothing written, where the machine cannot follow the line, or
  /// too_large.
  Status rapid_in_parts(std::uint32_t point, const RotaryPair& arrival) {
    Settings coarse = settings_;
    coarse.tip_tolerance_mm = std::max(settings_.tip_tolerance_mm, rapid_tolerance_mm);
    coarse.axis_tolerance_rad = std::max(settings_.axis_tolerance_rad, rapid_tolerance_rad);
    const PlannedMove move = planned_move(point);
    ends_.clear();
    Posture from = posture_;
    for (const MovePart& part : parts_of(point, arrival)) {
      if (auto status = linearise(model_, coarse, maker_, move, part, from, slack_rad_,
                                  tool_path_.cl_line[point], ends_);
          !status)
        return status;
      from = ends_.back().posture;
    }
    if (is_too_large(ends_.size())) return too_large(tool_path_.cl_line[point]);
    for (const Waypoint& end : ends_) {
      Block& block = frame_.add_block(end.posture, point, Block::Kind::rapid);
      block.fraction = end.fraction;
      if (end.fraction != 1.0) ++program_.inserted_points;
    }
    posture_ = ends_.back().posture;
    rotary_ = arrival;
    return ok();
  }

  /// The axes cannot follow the rapid from end to end: the tool goes by way of its safe end.
  Status rapid_by_safe_end(std::uint32_t point, const RotaryPair& arrival) {
    pending_rewind_.reset();
    if (crosses(point)) ++crossing_;
    turn_before_move_.reset();
    report_reposition(arrival, tool_path_.cl_line[point]);
    if (const auto away = posture_above(place_of(point - 1), rotary_, settings_.retract_mm, maker_))
      frame_.add_block(*away, point, Block::Kind::rapid).on_path = false;
    frame_.leave();
    auto posture = maker_.posture(tool_path_.tip_wp_mm[point], arrival, tool_path_.cl_line[point]);
    if (!posture) return std::move(posture).error();
    frame_.approach(*posture, posture_above(place_of(point), arrival, settings_.retract_mm, maker_),
                    point, false);
    posture_ = *posture;
    rotary_ = arrival;
    return ok();
  }

  Status drill_at(std::uint32_t point, const RotaryPair& arrival) {
    auto above =
        drill(tool_path_, point, posture_, arrival, !same(rotary_, arrival), maker_, frame_);
    if (!above) return std::move(above).error();
    posture_ = *above;
    rotary_ = arrival;
    hole_retract_mm_ =
        tool_path_.tip_wp_mm[point] + frame_.cycle()->clearance_mm * tool_path_.axis_wp[point];
    return ok();
  }

  /// The parts of a cutting move, in order; a turn in place is a part of no length.
  std::vector<MovePart> parts_of(std::uint32_t point, const RotaryPair& arrival) {
    std::vector<MovePart> parts;
    const auto add = [&](MovePart::Kind kind, int branch, double to_fraction,
                         const RotaryPair& to) {
      const double from_fraction = parts.empty() ? 0.0 : parts.back().fraction_to;
      const RotaryPair from = parts.empty() ? rotary_ : parts.back().to;
      parts.push_back({kind, branch, from_fraction, to_fraction, from, to});
    };
    const auto add_turn = [&](double fraction, const RotaryPair& to) {
      add(MovePart::Kind::even, 0, fraction + standing_share, to);
      parts.back().in_place = true;
    };
    if (turn_before_move_) {
      add_turn(0.0, *turn_before_move_);
      turn_before_move_.reset();
    }
    if (crosses(point)) {
      const AxisPath::Crossing& crossing = *crossing_++;
      const double fraction =
          std::clamp(crossing.fraction, 2.0 * standing_share, 1.0 - 2.0 * standing_share);
      add(MovePart::Kind::branch, crossing.branch_before, fraction, crossing.before);
      if (!same(crossing.before, crossing.after)) add_turn(fraction, crossing.after);
      add(MovePart::Kind::branch, crossing.branch_after, 1.0, arrival);
      return parts;
    }
    const std::uint8_t branch = axis_path_.branch[point - axis_path_.range.begin];
    const RotaryPair from = parts.empty() ? rotary_ : parts.back().to;
    if (branch == AxisPath::at_rest)
      add(from == arrival ? MovePart::Kind::still : MovePart::Kind::even, 0, 1.0, arrival);
    else
      add(MovePart::Kind::branch, branch, 1.0, arrival);
    return parts;
  }

  Status cut(std::uint32_t point, const PlannedMove& move, const RotaryPair& arrival) {
    std::vector<MovePart> parts = parts_of(point, arrival);
    std::optional<MovePart> rest;
    double rewind_rad = 0.0;
    if (pending_rewind_) {
      rewind_rad = *pending_rewind_;
      pending_rewind_.reset();
      rest = split_at_limit(model_, move.planned(), *ranges_.rotary_rad[0], parts.back(),
                            rewind_rad, slack_rad_);
    }
    for (const MovePart& part : parts)
      if (auto status = cut_part(point, move, part); !status) return status;
    if (!rest) return ok();
    RotaryPair after = rotary_;
    after.first_rad += rewind_rad;
    if (auto status =
            reposition({move.cl.tip_mm(rest->fraction_from),
                        move.planned().axis(rest->fraction_from), point, tool_path_.cl_line[point]},
                       after);
        !status)
      return status;
    rest->from = after;
    return cut_part(point, move, *rest);
  }

  Status cut_part(std::uint32_t point, const PlannedMove& move, const MovePart& part) {
    ends_.clear();
    const std::uint32_t line = tool_path_.cl_line[point];
    if (auto status =
            linearise(model_, settings_, maker_, move, part, posture_, slack_rad_, line, ends_);
        !status)
      return status;
    if (is_too_large(ends_.size())) return too_large(line);
    double fraction = part.fraction_from;
    for (const Waypoint& end : ends_) {
      const bool is_point = end.fraction == 1.0;
      const bool moves = end.posture.word != posture_.word;
      if (!is_point) ++program_.inserted_points;
      Block& block = frame_.add_block(end.posture, point, Block::Kind::line);
      block.fraction = end.fraction;
      const double length_mm = (end.fraction - fraction) * move.cl.length_mm();
      if (moves || frame_.feed_mm_min()) {
        if (auto status = feed_rule_.set(block, posture_, end.posture,
                                         part.in_place ? 0.0 : length_mm, frame_.feed_mm_min());
            !status)
          return status;
      }
      posture_ = end.posture;
      fraction = end.fraction;
    }
    rotary_ = part.to;
    return ok();
  }

  bool is_too_large(std::size_t more) const {
    return program_.inserted_points + more > largest_inserted_count;
  }

  static Problem too_large(std::uint32_t line) {
    return {.code = Code::too_large,
            .message = "the path up to CL line " + std::to_string(line) + " needs more than " +
                       std::to_string(largest_inserted_count) +
                       " blocks beside those that end at its points",
            .cl_line = line};
  }

  Status write_arc(std::uint32_t point, const path::Segment& segment,
                   const std::vector<ArcPiece>& pieces) {
    if (is_too_large(pieces.size())) return too_large(tool_path_.cl_line[point]);
    double fraction = 0.0;
    for (const ArcPiece& piece : pieces) {
      frame_.act(piece.centre, tool_path_.cl_line[point]);
      Block& block = frame_.add_block(
          piece.posture, point,
          piece.clockwise ? Block::Kind::arc_clockwise : Block::Kind::arc_counterclockwise);
      block.fraction = piece.fraction;
      if (auto status = feed_rule_.set(block, posture_, piece.posture,
                                       (piece.fraction - fraction) * segment.length_mm(),
                                       frame_.feed_mm_min());
          !status)
        return status;
      if (piece.fraction != 1.0) ++program_.inserted_points;
      posture_ = piece.posture;
      fraction = piece.fraction;
    }
    rotary_ = axis_path_.at(point);
    return ok();
  }

  /// Where the path goes on from `point` with other rotary values.
  Status depart(std::uint32_t point) {
    for (; departure_ != axis_path_.departures.end() && departure_->point == point; ++departure_) {
      if (departure_->inside) {
        pending_rewind_ = departure_->turns_rad;
      } else if (departure_->retract) {
        if (auto status = reposition(place_of(point), departure_->pair); !status) return status;
      } else if (!same(rotary_, departure_->pair)) {
        turn_before_move_ = departure_->pair;
      }
    }
    return ok();
  }

  std::string reposition_text(const RotaryPair& after) const {
    std::string text;
    const auto name = [&](std::size_t axis, double from_rad, double to_rad) {
      if (std::abs(from_rad - to_rad) <= same_rad) return;
      text += (text.empty() ? "" : ", ") + model_.rotary_names[axis] + " from " +
              number_text(from_rad * deg_per_rad, 3) + " to " +
              number_text(to_rad * deg_per_rad, 3);
    };
    name(0, rotary_.first_rad, after.first_rad);
    name(1, rotary_.second_rad, after.second_rad);
    return "retract to reposition " + text + " deg";
  }

  void report_reposition(const RotaryPair& after, std::uint32_t cl_line) {
    const std::string text = reposition_text(after);
    frame_.comment(text, cl_line);
    program_.retracts.push_back({cl_line, text});
    program_.diagnostics.add(
        {Severity::warning, Code::retract_inserted, cl_line,
         text + " at CL line " + std::to_string(cl_line) +
             ": no continuous sequence of rotary values stays within the ranges"});
  }

  Status reposition(const RetractPlace& place, const RotaryPair& after) {
    report_reposition(after, place.cl_line);
    auto back =
        retract_and_reposition(place, rotary_, after, settings_, check_linear_, maker_, frame_);
    if (!back) return std::move(back).error();
    posture_ = *back;
    rotary_ = after;
    return ok();
  }

  const kinematics::Model& model_;
  const JointRanges& ranges_;
  const path::ToolPath& tool_path_;
  const Settings& settings_;
  const AxisPath& axis_path_;
  const double slack_rad_;
  const bool check_linear_;
  BlockMaker maker_;
  const PlainBlock plain_block_;
  const FeedRule feed_rule_;
  Frame& frame_;
  Program& program_;
  std::vector<AxisPath::Departure>::const_iterator departure_;
  std::vector<AxisPath::Crossing>::const_iterator crossing_;
  std::vector<Waypoint> ends_;
  RotaryPair rotary_;                    ///< exact values at the end of the last block
  Posture posture_;                      ///< as printed there
  Vec3 hole_retract_mm_ = Vec3::Zero();  ///< of the last hole
  std::optional<RotaryPair> turn_before_move_;
  std::optional<double> pending_rewind_;
};

}  // namespace

Status cut_sequence(const kinematics::Model& model, const JointRanges& ranges,
                    const path::ToolPath& tool_path, const Settings& settings,
                    const Sequence& sequence, double gauge_length_mm, bool check_linear,
                    Frame& frame, Program& program) {
  auto chosen =
      choose(model, ranges, tool_path, sequence.range, settings, gauge_length_mm, check_linear);
  if (!chosen) return std::move(chosen).error();
  program.choices.push_back({*std::move(chosen), sequence.tool_number, gauge_length_mm});
  const Choice& choice = program.choices.back().choice;
  program.axis_change_rad = std::max(program.axis_change_rad, choice.axis_change_rad);
  frame.begin_sequence(sequence);
  return Cutting{
      model,           ranges,       tool_path, settings, choice.axis_path, choice.slack_rad,
      gauge_length_mm, check_linear, frame,     program}
      .run();
}

}  // namespace pentapost::plan
