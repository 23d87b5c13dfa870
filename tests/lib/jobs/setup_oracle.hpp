#pragma once

#include "lib/analysis/closest.hpp"
#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/jobs/prepared_job.hpp"
#include "pentapost/jobs/setup_report.hpp"
#include "pentapost/path/turn.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

/// What a setup is worth, by an analysis of the whole path in it: the truth that the search for
/// setups is held against.
namespace pentapost::sample {

/// R_x(theta_x) R_z(theta_z) with the passive matrices as Cripps et al. 2017 print them.
inline Mat3 paper_turn(double theta_x_deg, double theta_z_deg) {
  const double x = theta_x_deg * rad_per_deg, z = theta_z_deg * rad_per_deg;
  Mat3 about_x, about_z;
  about_x << 1, 0, 0, 0, std::cos(x), std::sin(x), 0, -std::sin(x), std::cos(x);
  about_z << std::cos(z), std::sin(z), 0, -std::sin(z), std::cos(z), 0, 0, 0, 1;
  return about_x * about_z;
}

class SetupOracle {
 public:
  explicit SetupOracle(jobs::PostJob job) : prepared_{prepared(std::move(job))} {}

  const jobs::PreparedJob& prepared_job() const { return prepared_; }

  /// nullopt: not possible.
  std::optional<analysis::PathAnalysis> analysed(const Mat3& to_table) const {
    path::ToolPath turned = prepared_.read.tool_path;
    path::turn(turned, to_table);
    auto found =
        analysis::analyse_path(prepared_.model, prepared_.ranges, turned, prepared_.settings, {});
    return found ? std::optional{*std::move(found)} : std::nullopt;
  }

  /// Ratio, seconds or degrees; infinite: not possible.
  double value(jobs::Objective objective, const Mat3& to_table) const {
    const auto found = analysed(to_table);
    if (!found) return std::numeric_limits<double>::infinity();
    switch (objective) {
      case jobs::Objective::time:
        return found->predicted_time_s;
      case jobs::Objective::rotary_travel:
        return (found->spans.travel()[3] + found->spans.travel()[4]) * deg_per_rad;
      case jobs::Objective::peak_ratio:
        break;
    }
    double largest = 0.0;
    for (const auto& peak : found->peaks) largest = std::max(largest, peak.ratio);
    return largest;
  }

  /// The largest value of a setup and of others with the pole at a distance all round; infinite
  /// too where a singularity is met within it.
  double value_about(jobs::Objective objective, const Mat3& to_table, double distance_deg,
                     int count) const {
    double largest = value(objective, to_table);
    if (distance_deg == 0.0 || !std::isfinite(largest)) return largest;
    if (objective == jobs::Objective::peak_ratio) {
      const auto approach = closest(*analysed(to_table));
      if (approach && approach->distance_rad <= distance_deg * rad_per_deg)
        return std::numeric_limits<double>::infinity();
    }
    const Vec3 pole = to_table.transpose() * prepared_.model.a;
    const Vec3 aside = pole.unitOrthogonal();
    for (int i = 0; i < count; ++i) {
      const Vec3 about = Eigen::AngleAxisd{2.0 * pi * i / count, pole} * aside;
      const Mat3 turn = Eigen::AngleAxisd{distance_deg * rad_per_deg, about}.toRotationMatrix();
      // A setup that the accuracy takes out of range is no worse by that.
      if (const double each = value(objective, to_table * turn.transpose()); std::isfinite(each))
        largest = std::max(largest, each);
    }
    return largest;
  }

 private:
  static jobs::PreparedJob prepared(jobs::PostJob job) {
    job.setup.theta_x_deg = job.setup.theta_z_deg = 0.0;
    auto ready = jobs::prepare(job);
    if (!ready) throw std::runtime_error{ready.error().message};
    jobs::expand_holes(*ready, [](std::uint32_t) { return false; });
    return *std::move(ready);
  }

  jobs::PreparedJob prepared_;
};

}  // namespace pentapost::sample
