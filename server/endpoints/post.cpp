#include "server/endpoints/job_request.hpp"
#include "server/json/report_json.hpp"

#include <utility>

namespace pentapost::server {

Result<Response> post_program(Call& call) {
  const auto slot = call.admission.start();
  auto job = take_job(call, read_post_job);
  if (!job) return job.error();
  job->post.lint = call.media_type == "application/json";
  auto report = traced(call, *job, [&] { return call.services.post(*job); });
  if (!report) return std::move(report).error();
  Response response = job_response(call);
  if (call.media_type == "application/json") {
    response.body = post_answer_json(*report);
    return response;
  }
  response.content_type = "text/plain; charset=utf-8";
  response.body = std::move(report->nc);
  return response;
}

}  // namespace pentapost::server
