#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/nc/axis_words.hpp"
#include "pentapost/nc/common_blocks.hpp"
#include "pentapost/nc/common_options.hpp"
#include "pentapost/nc/program_text.hpp"
#include "pentapost/path/motion.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::nc {

/// What shops change on this control, beside the options that all controls share.
struct SiemensSettings {
  CommonSettings common;
  std::vector<std::string> program_lines;  ///< at the head; {name}: the program's name
  bool modal_words = true;                 ///< leave out axis words that do not change
  bool messages = false;                   ///< comments of the path on the screen as well
  std::string shortest_way_axes;           ///< letters that are prepositioned as C=DC(..)
  int edge = 1;  ///< D that holds a tool's length; 0: D bears the length register
  double largest_inverse_time = 0.0;  ///< 1/min, > 0
  int inverse_time_decimals = 3;
};

/// Writes one program; what the control holds modal at each block is kept here.
/// Blocks are in siemens_840d_writer.cpp, cycles in siemens_840d_cycles.cpp, actions in
/// siemens_840d_actions.cpp.
class SiemensWriter {
 public:
  /// All must outlive the writer.
  SiemensWriter(const path::Motion& motion, const SiemensSettings& settings, std::string& out);

  void start(const path::ProgramHeader& header);

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
  /// What the program last said of the tool's length.
  enum class Edge : std::uint8_t { unknown, off, on };

  // siemens_840d_writer.cpp
  bool write_straight(const path::Block& block, int code, path::Block::Feed mode, double feed);
  bool write_arc(const path::Block& block);
  bool goes_the_shortest_way(const path::Block& block, std::size_t column) const;
  void write_prepositioning(std::string& out, const path::Block& block, std::uint8_t words) const;
  void write_motion_code(std::string& out, int code);
  void write_mode(std::string& out, path::Block::Feed mode);
  bool write_feed(std::string& out, path::Block::Feed mode, double feed, std::uint32_t cl_line);
  void approach(std::string& out, const path::Block& block);
  void start_smoothing(const path::Block& block);

  // siemens_840d_cycles.cpp
  bool write_hole(const path::Block& block);
  bool write_cycle(std::uint32_t cl_line);
  bool cycle_call(std::string& call, std::uint32_t cl_line);
  bool tapping_call(std::string& call, std::uint32_t cl_line);
  std::string levels() const;
  std::string length(std::int64_t count) const;
  int spindle_code() const;
  void end_cycle();

  // siemens_840d_actions.cpp
  std::string edge_word(Edge edge) const;
  void leave_inverse_time();
  void forget();
  void comment(std::string_view text);
  void message(std::string_view text);
  bool refuse(Problem problem);
  /// Whether there is no Problem; keeps one.
  bool done(std::optional<Problem> problem);

  const path::Motion& motion_;
  const SiemensSettings& settings_;
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
  path::Spindle spindle_;    ///< as it turns, with the last speed that was stated
  int length_register_ = 1;  ///< a path that names no tool is cut with tool 1
  Edge edge_ = Edge::unknown;
};

}  // namespace pentapost::nc
