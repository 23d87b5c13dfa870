#include "pentapost/plan/frame.hpp"

#include <utility>

namespace pentapost::plan {

using path::Block;

Frame::Frame(const kinematics::Model& model, const path::ToolPath& tool_path,
             const Settings& settings, path::Motion& motion)
    : model_{model},
      tool_path_{tool_path},
      settings_{settings},
      motion_{motion},
      columns_{word_columns(model)} {}

void Frame::act(path::ActionKind what, std::uint32_t cl_line) {
  motion_.actions.push_back(
      {static_cast<std::uint32_t>(motion_.blocks.size()), cl_line, std::move(what)});
}

void Frame::comment(std::string text, std::uint32_t cl_line) {
  act(path::Comment{std::move(text)}, cl_line);
}

void Frame::start_cycle(const path::NativeCycle& cycle, std::uint32_t cl_line) {
  if (native_cycle_ == cycle) return;
  act(cycle, cl_line);
  native_cycle_ = cycle;
}

void Frame::start() {
  if (!settings_.retract_needs_tool) safe_retract();
}

void Frame::tcp_on() {
  if (tcp_ || settings_.output != Output::tcp || model_.rotary_count == 0) return;
  act(path::TcpOn{});
  tcp_ = true;
}

void Frame::tcp_off() {
  if (!tcp_) return;
  act(path::TcpOff{});
  tcp_ = false;
}

void Frame::safe_retract() {
  if (at_safe_end_) return;
  act(path::SafeRetract{});
  at_safe_end_ = true;
}

void Frame::leave() {
  end_cycle(0);
  if (settings_.retracts_with_tcp) safe_retract();
  tcp_off();
  safe_retract();
}

/// The speed that the CL data set before the tool cuts: some controls want it with the tool.
std::optional<double> Frame::speed_ahead() const {
  std::optional<double> speed_rpm = spindle_.speed_rpm;
  if (next_event_ == tool_path_.events.size()) return speed_rpm;
  const std::uint32_t point = tool_path_.events[next_event_].before_point;
  for (std::size_t i = next_event_; i < tool_path_.events.size(); ++i) {
    if (tool_path_.events[i].before_point != point) break;
    if (const auto* spindle = std::get_if<path::Spindle>(&tool_path_.events[i].what))
      if (spindle->speed_rpm) speed_rpm = spindle->speed_rpm;
  }
  return speed_rpm;
}

void Frame::begin_sequence(const Sequence& sequence) {
  if (tool_) leave();
  take_events(sequence.range.begin);
  if (!tool_) change_tool({.number = sequence.tool_number}, 0);
  if (!spindle_written_ && spindle_.state != path::Spindle::State::off) {
    act(spindle_);
    spindle_written_ = true;
  }
}

void Frame::change_tool(const path::ToolChange& change, std::uint32_t cl_line) {
  if (tool_ && keeps_tool(*tool_, change)) return;
  if (tool_ || !settings_.retract_needs_tool) leave();
  if (coolant_.state != path::Coolant::State::off) act(path::Coolant{}, cl_line);
  if (spindle_written_ && spindle_.state != path::Spindle::State::off)
    act(path::Spindle{}, cl_line);
  act(path::ToolCall{.number = change.number,
                     .length_register = change.length_register,
                     .speed_rpm = speed_ahead(),
                     .name = change.name},
      cl_line);
  safe_retract();
  if (coolant_.state != path::Coolant::State::off) act(coolant_, cl_line);
  spindle_written_ = false;
  tool_ = change;
  warned_of_spindle_ = false;
}

void Frame::take_events(std::uint32_t point) {
  arc_.reset();
  for (; next_event_ < tool_path_.events.size() &&
         tool_path_.events[next_event_].before_point <= point;
       ++next_event_) {
    const path::Event& event = tool_path_.events[next_event_];
    // Without a tool change before it, the tool comes first.
    if (!tool_ && !std::holds_alternative<path::ToolChange>(event.what) &&
        !std::holds_alternative<path::Comment>(event.what) &&
        !std::holds_alternative<path::Operation>(event.what)) {
      bool named = false;
      for (std::size_t i = next_event_; i < tool_path_.events.size() && !named; ++i) {
        if (tool_path_.events[i].before_point > point) break;
        named = std::holds_alternative<path::ToolChange>(tool_path_.events[i].what);
      }
      if (!named) change_tool({.number = 1}, 0);
    }
    take(event);
  }
}

void Frame::take(const path::Event& event) {
  const std::uint32_t line = event.cl_line;
  struct Visitor {
    Frame& frame;
    std::uint32_t line;
    void operator()(const path::FeedRate& feed) const { frame.take_feed(feed); }
    void operator()(const path::Spindle& spindle) const { frame.take_spindle(spindle, line); }
    void operator()(const path::Coolant& coolant) const {
      if (coolant.state == frame.coolant_.state) return;
      frame.coolant_ = coolant;
      frame.act(coolant, line);
    }
    void operator()(const path::ToolChange& change) const { frame.change_tool(change, line); }
    void operator()(const path::ToolData&) const {}
    void operator()(const path::Arc& arc) const { frame.arc_ = arc; }
    void operator()(const path::CycleStart& cycle) const { frame.cycle_ = cycle; }
    void operator()(const path::CycleEnd&) const {
      frame.end_cycle(line);
      frame.cycle_.reset();
    }
    // Words of a dwell or of a text could be those of another hole.
    void operator()(const path::Dwell& dwell) const {
      frame.end_cycle(line);
      frame.act(dwell, line);
    }
    void operator()(const path::Stop& stop) const { frame.act(stop, line); }
    void operator()(const path::Comment& comment) const { frame.act(comment, line); }
    void operator()(const path::InsertedText& text) const {
      frame.end_cycle(line);
      frame.act(text, line);
    }
    void operator()(const path::Operation& operation) const { frame.comment(operation.name, line); }
    void operator()(const path::GoHome&) const { frame.leave(); }
    void operator()(const path::StartPoint&) const {}
  };
  std::visit(Visitor{*this, line}, event.what);
}

void Frame::take_feed(const path::FeedRate& feed) {
  feed_ = feed;
  if (feed.unit == path::FeedRate::Unit::mm_min)
    feed_mm_min_ = feed.value;
  else if (spindle_.speed_rpm)
    feed_mm_min_ = feed.value * *spindle_.speed_rpm;
  else
    feed_mm_min_.reset();
}

void Frame::take_spindle(const path::Spindle& spindle, std::uint32_t cl_line) {
  path::Spindle now = spindle;
  if (!now.speed_rpm) now.speed_rpm = spindle_.speed_rpm;
  const bool changed = now.state != spindle_.state || now.speed_rpm != spindle_.speed_rpm;
  if (changed || !spindle_written_) act(now, cl_line);
  spindle_ = now;
  spindle_written_ = true;
  if (feed_ && feed_->unit == path::FeedRate::Unit::mm_per_revolution) take_feed(*feed_);
}

void Frame::end_cycle(std::uint32_t cl_line) {
  if (native_cycle_) act(path::NativeCycleEnd{}, cl_line);
  native_cycle_.reset();
}

Block& Frame::add_block(const Posture& posture, std::uint32_t point, Block::Kind kind) {
  if (kind != Block::Kind::drill) end_cycle(tool_path_.cl_line[point]);
  Block block;
  block.word = posture.word;
  block.point = point;
  block.cl_line = tool_path_.cl_line[point];
  block.kind = kind;
  block.stated = static_cast<std::uint8_t>((1U << static_cast<unsigned>(columns_.count)) - 1U);
  motion_.blocks.push_back(block);
  at_safe_end_ = false;
  return motion_.blocks.back();
}

void Frame::position_rotary(const Posture& posture, std::uint32_t point) {
  if (model_.rotary_count == 0) return;
  const bool safe = at_safe_end_;
  Block& block = add_block(posture, point, Block::Kind::rapid);
  block.stated = model_.rotary_count == 1 ? 0x08 : 0x18;
  block.on_path = false;
  at_safe_end_ = safe;
}

/// Column of the linear words that moves the tool along its axis in every posture.
std::optional<std::size_t> Frame::column_along_tool() const {
  const bool words_are_joints = settings_.output == Output::axes || model_.rotary_count == 0;
  if (!words_are_joints || model_.head_turns) return std::nullopt;
  const Mat3 directions =
      model_.linear_columns[0] + model_.linear_columns[1] + model_.linear_columns[2];
  for (std::size_t i = 0; i < 3; ++i)
    if (directions.col(static_cast<Eigen::Index>(i)).cross(model_.t).norm() <= 1e-9) return i;
  return std::nullopt;
}

Block& Frame::approach(const Posture& posture, const std::optional<Posture>& above,
                       std::uint32_t point, bool by_feed) {
  position_rotary(posture, point);
  tcp_on();
  // The tool comes down along its axis: on a linear axis of the machine alone where there is one.
  const std::optional<std::size_t> along = column_along_tool();
  if (along || above) {
    Block& before = add_block(along ? posture : *above, point, Block::Kind::rapid);
    if (along) before.stated = static_cast<std::uint8_t>(0x07U & ~(1U << *along));
    before.on_path = false;
  }
  Block& block = add_block(posture, point, by_feed ? Block::Kind::line : Block::Kind::rapid);
  if (by_feed) {
    block.feed_mode = Block::Feed::per_minute;
    block.feed = *feed_mm_min_;
  }
  return block;
}

bool Frame::spindle_is_missing() {
  if (warned_of_spindle_ || spindle_.state != path::Spindle::State::off) return false;
  warned_of_spindle_ = true;
  return true;
}

void Frame::finish() {
  leave();
  take_events(static_cast<std::uint32_t>(tool_path_.size()));
  if (coolant_.state != path::Coolant::State::off) act(path::Coolant{});
  if (spindle_written_ && spindle_.state != path::Spindle::State::off) act(path::Spindle{});
  act(path::ProgramEnd{});
}

}  // namespace pentapost::plan
