#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/path/tool_path.hpp"

namespace pentapost::jobs {

/// The path of a job as the stages after the reading see it, and what the report says of its
/// source.
struct ReadPath {
  path::ToolPath tool_path;
  std::string cl_dialect;
  std::string cl_units = "mm";
  std::uint64_t lines = 0, points = 0;
  Diagnostics diagnostics;
};

/// @return Problem with all diagnostics where the CL data are damaged or hold no motion.
Result<ReadPath> read_path(const PostJob& job);

}  // namespace pentapost::jobs
