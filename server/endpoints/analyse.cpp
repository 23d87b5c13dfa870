#include "server/endpoints/job_request.hpp"
#include "server/json/analysis_json.hpp"

#include <utility>

namespace pentapost::server {

Result<Response> analyse_path(Call& call) {
  const auto slot = call.admission.start();
  const auto job = take_job(call, read_analyse_job);
  if (!job) return job.error();
  auto report = traced(call, job->job, [&] { return call.services.analyse(*job); });
  if (job->nc) call.cl.reset();  // there are no CL data to trace
  if (!report) return std::move(report).error();
  Response response = job_response(call);
  response.body = analysis_json(*report);
  return response;
}

}  // namespace pentapost::server
