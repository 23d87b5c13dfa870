#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/machine/library.hpp"

#include <string_view>

namespace pentapost::server {

/// A Problem of `job` with its pointer into the request: a machine that was given by its
/// name has no values there.
Problem placed_in_request(Problem problem, const jobs::PostJob& job,
                          const machine::Library& machines);

/// Why the library has no such entry: unknown_machine, with near names, or unknown_version, with
/// the versions that there are.
Problem missing_machine(const machine::Library& machines, std::string_view name,
                        std::string_view version);

/// The machine of that name or name@version, or the Problem of missing_machine().
Result<const machine::LibraryEntry*> find_machine(const machine::Library& machines,
                                                  std::string_view name_and_version);

}  // namespace pentapost::server
