#include "pentapost/jobs/reorient.hpp"

#include "pentapost/analysis/path_analysis.hpp"
#include "pentapost/core/number_text.hpp"
#include "pentapost/jobs/clearances.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/jobs/reorientation.hpp"
#include "pentapost/jobs/setup_choices.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace pentapost::jobs {
namespace {

Status check_domain(const ReorientJob& job) {
  const auto refuse = [](const std::string& pointer, const std::string& message) {
    return Problem{.code = Code::out_of_domain, .message = message, .pointer = pointer};
  };
  if (!(job.setup_accuracy_deg >= 0.0 && job.setup_accuracy_deg <= largest_setup_accuracy_deg))
    return refuse("/setup_accuracy_deg", "found " + number_text(job.setup_accuracy_deg) +
                                             "; expected 0 to " +
                                             number_text(largest_setup_accuracy_deg) + " deg");
  if (job.map_step_deg &&
      !(*job.map_step_deg >= smallest_map_step_deg && *job.map_step_deg <= largest_map_step_deg))
    return refuse("/map/step_deg", "found " + number_text(*job.map_step_deg) + "; expected " +
                                       number_text(smallest_map_step_deg) + " to " +
                                       number_text(largest_map_step_deg) + " deg");
  for (std::size_t i = 0; i < job.candidates.size(); ++i)
    for (const double angle_deg : {job.candidates[i].theta_x_deg, job.candidates[i].theta_z_deg})
      if (!(std::abs(angle_deg) <= largest_setup_angle_deg))
        return refuse("/candidates/" + std::to_string(i),
                      "found " + number_text(angle_deg) + "; expected angles within +-360 deg");
  return ok();
}

Status check_machine(const ReorientJob& job, const PreparedJob& prepared) {
  if (prepared.model.rotary_count != 2)
    return Problem{.code = Code::not_reorientable,
                   .message = "machine " + job.job.machine.name + " has " +
                              std::to_string(prepared.model.rotary_count) +
                              " rotary axes; a path can be reoriented for two"};
  const auto limits = analysis::speed_limits(prepared.model, prepared.settings);
  if (job.objective != Objective::rotary_travel &&
      std::none_of(limits.begin(), limits.end(), [](const auto& each) { return each.has_value(); }))
    return Problem{.code = Code::no_speed_limit,
                   .message = "no axis of machine " + job.job.machine.name +
                              " has a speed limit to measure by; give limits in the job, or choose "
                              "the objective rotary_travel",
                   .pointer = "/limits"};
  return ok();
}

}  // namespace

Result<ReorientReport> reorient(const ReorientJob& job) {
  if (auto status = check_domain(job); !status) return std::move(status).error();
  // The setup is the search's own.
  PostJob unturned = job.job;
  unturned.setup.theta_x_deg = unturned.setup.theta_z_deg = 0.0;
  auto prepared = prepare(unturned);
  if (!prepared) return std::move(prepared).error();
  if (auto status = check_machine(job, *prepared); !status) return std::move(status).error();
  expand_holes(*prepared, [](std::uint32_t) { return false; });
  auto domain = setup_choices(job, *prepared);
  if (!domain) return std::move(domain).error();
  auto check = clearance_check(unturned, *prepared, job.clearance, job.origin_mm.has_value(),
                               prepared->read.diagnostics);
  if (!check) return std::move(check).error();
  ReorientReport report =
      Reorientation{job, *prepared, *std::move(domain), *std::move(check)}.run();
  report.diagnostics = std::move(prepared->read.diagnostics);
  return report;
}

}  // namespace pentapost::jobs
