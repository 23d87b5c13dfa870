#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/motion.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/block_maker.hpp"
#include "pentapost/plan/sequences.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace pentapost::plan {

/// Everything of the NC program that is not cutting, in the safe order: tools, spindle, coolant,
/// TCP, positioning. Follows the events of the tool path and knows what is active.
class Frame {
 public:
  Frame(const kinematics::Model& model, const path::ToolPath& tool_path, const Settings& settings,
        path::Motion& motion);

  void start();
  /// Tool change and all other events before the first point of a sequence.
  void begin_sequence(const Sequence& sequence);
  /// From the safe height to the first point: rotary axes with the tool retracted, then TCP on,
  /// then the tool down along its axis to the point.
  /// @param above  a posture from which it comes down; nullopt: there is no room for one.
  /// @return the block that ends at the posture.
  path::Block& approach(const Posture& posture, const std::optional<Posture>& above,
                        std::uint32_t point, bool by_feed);
  /// Whether the tool cuts though the CL data never started the spindle for it; true once a tool.
  bool spindle_is_missing();
  /// Events before the move to `point`.
  void take_events(std::uint32_t point);
  /// Ends TCP and sends the tool to its safe end; what follows has to approach.
  void leave();
  void finish();

  void comment(std::string text, std::uint32_t cl_line);
  void tcp_on();
  void tcp_off();
  void safe_retract();
  /// The control's cycle for the holes that follow; not repeated while nothing of it changes.
  void start_cycle(const path::NativeCycle& cycle, std::uint32_t cl_line);
  void end_cycle(std::uint32_t cl_line);
  void act(path::ActionKind what, std::uint32_t cl_line = 0);
  path::Block& add_block(const Posture& posture, std::uint32_t point, path::Block::Kind kind);
  /// Rotary words alone, at rapid rate, off the path.
  void position_rotary(const Posture& posture, std::uint32_t point);

  std::optional<double> feed_mm_min() const { return feed_mm_min_; }  ///< active; nullopt: none yet
  /// As the CL data have it; nullopt: none yet.
  std::optional<double> speed_rpm() const { return spindle_.speed_rpm; }
  const path::Arc* arc() const {
    return arc_ ? &*arc_ : nullptr;
  }  ///< of the move to the point in hand
  const std::optional<path::CycleStart>& cycle() const { return cycle_; }

 private:
  void take(const path::Event& event);
  void take_spindle(const path::Spindle& spindle, std::uint32_t cl_line);
  void take_feed(const path::FeedRate& feed);
  void change_tool(const path::ToolChange& change, std::uint32_t cl_line);
  std::optional<double> speed_ahead() const;
  std::optional<std::size_t> column_along_tool() const;

  const kinematics::Model& model_;
  const path::ToolPath& tool_path_;
  const Settings& settings_;
  path::Motion& motion_;
  const WordColumns columns_;
  std::size_t next_event_ = 0;
  bool tcp_ = false;
  bool at_safe_end_ = false;
  std::optional<path::ToolChange> tool_;
  path::Spindle spindle_;  ///< as the CL data have it
  bool spindle_written_ = false;
  bool warned_of_spindle_ = false;
  path::Coolant coolant_;
  std::optional<double> feed_mm_min_;
  std::optional<path::FeedRate> feed_;
  std::optional<path::Arc> arc_;
  std::optional<path::CycleStart> cycle_;
  std::optional<path::NativeCycle> native_cycle_;
};

}  // namespace pentapost::plan
