#include "pentapost/jobs/job_domain.hpp"

#include "pentapost/core/number_text.hpp"

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace pentapost::jobs {
namespace {

struct DomainRow {
  std::string_view pointer;
  double found;
  double largest;
  bool positive;  ///< above 0; otherwise at most `largest` either way
};

bool contains(const DomainRow& row) {
  if (row.positive) return row.found > 0.0 && row.found <= row.largest;
  return std::abs(row.found) <= row.largest;
}

}  // namespace

Status check_domain(const PostJob& job) {
  const std::array rows{
      DomainRow{"/tolerances/tip_mm", job.tolerances.tip_mm, largest_tip_tolerance_mm, true},
      DomainRow{"/tolerances/axis_deg", job.tolerances.axis_deg, largest_axis_tolerance_deg, true},
      DomainRow{"/setup/theta_x_deg", job.setup.theta_x_deg, largest_setup_angle_deg, false},
      DomainRow{"/setup/theta_z_deg", job.setup.theta_z_deg, largest_setup_angle_deg, false},
  };
  for (const DomainRow& row : rows) {
    if (contains(row)) continue;
    const std::string largest = number_text(row.largest);
    std::string message = "found " + number_text(row.found) + "; expected a number ";
    message += row.positive ? "above 0" : "of at least -" + largest;
    message += " and of at most " + largest;
    return Problem{.code = Code::out_of_domain,
                   .message = std::move(message),
                   .pointer = std::string{row.pointer}};
  }
  return ok();
}

}  // namespace pentapost::jobs
