#include "server/endpoints/job_request.hpp"
#include "server/json/compare_json.hpp"

#include <utility>

namespace pentapost::server {

Result<Response> compare_machines(Call& call) {
  const auto slot = call.admission.start();
  const auto job = take_job(call, read_compare_job);
  if (!job) return job.error();
  auto report = traced(call, job->job, [&] { return call.services.compare(*job); });
  if (!report) return std::move(report).error();
  Response response = job_response(call);
  response.body = compare_json(*report, call.services.machines);
  response.defect = defects_of(*report);
  return response;
}

}  // namespace pentapost::server
