#pragma once

#include "pentapost/core/sha256.hpp"
#include "server/dialect_names.hpp"
#include "server/endpoints.hpp"
#include "server/json/job_json.hpp"

#include <string>
#include <utility>

namespace pentapost::server {

/// Takes the parts of a job out of a request: a JSON job, a CL file with a query, or a web form.
Result<JobParts> take_job_parts(Request& request);

/// Takes the job out of a call's request.
/// @param read  read_post_job() or its like.
template <class Job>
Result<Job> take_job(Call& call, Result<Job> (*read)(JobParts, const JobContext&)) {
  auto parts = take_job_parts(call.request);
  if (!parts) return std::move(parts).error();
  const auto dialects = dialect_names();
  return read(std::move(*parts), {.machines = call.services.machines, .dialects = dialects});
}

/// Runs a job, and notes the CL data for the log.
/// @param run  gives the Result of a report with a ReportHead.
/// @return the report, or its Problem with the pointer into the request.
template <class Run>
auto traced(Call& call, const jobs::PostJob& job, const Run& run) -> decltype(run()) {
  const auto* const cl = std::get_if<jobs::ClText>(&job.path);
  if (cl != nullptr) call.cl = ClTrace{.sha256 = {}, .bytes = cl->text.size()};
  auto report = run();
  if (cl != nullptr) call.cl->sha256 = report ? report->cl_sha256 : sha256_hex(cl->text);
  if (report) return report;
  return placed_in_request(std::move(report).error(), job, call.services.machines);
}

/// The answer to a job, whose body is still to be set: JSON that no cache keeps.
Response job_response(const Call& call);

}  // namespace pentapost::server
