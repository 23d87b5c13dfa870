#include "server/endpoints.hpp"
#include "server/json/job_json.hpp"
#include "server/json/machine_list_json.hpp"

#include <string>
#include <utility>

namespace pentapost::server {
namespace {

/// Whether the client has the representation with that tag already (RFC 9110, 13.1.2).
bool is_known(const Request& request, std::string_view tag) {
  for (const auto& [name, value] : request.headers) {
    if (name != "if-none-match") continue;
    if (value == "*" || value.find(tag) != std::string::npos) return true;
  }
  return false;
}

/// A file's bytes, or 304 where the client has them.
Response file_answer(const machine::LibraryEntry& entry, const Request& request,
                     std::string_view cache_control) {
  const std::string tag = '"' + entry.definition.sha256 + '"';
  Response response{.content_type = "application/json"};
  response.headers.emplace_back("ETag", tag);
  response.headers.emplace_back("Cache-Control", cache_control);
  if (is_known(request, tag)) response.status = 304;
  response.body = entry.bytes;
  return response;
}

}  // namespace

Result<Response> get_machines(Call& call) {
  return Response{.content_type = "application/json",
                  .body = machine_list_json(call.services.machines)};
}

Result<Response> get_machine(Call& call) {
  const auto& machines = call.services.machines;
  const auto* const entry = machines.find(call.names[0]);
  if (entry == nullptr) return missing_machine(machines, call.names[0], "");
  return file_answer(*entry, call.request, "no-cache");
}

Result<Response> get_machine_version(Call& call) {
  const auto& machines = call.services.machines;
  const auto* const entry = machines.find(call.names[0], call.names[1]);
  if (entry == nullptr) return missing_machine(machines, call.names[0], call.names[1]);
  return file_answer(*entry, call.request, "max-age=86400");
}

}  // namespace pentapost::server
