#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/report_head.hpp"
#include "pentapost/jobs/tool_path.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/nc/dialect.hpp"
#include "pentapost/nc/reader.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace pentapost::jobs {

/// The control of a job: its language, and what it can do.
struct Control {
  const nc::Dialect* dialect;
  const nc::Reader* reader;
  machine::Options options;
  nc::Abilities abilities;
  Output output;
};

/// A job made ready for the planning.
struct PreparedJob {
  Control control;
  ReadPath read;  ///< its tool path in the table's orientation
  kinematics::Model model;
  plan::JointRanges ranges;
  plan::Settings settings;
};

/// Checks the numbers of a job, finds its control, reads its path and turns it by the setup.
///
/// @return Problem as check_domain() and read_path(), unknown_dialect, or what the definition's
///         controller options are refused with.
Result<PreparedJob> prepare(const PostJob& job);
/// The same with a path that was read already.
Result<PreparedJob> prepare_read(const PostJob& job, ReadPath read);
/// The same without the path.
Result<PreparedJob> prepare_unread(const PostJob& job);

/// The rotation that turns CL coordinates into the table's orientation.
Mat3 turn_of(const Setup& setup);

/// Writes the holes of the path as single moves, but those that remain holes.
void expand_holes(PreparedJob& prepared,
                  const std::function<bool(std::uint32_t point)>& stays_native);

/// The first tool of the path without a gauge length.
std::optional<int> missing_gauge_length(const PostJob& job, const path::ToolPath& tool_path);

/// @return Problem gauge_length_missing where the words of the program depend on the one that is
///         missing.
Status check_gauge_length(const PostJob& job, const PreparedJob& prepared,
                          std::optional<int> missing_gauge);

/// Warns where the machine's linear ranges could not be checked.
void warn_of_unchecked_ranges(const PostJob& job, const plan::JointRanges& ranges,
                              std::optional<int> missing_gauge, Diagnostics& diagnostics);

ReportHead report_head(const PostJob& job, const ReadPath& read);

}  // namespace pentapost::jobs
