#include "server/json/machine_names.hpp"

#include "server/json/name_text.hpp"

#include <string>
#include <utility>

namespace pentapost::server {

Problem placed_in_request(Problem problem, const jobs::PostJob& job,
                          const machine::Library& machines) {
  const auto* const entry = machines.find(job.machine.name, job.machine.version);
  const bool named = entry != nullptr && entry->definition.sha256 == job.machine.sha256;
  if (named && problem.pointer.starts_with("/machine/")) problem.pointer = "/machine";
  return problem;
}

Problem missing_machine(const machine::Library& machines, std::string_view name,
                        std::string_view version) {
  if (machines.find(name) == nullptr) {
    const auto near = machines.near_names(name);
    const std::string hint = near.empty() ? "" : "; near: " + joined(near);
    return Problem{.code = Code::unknown_machine,
                   .message = "there is no machine " + quoted(name) + hint};
  }
  return Problem{.code = Code::unknown_version,
                 .message = "there is no version " + quoted(version) + " of " + quoted(name) +
                            "; there are: " + joined(machines.versions(name))};
}

Result<const machine::LibraryEntry*> find_machine(const machine::Library& machines,
                                                  std::string_view name_and_version) {
  const auto at = name_and_version.find('@');
  const auto name = name_and_version.substr(0, at);
  const bool newest = at == std::string_view::npos;
  const auto version = newest ? std::string_view{} : name_and_version.substr(at + 1);
  const auto* const entry = newest ? machines.find(name) : machines.find(name, version);
  if (entry != nullptr) return entry;
  return missing_machine(machines, name, version);
}

}  // namespace pentapost::server
