#include "server/endpoints/job_request.hpp"

#include "server/http/form.hpp"
#include "server/http/media_type.hpp"

#include <utility>

namespace pentapost::server {
namespace {

/// The parts of a job from a web form: machine, machines, cl, nc, job.
Result<JobParts> parts_of_form(const Request& request) {
  const auto fields = read_form(*find_field(request.headers, "content-type"), request.body);
  if (!fields) return fields.error();
  JobParts parts;
  for (const auto& [name, content, file_name] : *fields) {
    auto* const part = name == "cl"    ? &parts.cl
                       : name == "nc"  ? &parts.nc
                       : name == "job" ? &parts.json
                                       : nullptr;
    if (part != nullptr && *part) {
      return Problem{.code = Code::conflicting_keys,
                     .message = "a field of the form stands twice: " + name,
                     .pointer = name == "job" ? "" : pointer_to_key(name)};
    }
    if (part != nullptr) {
      part->emplace(content);
      if (name == "cl") parts.cl_file_name = file_name;
    } else if (name == "machine" || name == "machines") {
      parts.words.emplace_back(name, content);
    } else {
      return Problem{.code = Code::unknown_key,
                     .message = "the form has a field other than machine, machines, cl, nc and job",
                     .pointer = pointer_to_key(name)};
    }
  }
  return parts;
}

}  // namespace

Result<JobParts> take_job_parts(Request& request) {
  const auto type = media_type_of(*find_field(request.headers, "content-type"));
  if (type == "text/plain")
    return JobParts{.cl = std::move(request.body), .words = std::move(request.query)};
  if (!request.query.empty()) {
    return Problem{.code = Code::unknown_key,
                   .message = "query keys belong to the text/plain form only",
                   .pointer = pointer_to_key(request.query.front().first)};
  }
  if (type == "application/json") return JobParts{.json = std::move(request.body)};
  auto parts = parts_of_form(request);
  request.body = {};
  return parts;
}

Response job_response(const Call& call) {
  Response response{.content_type = "application/json", .cl = call.cl};
  response.headers.emplace_back("Cache-Control", "no-store");
  return response;
}

}  // namespace pentapost::server
