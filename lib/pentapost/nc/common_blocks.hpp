#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/nc/common_options.hpp"
#include "pentapost/nc/program_text.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstdint>
#include <optional>

namespace pentapost::nc {

/// Writes the blocks that the shared options spell, or that are the same on all controls.
/// A Problem has the CL line; nothing was written then that is to be kept.
class CommonBlocks {
 public:
  /// Both must outlive it.
  CommonBlocks(const CommonSettings& settings, ProgramText& text)
      : settings_{settings}, text_{text} {}

  /// The blocks of the option tool_change.
  /// @return the speed that they state, rpm; nullopt: none.
  std::optional<double> change_tool(const path::ToolCall& call);

  /// M3 or M4 with S where there is a speed, M5 without.
  /// @return out_of_domain: a speed that no control takes.
  std::optional<Problem> spindle(const path::Spindle& spindle, std::uint32_t cl_line);

  /// @return not_in_dialect: the options have no code for it.
  std::optional<Problem> coolant(const path::Coolant& coolant, std::uint32_t cl_line);

  /// The blocks of the options smoothing_on and smoothing_off, where that changes something.
  void smoothing_on();
  void smoothing_off();

 private:
  const CommonSettings& settings_;
  ProgramText& text_;
  bool smoothing_is_on_ = false;
};

}  // namespace pentapost::nc
