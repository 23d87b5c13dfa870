#pragma once

#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/core/diagnostics.hpp"
#include "pentapost/core/output.hpp"
#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/nc/reader.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace pentapost::jobs {

/// A finished NC program, and how it is read.
struct NcSource {
  std::string_view text;
  const nc::Reader& reader;
  nc::ReaderSetup setup;  ///< letters as plan::word_columns() has them
};

/// What the reading of a program found besides its analysis.
struct NcAnalysis {
  analysis::PathAnalysis analysis;
  std::uint64_t lines = 0, blocks = 0;  ///< of the text; motion blocks
  Output output = Output::tcp;          ///< what the linear words are
  std::optional<int> missing_gauge;     ///< the first tool that cuts without a gauge length
  Diagnostics diagnostics;
};

/// Analyses a program block by block as its control would run it.
///
/// The words are the tool tip's where the program uses TCP anywhere, joint values where it turns
/// rotary axes without it, and otherwise what settings.output says. The path starts where all axes
/// are known, anew after a tool change, a safe retract, a move to a machine position and a new
/// datum. Drilling cycles are one way down at feed and one way up.
///
/// @return Problem damaged_block, no_feed, bad_arc, no_motion ... with the text line in its
/// message.
Result<NcAnalysis> analyse_nc(const kinematics::Model& model, const NcSource& source,
                              const plan::Settings& settings,
                              const analysis::AnalysisOptions& options);

}  // namespace pentapost::jobs
