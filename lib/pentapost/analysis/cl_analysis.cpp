#include "pentapost/analysis/cl_analysis.hpp"

#include "pentapost/analysis/cl_setting.hpp"
#include "pentapost/analysis/quiet_moves.hpp"
#include "pentapost/analysis/recorder.hpp"
#include "pentapost/analysis/stretch.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/plan/choice.hpp"
#include "pentapost/plan/move_curve.hpp"
#include "pentapost/plan/sequences.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace pentapost::analysis {
namespace {

using plan::AxisPath;
using plan::MovePart;
using plan::RotaryPair;

/// One sequence after the other.
class Walk {
 public:
  Walk(const kinematics::Model& model, const plan::JointRanges& ranges,
       const path::ToolPath& tool_path, const plan::Settings& settings,
       const AnalysisOptions& options)
      : model_{model},
        ranges_{ranges},
        tool_path_{tool_path},
        settings_{settings},
        zones_only_{options.zones_only},
        recorder_{model, settings, options},
        setting_{tool_path} {}

  Status run(const plan::SequenceChoice& sequence) {
    if (sequence.tool_number != tool_number_)
      recorder_.begin_operation(sequence.tool_number, operation_name());
    tool_number_ = sequence.tool_number;
    axis_path_ = &sequence.choice.axis_path;
    slack_rad_ = sequence.choice.slack_rad;
    gauge_length_mm_ = sequence.gauge_length_mm;
    if (zones_only_) quiet_.emplace(model_, settings_, recorder_.allowance(), gauge_length_mm_);
    departure_ = axis_path_->departures.begin();
    crossing_ = axis_path_->crossings.begin();
    recorder_.interrupt();
    forget_meeting();
    const std::uint32_t begin = axis_path_->range.begin;
    setting_.advance_to(begin);
    if (begin > 0) s_mm_ += (tip_mm(begin) - tip_mm(begin - 1)).norm();
    rotary_ = axis_path_->at(begin);
    depart(begin);
    for (std::uint32_t point = begin + 1; point < axis_path_->range.end; ++point) {
      setting_.advance_to(point);
      if (auto status = move_to(point); !status) return status;
      rotary_ = axis_path_->at(point);
      depart(point);
    }
    return ok();
  }

  PathAnalysis finish() && { return std::move(recorder_).finish(); }

 private:
  const Vec3& tip_mm(std::uint32_t point) const { return tool_path_.tip_wp_mm[point]; }

  Vec3 axis(std::uint32_t point) const {
    const std::uint8_t pole = axis_path_->pole[point - axis_path_->range.begin];
    return pole == 0 || model_.rotary_count != 2 ? tool_path_.axis_wp[point]
                                                 : plan::pole_axis(model_, pole);
  }

  PathPlace place(std::uint32_t point) const {
    return {point, tool_path_.cl_line[point], s_mm_, tip_mm(point)};
  }

  Status move_to(std::uint32_t point) {
    if (setting_.operation() != operation_) {
      operation_ = setting_.operation();
      recorder_.begin_operation(tool_number_, operation_name());
    }
    const double s_from_mm = s_mm_;
    if (tool_path_.move[point] != path::Move::feed) {
      s_mm_ += (tip_mm(point) - tip_mm(point - 1)).norm();
      if (crosses(point)) ++crossing_;
      reposition(with_rewind(Repositioning::Kind::rapid), point, tip_mm(point - 1),
                 axis_path_->at(point));
      return ok();
    }
    if (passes_quietly(point)) return ok();
    const path::Segment segment{tip_mm(point - 1), axis(point - 1), tip_mm(point), axis(point),
                                setting_.arc()};
    s_mm_ += segment.length_mm();
    if (segment.length_mm() == 0.0) {
      if (crosses(point)) ++crossing_;
      turn(with_rewind(Repositioning::Kind::turn_in_place), point, axis_path_->at(point));
      return ok();
    }
    const auto feed_mm_min = setting_.feed_mm_min();
    if (!feed_mm_min) return no_feed(point);
    const SurveyedMove move{.point = point,
                            .line = tool_path_.cl_line[point],
                            .s_from_mm = s_from_mm,
                            .length_mm = segment.length_mm(),
                            .time_s = 60.0 * segment.length_mm() / *feed_mm_min};
    cut(move, segment);
    recorder_.account(move);
    return ok();
  }

