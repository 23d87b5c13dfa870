#pragma once

#include "pentapost/jobs/post.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstddef>
#include <string>

namespace pentapost::bench {

/// The A/C table of Cripps et al. 2017 with Heidenhain ISO programs.
machine::Definition bench_machine();

/// The CL text as a job for that machine.
jobs::PostJob bench_job(std::string cl);

/// The tool path of a CL text that must be readable.
path::ToolPath bench_path(const std::string& cl);

/// Both rotary solutions of every point and the linear values of the first.
/// @return the count of solutions.
std::size_t invert_all(const kinematics::Model& model, const path::ToolPath& path);

}  // namespace pentapost::bench
