#include "server/endpoints/job_request.hpp"
#include "server/json/reorient_json.hpp"

#include <utility>

namespace pentapost::server {

Result<Response> reorient_path(Call& call) {
  const auto slot = call.admission.start();
  const auto job = take_job(call, read_reorient_job);
  if (!job) return job.error();
  auto report = traced(call, job->job, [&] { return call.services.reorient(*job); });
  if (!report) return std::move(report).error();
  Response response = job_response(call);
  response.body = reorient_json(*report);
  return response;
}

}  // namespace pentapost::server
