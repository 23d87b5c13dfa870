#include "pentapost/core/sha256.hpp"
#include "server/dialect_names.hpp"
#include "server/endpoints.hpp"
#include "server/http/form.hpp"
#include "server/http/media_type.hpp"
#include "server/json/job_json.hpp"
#include "server/json/report_json.hpp"

#include <utility>

namespace pentapost::server {
namespace {

/// The parts of a job from a web form: machine, cl, job.
Result<JobParts> parts_of_form(const Request& request) {
  const auto fields = read_form(*find_field(request.headers, "content-type"), request.body);
  if (!fields) return fields.error();
  JobParts parts;
  for (const auto& [name, content, file_name] : *fields) {
    auto* const part = name == "cl" ? &parts.cl : name == "job" ? &parts.json : nullptr;
    if (part != nullptr && *part) {
      return Problem{.code = Code::conflicting_keys,
                     .message = "a field of the form stands twice: " + name,
                     .pointer = name == "cl" ? "/cl" : ""};
    }
    if (part != nullptr) {
      part->emplace(content);
      if (name == "cl") parts.cl_file_name = file_name;
    } else if (name == "machine") {
      parts.words.emplace_back(name, content);
    } else {
      return Problem{.code = Code::unknown_key,
                     .message = "the form has a field other than machine, cl and job",
                     .pointer = pointer_to_key(name)};
    }
  }
  return parts;
}

Result<JobParts> parts_of(Request& request) {
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

}  // namespace

Result<Response> post_program(Call& call) {
  const auto slot = call.admission.start();
  auto parts = parts_of(call.request);
  if (!parts) return std::move(parts).error();
  const auto dialects = dialect_names();
  const auto job =
      read_job(std::move(*parts), {.machines = call.services.machines, .dialects = dialects});
  if (!job) return job.error();
  if (const auto* cl = std::get_if<jobs::ClText>(&job->path))
    call.cl = ClTrace{.sha256 = {}, .bytes = cl->text.size()};

  auto report = call.services.post(*job);
  if (!report) {
    if (call.cl) call.cl->sha256 = sha256_hex(std::get<jobs::ClText>(job->path).text);
    return placed_in_request(std::move(report).error(), *job, call.services.machines);
  }
  if (call.cl) call.cl->sha256 = report->cl_sha256;
  Response response{.content_type = "application/json", .cl = call.cl};
  response.headers.emplace_back("Cache-Control", "no-store");
  if (call.media_type == "application/json") {
    response.body = post_answer_json(*report);
    return response;
  }
  response.content_type = "text/plain; charset=utf-8";
  response.body = std::move(report->nc);
  return response;
}

}  // namespace pentapost::server
