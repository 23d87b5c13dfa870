#include "pentapost/jobs/nc_path.hpp"

#include "pentapost/analysis/joint_analysis.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/verify/printed_arc.hpp"
#include "pentapost/verify/tool_position.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>

namespace pentapost::jobs {
namespace {

using analysis::JointMove;
using analysis::JointPosture;
using nc::ReadMotion;
using verify::Meaning;
using verify::Stop;

/// What the linear words of a program are. The reading stops where it is known.
class OutputSearch {
 public:
  Status take(const nc::ReadItem& item) {
    const auto* const motion = std::get_if<ReadMotion>(&item.what);
    if (motion == nullptr || motion->machine_frame) return ok();
    uses_tcp_ = motion->tcp;
    for (std::size_t column = 3; column < motion->position.size(); ++column)
      if ((motion->stated >> column & 1U) != 0 && motion->position[column] != 0.0) turns_ = true;
    if (!uses_tcp_) return ok();
    return Problem{.code = Code::no_motion, .message = {}};
  }
  Output found(Output otherwise) const {
    return uses_tcp_ ? Output::tcp : turns_ ? Output::axes : otherwise;
  }

 private:
  bool uses_tcp_ = false, turns_ = false;
};

Output output_of(const NcSource& source, Output otherwise) {
  OutputSearch search;
  // What is wrong with the program, the reading for the analysis tells.
  static_cast<void>(source.reader.read(
      source.text, source.setup, [&](const nc::ReadItem& item) { return search.take(item); }));
  return search.found(otherwise);
}

/// Takes a program's items in order.
class NcWalk {
 public:
  NcWalk(const kinematics::Model& model, const verify::AxisColumns& columns, Output output,
         const plan::Settings& settings, const analysis::AnalysisOptions& options)
      : model_{model},
        columns_{columns},
        settings_{settings},
        length_direction_{kinematics::length_direction(model)},
        shape_{model},
        position_{shape_, columns_, output, settings.origin_mm},
        analysis_{model, settings, options} {}

  Status take(const nc::ReadItem& item) {
    line_ = item.text_line;
    if (const auto* motion = std::get_if<ReadMotion>(&item.what)) return take_motion(*motion);
    if (const auto* tool = std::get_if<nc::ReadTool>(&item.what)) {
      tool_ = tool->number;
      analysis_.use_tool(tool_);
      position_.lose(verify::AxisColumns::linear);
    }
    if (std::holds_alternative<nc::ReadSafeRetract>(item.what)) {
      analysis_.interrupt();
      position_.lose(verify::AxisColumns::linear);
    }
    return ok();
  }

  NcAnalysis finish() && {
    return {.analysis = std::move(analysis_).finish(),
            .blocks = block_,
            .missing_gauge = missing_gauge_,
            .diagnostics = std::move(diagnostics_)};
  }

 private:
  Status take_motion(const ReadMotion& motion) {
    Status status = ok();
    if (motion.machine_frame)
      leave(motion);
    else
      status = follow(motion);
    ++block_;
    return status;
  }

  /// To a machine position, of which the program's coordinates tell nothing.
  void leave(const ReadMotion& motion) {
    if (motion.kind != ReadMotion::Kind::rapid) warn_of_unknown_place();
    position_.lose(motion.stated);
    analysis_.interrupt();
  }

  Status follow(const ReadMotion& motion) {
    if (motion.work_offset != work_offset_ || motion.datum_shift != datum_shift_)
      analysis_.interrupt();
    work_offset_ = motion.work_offset;
    datum_shift_ = motion.datum_shift;
    position_.go(motion, gauge_in_words_mm());
    const Stop& before = position_.before();
    const Stop& now = position_.now();
    if (!now.placed) {
      if (now.known == columns_.all() && motion.kind != ReadMotion::Kind::rapid)
        warn_of_unknown_place();
      analysis_.interrupt();
      return ok();
    }
    if (before.meaning != now.meaning) analysis_.interrupt();
    if (motion.kind == ReadMotion::Kind::drill) return drill(motion);
    if (analysis_.is_placed()) return move(motion, before, now);
    analysis_.begin(posture(now));
    return ok();
  }