  /// What a move without a feed along the path is where the first axis has to be rewound in it.
  Repositioning::Kind with_rewind(Repositioning::Kind kind) {
    return std::exchange(pending_rewind_rad_, std::nullopt) ? Repositioning::Kind::retract : kind;
  }

  Problem no_feed(std::uint32_t point) const {
    const std::uint32_t line = tool_path_.cl_line[point];
    return {.code = Code::no_feed,
            .message = "the cutting move to CL line " + std::to_string(line) +
                       " has no feed; a FEDRAT before it is needed",
            .cl_line = line};
  }

  /// Takes a straight move on one branch that can be near no limit.
  bool passes_quietly(std::uint32_t point) {
    if (!quiet_ || pending_rewind_rad_ || setting_.arc() != nullptr || !setting_.feed_mm_min() ||
        crosses(point) || axis_path_->branch[point - axis_path_->range.begin] == AxisPath::at_rest)
      return false;
    const double length_mm = (tip_mm(point) - tip_mm(point - 1)).norm();
    const SurveyedMove move{.point = point,
                            .line = tool_path_.cl_line[point],
                            .s_from_mm = s_mm_,
                            .length_mm = length_mm,
                            .time_s = 60.0 * length_mm / *setting_.feed_mm_min()};
    if (!(length_mm > 0.0) || !recorder_.may_pass(move) ||
        !quiet_->is_quiet(tip_mm(point), axis(point - 1), axis(point), length_mm, move.time_s))
      return false;
    s_mm_ += length_mm;
    recorder_.pass(move);
    recorder_.account(move);
    forget_meeting();
    return true;
  }

  std::string operation_name() const { return operation_ == nullptr ? "" : operation_->name; }

  bool crosses(std::uint32_t point) const {
    return crossing_ != axis_path_->crossings.end() && crossing_->point == point;
  }

  void cut(const SurveyedMove& move, const path::Segment& segment) {
    const RotaryPair& arrival = axis_path_->at(move.point);
    MovePart part{.kind = MovePart::Kind::branch, .from = rotary_, .to = arrival};
    if (crosses(move.point)) return cross_pole(move, segment, *crossing_++);
    const std::uint8_t branch = axis_path_->branch[move.point - axis_path_->range.begin];
    if (branch == AxisPath::at_rest)
      part.kind = MovePart::Kind::even;
    else
      part.branch = branch;
    follow(move, segment, part);
  }

  void follow(const SurveyedMove& move, const path::Segment& segment, MovePart part) {
    if (pending_rewind_rad_) part = rewind_inside(move, segment, part);
    survey(move, segment, part);
  }

