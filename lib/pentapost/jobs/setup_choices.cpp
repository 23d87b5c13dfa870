#include "pentapost/jobs/setup_choices.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/reorient/clamping.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace pentapost::jobs {
namespace {

using reorient::Coordinate;

Problem out_of_domain(const std::string& pointer, const std::string& message) {
  return {.code = Code::out_of_domain, .message = message, .pointer = pointer};
}

/// Values within the range that the jig allows; the whole range where it allows all.
Result<Coordinate> values_of(const AngleChoice& choice, const std::string& name,
                             const Range<double>& range) {
  if (choice.step_deg && !choice.allowed_deg.empty())
    return Problem{.code = Code::conflicting_keys,
                   .message = name + " has a step and a list of allowed angles",
                   .pointer = "/step_deg"};
  std::vector<double> values;
  if (choice.step_deg) {
    const double step_deg = *choice.step_deg;
    if (!(step_deg >= smallest_angle_step_deg && step_deg <= largest_setup_angle_deg))
      return out_of_domain("/step_deg", "found " + number_text(step_deg) + "; expected " +
                                            number_text(smallest_angle_step_deg) + " to " +
                                            number_text(largest_setup_angle_deg) + " deg");
    const double rounding = 1e-9;
    for (double i = std::ceil(range.lower / step_deg - rounding);
         i <= range.upper / step_deg + rounding; ++i)
      values.push_back(i == 0.0 ? 0.0 : i * step_deg);
  } else if (!choice.allowed_deg.empty()) {
    for (const double angle_deg : choice.allowed_deg) {
      if (!(std::abs(angle_deg) <= largest_setup_angle_deg))
        return out_of_domain("/allowed_deg/" + name, "found " + number_text(angle_deg) +
                                                         "; expected an angle within +-360 deg");
      if (range.contains(angle_deg) || name == "theta_z_deg") values.push_back(angle_deg);
    }
  } else {
    return Coordinate::interval(range.lower, range.upper);
  }
  if (values.empty())
    return out_of_domain("/max_tilt_deg",
                         "no allowed " + name + " is within " + number_text(range.upper) + " deg");
  return Coordinate::list(std::move(values));
}

Status check_bounds(const ReorientJob& job) {
  if (!(job.max_tilt_deg >= 0.0 && job.max_tilt_deg <= 180.0))
    return out_of_domain("/max_tilt_deg",
                         "found " + number_text(job.max_tilt_deg) + "; expected 0 to 180 deg");
  if (!job.origin_mm) return ok();
  for (std::size_t i = 0; i < 3; ++i)
    if (const auto& range = (*job.origin_mm)[i];
        !std::isfinite(range.lower) || !std::isfinite(range.upper) || range.lower > range.upper)
      return out_of_domain("/origin_bounds_mm/max/" + std::to_string(i),
                           "found " + number_text(range.upper) + "; expected a number not below " +
                               number_text(range.lower));
  return ok();
}

}  // namespace

Result<reorient::SetupDomain> setup_choices(const ReorientJob& job, const PreparedJob& prepared) {
  if (auto status = check_bounds(job); !status) return std::move(status).error();
  const bool is_free = !job.theta_x.step_deg && job.theta_x.allowed_deg.empty() &&
                       !job.theta_z.step_deg && job.theta_z.allowed_deg.empty() &&
                       job.forbidden.empty();
  const bool twins = !job.origin_mm && reorient::has_twins(prepared.model, prepared.ranges,
                                                           prepared.settings.origin_mm);
  auto theta_x = values_of(job.theta_x, "theta_x_deg", {0.0 - job.max_tilt_deg, job.max_tilt_deg});
  if (!theta_x) return std::move(theta_x).error();
  const double most_turn_deg = is_free && twins ? 90.0 : 180.0;
  auto theta_z = values_of(job.theta_z, "theta_z_deg", {-most_turn_deg, most_turn_deg});
  if (!theta_z) return std::move(theta_z).error();
  const auto origin = [&](std::size_t i) {
    if (job.origin_mm)
      return Coordinate::interval((*job.origin_mm)[i].lower, (*job.origin_mm)[i].upper);
    return Coordinate::list({prepared.settings.origin_mm[static_cast<Eigen::Index>(i)]});
  };
  reorient::SetupDomain domain{
      .coordinates = {*std::move(theta_x), *std::move(theta_z), origin(0), origin(1), origin(2)},
      .forbidden = {}};
  for (const ForbiddenAngles& each : job.forbidden)
    domain.forbidden.push_back({each.theta_x_deg, each.theta_z_deg});
  return domain;
}

}  // namespace pentapost::jobs
