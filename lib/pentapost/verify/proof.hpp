#pragma once

#include "pentapost/core/output.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/nc/reader.hpp"
#include "pentapost/path/motion.hpp"
#include "pentapost/path/tool_path.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::verify {

/// What an NC program is held against.
struct Claim {
  const path::ToolPath&
      tool_path;  ///< turned by the setup, cycles expanded where not native; table orientation
  const kinematics::Model& model;
  const path::Motion&
      motion;  ///< only as witness: which CL move a block belongs to, and where it ends
  nc::ReaderSetup reader_setup;
  Output output = Output::tcp;
  Vec3 origin_mm = Vec3::Zero();  ///< CL origin in the table frame; enters joint values only
  std::map<int, double> gauge_length_mm = {};  ///< by tool number; used only where the head turns
  double tip_tolerance_mm = 0.01;
  double axis_tolerance_rad = 0.0;
  /// Tool axes that were planned instead of the CL's, one a point; empty: the CL's own. On the
  /// moves to and from a point with another axis a feed block may leave the CL axis by the
  /// tolerance and pole_axis_rad. Only near a pole: the CL axis at both ends of such a move must
  /// lie within sqrt(2 pole_axis_rad) of one that the machine has.
  std::span<const Vec3> planned_axis_wp = {};
  double pole_axis_rad = 0.0;
  bool keep_text_lines = false;  ///< of every motion block, for Proof::text_lines
};

struct AxisSpan {
  double min = 0.0, max = 0.0;  ///< as printed: mm or degrees
};

struct Proof {
  double tip_deviation_mm = 0.0;  ///< largest over the whole of every cutting block, not of samples
  double axis_deviation_rad = 0.0;
  std::uint64_t blocks_read = 0;          ///< motion blocks
  std::array<AxisSpan, 5> spans{};        ///< in the order of the letters
  std::vector<std::uint32_t> text_lines;  ///< of the NC text, one a motion block, where asked for
};

/// Reads the finished program back, runs forward kinematics at the digits printed and measures how
/// far tool tip and tool axis leave the CL path, over the whole of every block (lib/README.md
/// section 5).
///
/// @return Problem proof_failed with text line, block, CL line, value and tolerance.
/// @note Shares no code with the planning or the writers.
Result<Proof> prove(std::string_view nc, const nc::Reader& reader, const Claim& claim);

}  // namespace pentapost::verify
