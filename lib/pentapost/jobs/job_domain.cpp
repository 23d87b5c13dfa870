#include "pentapost/jobs/job_domain.hpp"

#include "pentapost/core/number_text.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace pentapost::jobs {
namespace {

struct DomainRow {
  enum class Kind : std::uint8_t { positive, not_negative, either_way };

  std::string_view pointer;
  double found;
  double largest;  ///< of the size, where the sign is free
  Kind kind;
};

bool contains(const DomainRow& row) {
  switch (row.kind) {
    case DomainRow::Kind::positive:
      return row.found > 0.0 && row.found <= row.largest;
    case DomainRow::Kind::not_negative:
      return row.found >= 0.0 && row.found <= row.largest;
    case DomainRow::Kind::either_way:
      break;
  }
  return std::abs(row.found) <= row.largest;
}

std::string lower_bound_text(const DomainRow& row) {
  switch (row.kind) {
    case DomainRow::Kind::positive:
      return "above 0";
    case DomainRow::Kind::not_negative:
      return "of at least 0";
    case DomainRow::Kind::either_way:
      break;
  }
  return "of at least -" + number_text(row.largest);
}

}  // namespace

Status check_domain(const PostJob& job) {
  using Kind = DomainRow::Kind;
  const std::array rows{
      DomainRow{"/tolerances/tip_mm", job.tolerances.tip_mm, largest_tip_tolerance_mm,
                Kind::positive},
      DomainRow{"/tolerances/axis_deg", job.tolerances.axis_deg, largest_axis_tolerance_deg,
                Kind::positive},
      DomainRow{"/setup/theta_x_deg", job.setup.theta_x_deg, largest_setup_angle_deg,
                Kind::either_way},
      DomainRow{"/setup/theta_z_deg", job.setup.theta_z_deg, largest_setup_angle_deg,
                Kind::either_way},
      DomainRow{"/post/pole_axis_deg", job.post.pole_axis_deg, largest_pole_axis_deg,
                Kind::not_negative},
  };
  for (const DomainRow& row : rows) {
    if (contains(row)) continue;
    return Problem{.code = Code::out_of_domain,
                   .message = "found " + number_text(row.found) + "; expected a number " +
                              lower_bound_text(row) + " and of at most " + number_text(row.largest),
                   .pointer = std::string{row.pointer}};
  }
  if (job.post.flank && job.post.pole_axis_deg > 0.0)
    return Problem{.code = Code::conflicting_keys,
                   .message = "the tool axis of a flank cut must not be changed",
                   .pointer = "/post/pole_axis_deg"};
  return ok();
}

Status check_zone_share(double share) {
  if (share > 0.0 && std::isfinite(share)) return ok();
  return Problem{.code = Code::out_of_domain,
                 .message = "found " + number_text(share) + "; expected a number above 0",
                 .pointer = "/zone_share"};
}

}  // namespace pentapost::jobs
