#include "pentapost/cl/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace pentapost::cl {
namespace {

using Kind = path::CycleStart::Kind;
using State = path::Spindle::State;

/// After a full retract the tool goes back at rapid rate to this far above the last depth.
constexpr double reentry_gap_mm = 0.5;
/// Retract that breaks a chip.
constexpr double chip_retract_mm = 0.25;
/// Tool axes that differ by more are those of another side of the work: a straight way from hole to
/// hole may lead through it.
constexpr double largest_link_turn_rad = 1.0 * rad_per_deg;
/// Below any digit that is printed.
constexpr double same_place_mm = 1e-6;

/// Where the tool is.
struct Place {
  Vec3 tip_mm;
  Vec3 axis;
};

/// Copies a path and writes holes out.
class Expansion {
 public:
  Expansion(const path::ToolPath& path, const std::function<bool(std::uint32_t)>& stays_native,
            Diagnostics* diagnostics)
      : path_{path}, stays_native_{stays_native}, diagnostics_{diagnostics} {
    out_.program_name = path.program_name;
    out_.axis_rounding_rad = path.axis_rounding_rad;
    out_.has_tool_change = path.has_tool_change;
    out_.reserve(path.size());
  }

  path::ToolPath run() {
    for (std::uint32_t point = 0; point < path_.size(); ++point) {
      // Before the events: nothing comes between an Arc and its point.
      if (path_.move[point] == path::Move::feed && feed_ && !native_is_on_)
        set_feed(*feed_, path_.cl_line[point]);
      copy_events(point);
      if (path_.move[point] == path::Move::hole && cycle_)
        hole(point);
      else
        move(point);
    }
    copy_events(static_cast<std::uint32_t>(path_.size()));
    end_native(path_.cl_line.empty() ? 0 : path_.cl_line.back());
    return std::move(out_);
  }

 private:
  void copy_events(std::uint32_t point) {
    for (; next_event_ < path_.events.size() && path_.events[next_event_].before_point <= point;
         ++next_event_) {
      const path::Event& event = path_.events[next_event_];
      if (const auto* cycle = std::get_if<path::CycleStart>(&event.what)) {
        end_native(event.cl_line);
        cycle_ = *cycle;
        cycle_line_ = event.cl_line;
        tap_is_reported_ = false;
        continue;
      }
      if (std::holds_alternative<path::CycleEnd>(event.what)) {
        end_native(event.cl_line);
        cycle_.reset();
        continue;
      }
      if (const auto* feed = std::get_if<path::FeedRate>(&event.what))
        feed_ = written_feed_ = *feed;
      if (const auto* spindle = std::get_if<path::Spindle>(&event.what)) note(*spindle);
      if (const auto* change = std::get_if<path::ToolChange>(&event.what)) note(*change);
      if (std::holds_alternative<path::GoHome>(event.what)) place_.reset();
      out_.add_event(event.cl_line, event.what);
    }
  }

  void note(const path::Spindle& spindle) {
    spindle_.state = spindle.state;
    if (spindle.speed_rpm) spindle_.speed_rpm = spindle.speed_rpm;
  }

  /// From another tool's change the hole is reached by a way of its own.
  void note(const path::ToolChange& change) {
    const bool is_in_use =
        change.number == tool_.number &&
        (!change.length_register || change.length_register == tool_.length_register);
    if (is_in_use && place_) return;
    tool_ = change;
    place_.reset();
  }

  void move(std::uint32_t point) {
    end_native(path_.cl_line[point]);
    if (path_.move[point] == path::Move::feed && feed_) set_feed(*feed_, path_.cl_line[point]);
    out_.add_point(path_.tip_wp_mm[point], path_.axis_wp[point], path_.cl_line[point],
                   path_.move[point]);
    place_ = {path_.tip_wp_mm[point], path_.axis_wp[point]};
  }

  void end_native(std::uint32_t line) {
    if (native_is_on_) out_.add_event(line, path::CycleEnd{});
    native_is_on_ = false;
  }

  void set_feed(const path::FeedRate& feed, std::uint32_t line) {
    if (written_feed_ && written_feed_->value == feed.value && written_feed_->unit == feed.unit)
      return;
    written_feed_ = feed;
    out_.add_event(line, feed);
  }

  void hole(std::uint32_t point) {
    line_ = path_.cl_line[point];
    reference_mm_ = path_.tip_wp_mm[point];
    axis_ = path_.axis_wp[point];
    if (stays_native_(point)) {
      if (!cycle_->feed_mm_min && feed_) set_feed(*feed_, line_);
      if (!native_is_on_) out_.add_event(cycle_line_, *cycle_);
      native_is_on_ = true;
      out_.add_point(reference_mm_, axis_, line_, path::Move::hole);
      place_ = {reference_mm_ + cycle_->clearance_mm * axis_, axis_};
      return;
    }
    end_native(line_);
    report_tap();
    const double retract_mm = std::max(cycle_->retract_mm.value_or(0.0), cycle_->clearance_mm);
    if (reach(retract_mm) > cycle_->clearance_mm) rapid_to(cycle_->clearance_mm);
    if (const auto feed = feed_of_hole()) set_feed(*feed, line_);
    drill();
    if (cycle_->dwell_s > 0.0) out_.add_event(line_, path::Dwell{cycle_->dwell_s});
    leave(retract_mm);
  }