  /// Both halves of a move through the pole, each on its great circle to the pole itself: the
  /// digits of the CL data, or the freedom there, may lead past it by a little.
  void cross_pole(const SurveyedMove& move, const path::Segment& segment,
                  const AxisPath::Crossing& crossing) {
    const double share = crossing.fraction;
    const Vec3 pole = plan::pole_axis(model_, crossing.pole), tip_mm = segment.tip_mm(share);
    path::Arc arc_in, arc_out;
    const bool is_arc = setting_.arc() != nullptr;
    if (is_arc) arc_in = arc_out = *setting_.arc();
    arc_in.sweep_rad *= share;
    arc_out.sweep_rad *= 1.0 - share;
    const path::Segment way_in{segment.tip_from_mm(), segment.axis_from(), tip_mm, pole,
                               is_arc ? &arc_in : nullptr};
    const path::Segment way_out{tip_mm, pole, segment.tip_to_mm(), segment.axis_to(),
                                is_arc ? &arc_out : nullptr};
    SurveyedMove in = move, out = move;
    in.length_mm = share * move.length_mm;
    in.time_s = share * move.time_s;
    in.fraction_to = out.fraction_from = share;
    out.s_from_mm = move.s_from_mm + in.length_mm;
    out.length_mm = move.length_mm - in.length_mm;
    out.time_s = move.time_s - in.time_s;
    if (in.length_mm > 0.0)
      survey(in, way_in,
             {.kind = MovePart::Kind::branch,
              .branch = crossing.branch_before,
              .from = rotary_,
              .to = crossing.before});
    if (!(crossing.before == crossing.after))
      reposition_inside(Repositioning::Kind::turn_in_place, move, segment, share, crossing.before,
                        crossing.after);
    if (out.length_mm > 0.0)
      follow(out, way_out,
             {.kind = MovePart::Kind::branch,
              .branch = crossing.branch_after,
              .from = crossing.after,
              .to = axis_path_->at(move.point)});
  }

  /// Takes the part up to the place where the first axis is at the end of its range, and the
  /// retract there.
  /// @return what is left of the part.
  MovePart rewind_inside(const SurveyedMove& move, const path::Segment& segment, MovePart part) {
    const double rewind_rad = *std::exchange(pending_rewind_rad_, std::nullopt);
    MovePart rest =
        plan::split_at_limit(model_, segment, *ranges_.rotary_rad[0], part, rewind_rad, slack_rad_);
    survey(move, segment, part);
    rest.from = part.to;
    rest.from.first_rad += rewind_rad;
    reposition_inside(Repositioning::Kind::retract, move, segment, part.fraction_to, part.to,
                      rest.from);
    return rest;
  }

  void reposition_inside(Repositioning::Kind kind, const SurveyedMove& move,
                         const path::Segment& segment, double fraction, const RotaryPair& before,
                         const RotaryPair& after) {
    const Vec3 tip_mm = segment.tip_mm(fraction);
    recorder_.reposition(
        kind, {move.point, move.line, move.s_from_mm + fraction * move.length_mm, tip_mm},
        joints(tip_mm, before), joints(tip_mm, after));
  }

  void survey(const SurveyedMove& move, const path::Segment& segment, const MovePart& part) {
    if (!(part.fraction_to > part.fraction_from)) return;
    const ClStretch::Ends ends{part.fraction_from, part.fraction_to,     part.from.first_rad,
                               part.to.first_rad,  part.from.second_rad, part.to.second_rad};
    // Stretches that follow each other share the joints' motion where they meet.
    const auto& met = met_[last_met_];
    const bool goes_on = met && met_first_rad_ == ends.first_from_rad &&
                         met_second_rad_ == ends.second_from_rad && met_s_mm_ == move.s_from_mm &&
                         ends.fraction_from == 0.0;
    const auto cut_as = [&](ClStretch::Follows follows) {
      return recorder_.cut(ClStretch{model_, segment, follows, part.branch, ends, gauge_length_mm_,
                                     settings_.origin_mm, slack_rad_, met_[1 - last_met_],
                                     goes_on ? &*met : nullptr},
                           move);
    };
    // Where the rotary axes cannot follow the tool axis but within the slack, they run evenly.
    if (!(part.kind != MovePart::Kind::even && cut_as(ClStretch::Follows::branch)) &&
        !cut_as(ClStretch::Follows::even))
      recorder_.interrupt();
    last_met_ = 1 - last_met_;
    if (ends.fraction_to != 1.0) return forget_meeting();
    met_first_rad_ = ends.first_to_rad;
    met_second_rad_ = ends.second_to_rad;
    met_s_mm_ = s_mm_;
  }

  void forget_meeting() { met_[last_met_].reset(); }

