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
  // Of as many setups as a map may have.
  constexpr double most_map_setups = 50'000.0;
  if (job.map_step_deg) {
    const double step_deg = *job.map_step_deg;
    const double setups = (2.0 * job.max_tilt_deg / step_deg + 1.0) * (360.0 / step_deg + 1.0);
    if (setups > most_map_setups)
      return refuse("/map/step_deg", "found " + number_text(step_deg) + ", for a map of " +
                                         number_text(std::floor(setups)) +
                                         " setups; expected a step with which there are at most " +
                                         number_text(most_map_setups));
  }
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

/// Every candidate is an analysis of the whole path.
Status check_work(const ReorientJob& job, const PreparedJob& prepared) {
  constexpr double most_points = 5e7;
  const double points = static_cast<double>(job.candidates.size()) *
                        static_cast<double>(prepared.read.tool_path.size());
  if (points <= most_points) return ok();
  return Problem{
      .code = Code::too_large,
      .message = "found " + std::to_string(job.candidates.size()) + " candidates for a path of " +
                 std::to_string(prepared.read.tool_path.size()) + " points; expected at most " +
                 number_text(most_points) + " points over all of them",
      .pointer = "/candidates"};
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
  if (auto status = check_work(job, *prepared); !status) return std::move(status).error();
  auto domain = setup_choices(job, *prepared);
  if (!domain) return std::move(domain).error();
  auto check = clearance_check(unturned, *prepared, job.clearance, job.origin_mm.has_value(),
                               prepared->read.diagnostics);
  if (!check) return std::move(check).error();
  if (*check)
    prepared->read.diagnostics.add(
        {Severity::info, Code::clearance_coarse, 0,
         "collisions were looked for coarsely: holder and spindle as cylinders against table and "
         "jig, at the CL points and places of " +
             number_text((*check)->step_mm(), 2) + " mm between them"});
  ReorientReport report =
      Reorientation{job, *prepared, *std::move(domain), *std::move(check)}.run();
  report.diagnostics = std::move(prepared->read.diagnostics);
  return report;
}

}  // namespace pentapost::jobs