  /// Brings the tool over the hole, never across below where it is or where it is to be: up along
  /// its axis and then across, or across and left there.
  /// @return its height over the reference point, at least `retract_mm`.
  double reach(double retract_mm) {
    if (place_ && angle_between_rad(place_->axis, axis_) > largest_link_turn_rad) {
      // The tool turns at the safe end, as for the control's own cycles.
      out_.add_event(line_, path::GoHome{});
      place_.reset();
    }
    double height_mm = retract_mm;
    if (place_) {
      const Vec3 way_mm = place_->tip_mm - reference_mm_;
      const double rise_mm = retract_mm - way_mm.dot(axis_);
      if (rise_mm > same_place_mm) {
        const Vec3 up_mm = rise_mm / place_->axis.dot(axis_) * place_->axis;
        out_.add_point(place_->tip_mm + up_mm, place_->axis, line_, path::Move::rapid);
      }
      if (rise_mm < -same_place_mm) height_mm = way_mm.dot(axis_);
      if (place_->axis == axis_ && axis_.cross(way_mm).norm() <= same_place_mm) return height_mm;
    }
    rapid_to(height_mm);
    return height_mm;
  }

  bool taps() const { return cycle_->kind == Kind::tap || cycle_->kind == Kind::tap_left; }

  void report_tap() {
    if (!taps() || tap_is_reported_ || diagnostics_ == nullptr) return;
    tap_is_reported_ = true;
    diagnostics_->add({Severity::warning, Code::cycle_expanded, cycle_line_,
                       "The tapping cycle at CL line " + std::to_string(cycle_line_) +
                           " is written as single moves, which do not couple feed and spindle: it "
                           "needs a tap holder that gives way."});
  }

  /// Feed of the cycle, of a tap by its pitch; nullopt: the one that is on.
  std::optional<path::FeedRate> feed_of_hole() const {
    if (taps() && cycle_->pitch_mm && spindle_.speed_rpm)
      return path::FeedRate{*cycle_->pitch_mm * *spindle_.speed_rpm};
    if (cycle_->feed_mm_min) return path::FeedRate{*cycle_->feed_mm_min};
    return feed_;
  }

  void drill() {
    const bool pecks = cycle_->kind == Kind::deep || cycle_->kind == Kind::break_chip;
    const double depth_mm = cycle_->depth_mm;
    const double peck_mm = pecks ? cycle_->peck_mm.value_or(depth_mm) : depth_mm;
    // A last peck thinner than this is rounding.
    constexpr double thinnest_peck_mm = 1e-9;
    for (int peck = 1; peck * peck_mm < depth_mm - thinnest_peck_mm; ++peck) {
      const double reached_mm = peck * peck_mm;
      feed_to(-reached_mm);
      if (cycle_->kind == Kind::break_chip) {
        rapid_to(-reached_mm + std::min(chip_retract_mm, 0.5 * peck_mm));
      } else {
        rapid_to(cycle_->clearance_mm);
        rapid_to(-reached_mm + std::min(reentry_gap_mm, 0.5 * peck_mm));
      }
    }
    feed_to(-depth_mm);
  }

  void leave(double retract_mm) {
    const bool feeds_out = cycle_->kind == Kind::bore || cycle_->kind == Kind::ream;
    const bool was_on = spindle_.state != State::off;
    if (taps()) {
      const State inwards = was_on                      ? spindle_.state
                            : cycle_->kind == Kind::tap ? State::clockwise
                                                        : State::counterclockwise;
      const State outwards =
          inwards == State::clockwise ? State::counterclockwise : State::clockwise;
      turn_spindle(outwards);
      feed_to(cycle_->clearance_mm);
      turn_spindle(inwards);
    } else if (feeds_out) {
      feed_to(cycle_->clearance_mm);
    } else {
      // The tool drags out of the hole: it stands, as in G86.
      const bool stands = cycle_->kind == Kind::bore_drag && was_on;
      if (stands) turn_spindle(State::off);
      rapid_to(retract_mm);
      if (stands) turn_spindle(spindle_.state);
      return;
    }
    if (retract_mm > cycle_->clearance_mm) rapid_to(retract_mm);
  }

  void turn_spindle(State state) {
    out_.add_event(line_,
                   path::Spindle{state, state == State::off ? std::nullopt : spindle_.speed_rpm});
  }
  void rapid_to(double height_mm) { add(height_mm, path::Move::rapid); }
  void feed_to(double height_mm) { add(height_mm, path::Move::feed); }
  void add(double height_mm, path::Move how) {
    place_ = {reference_mm_ + height_mm * axis_, axis_};
    out_.add_point(place_->tip_mm, axis_, line_, how);
  }

  const path::ToolPath& path_;
  const std::function<bool(std::uint32_t)>& stays_native_;
  Diagnostics* diagnostics_;
  path::ToolPath out_;
  std::size_t next_event_ = 0;
  std::optional<path::CycleStart> cycle_;
  std::uint32_t cycle_line_ = 0;
  bool native_is_on_ = false;
  bool tap_is_reported_ = false;                ///< of this cycle
  std::optional<path::FeedRate> feed_;          ///< of the path
  std::optional<path::FeedRate> written_feed_;  ///< in the result
  path::Spindle spindle_;
  path::ToolChange tool_{.number = 1};  ///< in use; a path that names none is cut with tool 1
  std::optional<Place> place_;  ///< of the tool; nullopt: it comes from a tool change or from home
  std::uint32_t line_ = 0;      ///< of the hole
  Vec3 reference_mm_ = Vec3::Zero(), axis_ = Vec3::UnitZ();
};

}  // namespace

path::ToolPath expand_cycles(const path::ToolPath& path,
                             const std::function<bool(std::uint32_t point)>& stays_native,
                             Diagnostics* diagnostics) {
  return Expansion{path, stays_native, diagnostics}.run();
}

}  // namespace pentapost::cl