  /// At a point the path may go on with other rotary values than it came with.
  void depart(std::uint32_t point) {
    for (; departure_ != axis_path_->departures.end() && departure_->point == point; ++departure_) {
      if (departure_->inside) {
        pending_rewind_rad_ = departure_->turns_rad;
        continue;
      }
      turn(departure_->retract ? Repositioning::Kind::retract : Repositioning::Kind::turn_in_place,
           point, departure_->pair);
      rotary_ = departure_->pair;
    }
  }

  void turn(Repositioning::Kind kind, std::uint32_t point, const RotaryPair& to) {
    reposition(kind, point, tip_mm(point), to);
  }

  void reposition(Repositioning::Kind kind, std::uint32_t point, const Vec3& tip_from_mm,
                  const RotaryPair& to) {
    recorder_.reposition(kind, place(point), joints(tip_from_mm, rotary_),
                         joints(tip_mm(point), to));
  }

  std::optional<PerAxis> joints(const Vec3& tip_mm, const RotaryPair& rotary) const {
    const auto linear =
        kinematics::inverse_linear(model_, tip_mm + settings_.origin_mm, rotary.first_rad,
                                   rotary.second_rad, gauge_length_mm_);
    if (!linear) return std::nullopt;
    return per_axis(kinematics::Joints{*linear, rotary.first_rad, rotary.second_rad});
  }

  const kinematics::Model& model_;
  const plan::JointRanges& ranges_;
  const path::ToolPath& tool_path_;
  const plan::Settings& settings_;
  const bool zones_only_;
  Recorder recorder_;
  std::optional<QuietMoves> quiet_;
  ClSetting setting_;
  const path::Operation* operation_ = nullptr;  ///< as recorded
  int tool_number_ = 0;                         ///< 0: none yet
  const AxisPath* axis_path_ = nullptr;
  double slack_rad_ = 0.0, gauge_length_mm_ = 0.0;
  std::vector<AxisPath::Departure>::const_iterator departure_;
  std::vector<AxisPath::Crossing>::const_iterator crossing_;
  RotaryPair rotary_;
  std::optional<double> pending_rewind_rad_;  ///< of the first axis, inside the next move
  double s_mm_ = 0.0;
  /// The joints' motion where the last stretch ended, and a place for that of the next one.
  std::array<std::optional<kinematics::JointMotion>, 2> met_;
  std::size_t last_met_ = 0;
  double met_first_rad_ = 0.0, met_second_rad_ = 0.0, met_s_mm_ = 0.0;
};

}  // namespace

Result<PathAnalysis> analyse_path(const kinematics::Model& model, const plan::JointRanges& ranges,
                                  const path::ToolPath& tool_path, const plan::Settings& settings,
                                  const AnalysisOptions& options) {
  Walk walk{model, ranges, tool_path, settings, options};
  for (const plan::Sequence& sequence : plan::sequences(tool_path)) {
    const auto gauge = settings.gauge_length_mm.find(sequence.tool_number);
    const bool gauge_known = gauge != settings.gauge_length_mm.end();
    const double gauge_mm = gauge_known ? gauge->second : 0.0;
    auto choice = plan::choose(model, ranges, tool_path, sequence.range, settings, gauge_mm,
                               settings.origin_known && gauge_known);
    if (!choice) return std::move(choice).error();
    if (auto status = walk.run({*std::move(choice), sequence.tool_number, gauge_mm}); !status)
      return std::move(status).error();
  }
  return std::move(walk).finish();
}

Result<PathAnalysis> analyse_choices(const kinematics::Model& model,
                                     const plan::JointRanges& ranges,
                                     const path::ToolPath& tool_path,
                                     const plan::Settings& settings,
                                     std::span<const plan::SequenceChoice> choices,
                                     const AnalysisOptions& options) {
  Walk walk{model, ranges, tool_path, settings, options};
  for (const plan::SequenceChoice& choice : choices)
    if (auto status = walk.run(choice); !status) return std::move(status).error();
  return std::move(walk).finish();
}

}  // namespace pentapost::analysis