  JointPosture posture(const Stop& stop) const {
    JointPosture posture{.joints = stop.joints,
                         .tip_mm = stop.station.tip_mm,
                         .words_are_tip = stop.meaning == Meaning::tip};
    // Where the head does not turn the control adds the length to the words.
    if (!posture.words_are_tip && !model_.head_turns)
      posture.joints.linear_mm += gauge_length_mm() * length_direction_;
    return posture;
  }

  /// Of the length that joint values as printed contain.
  double gauge_in_words_mm() const { return model_.head_turns ? gauge_length_mm() : 0.0; }

  double gauge_length_mm() const {
    const auto found = settings_.gauge_length_mm.find(tool_);
    return found == settings_.gauge_length_mm.end() ? 0.0 : found->second;
  }

  static bool turns(const Stop& from, const Stop& to) {
    return from.joints.first_rad != to.joints.first_rad ||
           from.joints.second_rad != to.joints.second_rad;
  }

  Status move(const ReadMotion& motion, const Stop& from, const Stop& to) {
    JointMove move{.to = posture(to), .block = block_, .line = line_};
    if (motion.kind == ReadMotion::Kind::rapid) {
      move.kind = JointMove::Kind::rapid;
      return analysis_.move(move);
    }
    set_feed(move, motion, turns(from, to));
    if (motion.kind != ReadMotion::Kind::arc) return analysis_.move(move);
    std::string wrong;
    const auto arc = arc_of(motion, from, to, wrong);
    if (!arc)
      return Problem{.code = Code::bad_arc,
                     .message = "NC text line " + std::to_string(line_) + ": " + wrong};
    move.arc = &*arc;
    return analysis_.move(move);
  }

  void set_feed(JointMove& move, const ReadMotion& motion, bool turns) {
    move.feed = motion.feed_mode == ReadMotion::Feed::none ? 0.0 : motion.feed;
    if (move.feed > 0.0) note_gauge();
    if (motion.feed_mode == ReadMotion::Feed::inverse_time) {
      move.feed_rule = JointMove::Feed::inverse_time;
    } else if (turns && !move.to.words_are_tip) {
      move.feed_rule = JointMove::Feed::axes;
      warn_of_feed_rule();
    }
  }

  std::optional<path::Segment> arc_of(const ReadMotion& motion, const Stop& from, const Stop& to,
                                      std::string& wrong) const {
    if (columns_.find('X') != 0U || columns_.find('Y') != 1U || columns_.find('Z') != 2U) {
      wrong = "an arc on a machine without X, Y and Z";
      return std::nullopt;
    }
    const Mat3 to_cl = to.meaning == Meaning::tip
                           ? Mat3::Identity()
                           : kinematics::linear_map(model_, to.joints.first_rad,
                                                    to.joints.second_rad, gauge_in_words_mm())
                                 .matrix;
    return verify::printed_arc(motion, from, to, to_cl, wrong);
  }

  /// Down at feed in one way: pecks change no axis's speed.
  Status drill(const ReadMotion& motion) {
    const auto z = columns_.find('Z');
    if (!z) {
      warn_of_unknown_place();
      analysis_.interrupt();
      return ok();
    }
    const double gauge_mm = gauge_in_words_mm();
    const Stop bottom = position_.now();
    const Stop clearance = position_.place_with(*z, motion.clearance_z_mm, gauge_mm);
    const Stop retract = position_.place_with(*z, motion.retract_z_mm, gauge_mm);
    if (motion.travel_z_mm) rapid_to(position_.place_with(*z, *motion.travel_z_mm, gauge_mm));
    rapid_to(clearance);
    JointMove down{.to = posture(bottom), .block = block_, .line = line_};
    set_feed(down, motion, false);
    if (auto status = analysis_.move(down); !status) return status;
    if (leaves_at_feed(motion.hole)) {
      JointMove up = down;
      up.to = posture(clearance);
      if (auto status = analysis_.move(up); !status) return status;
    }
    rapid_to(retract);
    position_.set(retract);
    return ok();
  }

