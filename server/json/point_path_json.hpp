#pragma once

#include "pentapost/jobs/post.hpp"
#include "pentapost/json/strict_reader.hpp"

namespace pentapost::server {

/// Reads the "path" of a job. The document keeps what is wrong: no_motion, zero_tool_axis,
/// missing_key, wrong_type, out_of_domain.
jobs::PointPath read_point_path(const json::Object& path);

}  // namespace pentapost::server
