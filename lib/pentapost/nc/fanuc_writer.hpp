#pragma once

#include "pentapost/nc/axis_words.hpp"
#include "pentapost/nc/common_blocks.hpp"
#include "pentapost/nc/fanuc_family.hpp"
#include "pentapost/nc/program_text.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pentapost::nc {

/// Writes one program; what the control holds modal at each block is kept here.
/// Blocks and words are in fanuc_writer.cpp, actions in fanuc_actions.cpp.
class FanucWriter {
 public:
  /// All must outlive the writer.
  FanucWriter(const path::Motion& motion, const FanucSettings& settings, std::string& out);

  void start(const path::ProgramHeader& header);
  void finish();

  /// False: problem() says why, and nothing more is to be written.
  bool write(const path::Block& block);
  bool act(const path::ToolCall& call, std::uint32_t cl_line);
  bool act(const path::Spindle& spindle, std::uint32_t cl_line);
  bool act(const path::Coolant& coolant, std::uint32_t cl_line);
  bool act(const path::Dwell& dwell, std::uint32_t cl_line);
  bool act(const path::Stop& stop, std::uint32_t cl_line);
  bool act(const path::Comment& said, std::uint32_t cl_line);
  bool act(const path::InsertedText& inserted, std::uint32_t cl_line);
  bool act(const path::ArcCentre& centre, std::uint32_t cl_line);
  bool act(const path::TcpOn& on, std::uint32_t cl_line);
  bool act(const path::TcpOff& off, std::uint32_t cl_line);
  bool act(const path::SafeRetract& retract, std::uint32_t cl_line);
  bool act(const path::NativeCycle& cycle, std::uint32_t cl_line);
  bool act(const path::NativeCycleEnd& end, std::uint32_t cl_line);
  bool act(const path::ProgramEnd& end, std::uint32_t cl_line);

  const std::optional<Problem>& problem() const noexcept { return problem_; }

 private:
  enum class FeedMode : std::uint8_t { unknown, per_minute, inverse_time };
  enum class CycleState : std::uint8_t { off, ordered, written };

  bool write_straight(const path::Block& block, int code, path::Block::Feed mode, double feed);
  bool write_arc(const path::Block& block);
  bool write_hole(const path::Block& block);
  std::uint8_t hole_words(const path::Block& block) const;
  void write_cycle_code(std::string& out) const;
  void write_rigid_tapping();
  bool write_cycle_parameters(std::string& out, std::uint32_t cl_line);
  bool approach(const path::Block& block);
  void write_motion_code(std::string& out, int code);
  void write_mode(std::string& out, path::Block::Feed mode);
  bool write_feed(std::string& out, path::Block::Feed mode, double feed, std::uint32_t cl_line);
  void write_tool_length(std::string& out) { append_whole_word(out, 'H', length_register_); }

  void leave_inverse_time();
  void end_cycle();
  void forget();
  void comment(std::string_view text);
  bool refuse(Problem problem);
  /// Whether there is no Problem; keeps one.
  bool done(std::optional<Problem> problem);

  const path::Motion& motion_;
  const FanucSettings& settings_;
  AxisWords words_;
  FeedWord feed_;
  ProgramText text_;
  CommonBlocks blocks_;
  std::optional<Problem> problem_;

  int motion_code_ = -1;  ///< G0 to G3; -1: to be stated
  FeedMode feed_mode_ = FeedMode::per_minute;
  std::optional<path::ArcCentre> centre_;
  path::NativeCycle cycle_;
  CycleState cycle_state_ = CycleState::off;
  std::int64_t hole_bottom_ = 0;
  std::optional<double> speed_rpm_;  ///< last one that was stated
  int length_register_ = 1;          ///< a path that names no tool is cut with tool 1
  bool approached_ = false;          ///< Z was stated since the last retract
  bool length_on_ = false;
};

}  // namespace pentapost::nc