  static bool leaves_at_feed(ReadMotion::Hole hole) {
    return hole == ReadMotion::Hole::feed_out || hole == ReadMotion::Hole::tap ||
           hole == ReadMotion::Hole::tap_left;
  }

  void rapid_to(const Stop& stop) {
    if (!analysis_.is_placed()) return analysis_.begin(posture(stop));
    // A rapid needs no feed, hence has no Problem.
    static_cast<void>(analysis_.move(
        {.kind = JointMove::Kind::rapid, .to = posture(stop), .block = block_, .line = line_}));
  }

  void note_gauge() {
    if (!missing_gauge_ && !settings_.gauge_length_mm.contains(tool_)) missing_gauge_ = tool_;
  }

  void warn_of_feed_rule() {
    if (std::exchange(feed_rule_warned_, true)) return;
    diagnostics_.add({Severity::warning, Code::feed_rule_assumed, 0,
                      "NC text line " + std::to_string(line_) +
                          ": a feed per minute without TCP while a rotary axis turns; it counts "
                          "millimetres and degrees alike along the way of all axes, as not every "
                          "control does"});
  }

  void warn_of_unknown_place() {
    if (!diagnostics_.keeps(Severity::warning)) return diagnostics_.count(Severity::warning);
    diagnostics_.add({Severity::warning, Code::position_unknown, 0,
                      "NC text line " + std::to_string(line_) +
                          ": a feed move to a place that the program does not tell (a machine "
                          "position, or neither TCP nor a tool length is on); it is left out"});
  }

  const kinematics::Model& model_;
  const verify::AxisColumns& columns_;
  const plan::Settings& settings_;
  Vec3 length_direction_;
  verify::ChainShape shape_;
  verify::ToolPosition position_;
  analysis::JointAnalysis analysis_;
  Diagnostics diagnostics_;
  std::uint32_t line_ = 0, block_ = 0;
  int tool_ = 1;  ///< a program that calls none cuts with tool 1
  int work_offset_ = 0;
  std::array<double, 5> datum_shift_{};
  std::optional<int> missing_gauge_;
  bool feed_rule_warned_ = false;
};

/// The caller's program is at fault, where a reader speaks of its dialect.
Problem of_request(Problem problem) {
  if (problem.code == Code::not_in_dialect) problem.code = Code::damaged_block;
  problem.pointer = "/nc";
  return problem;
}

std::uint64_t lines_of(std::string_view text) {
  const auto ends = std::count(text.begin(), text.end(), '\n');
  return static_cast<std::uint64_t>(ends) + (text.empty() || text.back() == '\n' ? 0U : 1U);
}

}  // namespace

Result<NcAnalysis> analyse_nc(const kinematics::Model& model, const NcSource& source,
                              const plan::Settings& settings,
                              const analysis::AnalysisOptions& options) {
  const auto columns = verify::AxisColumns::make(source.setup.letters, model);
  if (!columns)
    return Problem{.code = Code::unsupported_output,
                   .message = "the axes of this machine have no single letters each",
                   .pointer = "/machine"};
  const Output output = output_of(source, settings.output);
  NcWalk walk{model, *columns, output, settings, options};
  auto status = source.reader.read(source.text, source.setup,
                                   [&](const nc::ReadItem& item) { return walk.take(item); });
  if (!status) return of_request(std::move(status).error());
  NcAnalysis result = std::move(walk).finish();
  result.output = output;
  result.lines = lines_of(source.text);
  if (result.analysis.operations.empty())
    return of_request({.code = Code::no_motion,
                       .message = "no block of the NC program cuts between places that are known",
                       .diagnostics = std::move(result.diagnostics)});
  return result;
}

}  // namespace pentapost::jobs
