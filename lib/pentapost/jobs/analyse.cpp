#include "pentapost/jobs/analyse.hpp"

#include "pentapost/jobs/analyse_prepared.hpp"
#include "pentapost/jobs/analyse_program.hpp"
#include "pentapost/jobs/job_domain.hpp"
#include "pentapost/jobs/prepared_job.hpp"

#include <string>
#include <utility>

namespace pentapost::jobs {
namespace {

Status check_own_domain(const AnalyseJob& job) {
  if (auto status = check_zone_share(job.zone_share); !status) return status;
  const auto fewest = analysis::Samples::fewest;
  if (job.samples && (*job.samples < fewest || *job.samples > AnalyseJob::most_samples))
    return Problem{.code = Code::out_of_domain,
                   .message = "found " + std::to_string(*job.samples) + "; expected " +
                              std::to_string(fewest) + " to " +
                              std::to_string(AnalyseJob::most_samples),
                   .pointer = "/max_samples"};
  return ok();
}

}  // namespace

Result<AnalyseReport> analyse(const AnalyseJob& job) {
  if (auto status = check_own_domain(job); !status) return std::move(status).error();
  if (job.nc) return analyse_program(job);
  auto prepared = prepare(job.job);
  if (!prepared) return std::move(prepared).error();
  return analyse_prepared(job, *prepared, CureSearch::all);
}

}  // namespace pentapost::jobs
