#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/analyse.hpp"
#include "pentapost/jobs/compare.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "pentapost/machine/library.hpp"
#include "server/http/message.hpp"
#include "server/json/machine_names.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pentapost::server {

/// What a job's names refer to.
struct JobContext {
  const machine::Library& machines;
  std::span<const std::string_view> dialects;  ///< names of the controller dialects
};

/// A job as it arrives, whatever its form. What two parts both say is a Problem conflicting_keys.
struct JobParts {
  std::optional<std::string> json = {};  ///< the JSON job
  std::optional<std::string> cl = {};    ///< text of the CL file, where it came apart from the job
  std::string cl_file_name = {};         ///< of that file; empty: not known
  std::optional<std::string> nc = {};    ///< text of the NC program to analyse, likewise apart
  /// machine, output, dialect, tip_mm, axis_deg, cl_units, program_name, zone_share, nc_dialect,
  /// objective, max_tilt_deg, setup_accuracy_deg, machines, reorient, as text.
  Fields words = {};
};

/// Reads a job for POST /post. Degrees become radians, machine names become definitions.
///
/// @return Problem with the JSON pointer (for a word: of the key in the JSON job that it stands
///         for): bad_json, unknown_key, missing_key, wrong_type, out_of_domain, conflicting_keys,
///         unknown_machine, unknown_version, unknown_dialect, zero_tool_axis, no_motion, or what
///         an inline definition is refused with.
Result<jobs::PostJob> read_post_job(JobParts parts, const JobContext& context);

/// Reads a job for POST /analyse: as for POST /post, the keys zone_share, samples,
/// max_samples, and nc with nc_dialect in the place of cl and path.
Result<jobs::AnalyseJob> read_analyse_job(JobParts parts, const JobContext& context);

/// Reads a job for POST /reorient: as for POST /post, and the keys of reorient_options_json.hpp.
Result<jobs::ReorientJob> read_reorient_job(JobParts parts, const JobContext& context);

/// Reads a job for POST /compare: as for POST /post without machine, and the keys machines, of
/// which all of the library are the default, zone_share and reorient.
Result<jobs::CompareJob> read_compare_job(JobParts parts, const JobContext& context);

/// The JSON pointer of a key of the job.
std::string pointer_to_key(std::string_view key);

/// "part" of "C:\\cam\\part.cls", for a program without a name of its own.
std::string file_stem(std::string_view file_name);

}  // namespace pentapost::server
