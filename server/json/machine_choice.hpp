#pragma once

#include "pentapost/json/strict_reader.hpp"
#include "pentapost/machine/definition.hpp"
#include "server/json/job_json.hpp"
#include "server/json/job_source.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace pentapost::server {

/// Reads which machines a job is for: by name, name@version, or definitions inline. A failure is
/// kept by the source: missing_key, wrong_type, out_of_domain, conflicting_keys, unknown_machine,
/// unknown_version, or what a definition is refused with. Then nothing is given.
class MachineChoice {
 public:
  /// @param text  of the JSON job, which the inline definitions are part of.
  MachineChoice(JobSource& source, const JobContext& context, std::string_view text)
      : source_{source}, context_{context}, text_{text} {}

  /// The key or the word machine.
  std::vector<machine::Definition> one(const json::Object& job) const;
  /// The key machines, or the word of that name with commas between; not given: the newest version
  /// of each machine of the library, by name.
  std::vector<machine::Definition> several(const json::Object& job) const;

 private:
  std::optional<machine::Definition> named(std::string_view name, std::string_view pointer) const;
  std::optional<machine::Definition> read(const json::Value& value) const;
  std::vector<machine::Definition> listed(std::string_view names) const;
  std::vector<machine::Definition> read_all(const json::Array& machines) const;
  std::vector<machine::Definition> all() const;

  JobSource& source_;
  const JobContext& context_;
  std::string_view text_;
};

}  // namespace pentapost::server
