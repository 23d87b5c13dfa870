#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/machine/definition.hpp"
#include "pentapost/nc/dialect.hpp"
#include "pentapost/path/tool_path.hpp"

#include <functional>

namespace pentapost::jobs {

/// Writes and proves the program of a job with these options; true: the proof passed.
using OptionsTrial = std::function<bool(const machine::Options& options)>;

/// Whose fault it is that a program cannot be proven. Text that the controller's options or the CL
/// data put into the program is the caller's: not_in_dialect with its place. The options are at
/// fault where the program passes with the dialect's own text instead.
///
/// @return `problem` itself where neither is to blame.
Problem unproven(Problem problem, const nc::Dialect& dialect, const machine::Options& options,
                 const path::ToolPath& tool_path, const OptionsTrial& passes);

}  // namespace pentapost::jobs
