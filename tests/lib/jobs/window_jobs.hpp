#pragma once

#include "lib/jobs/setup_oracle.hpp"
#include "machines/bundled.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "sample/chains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace pentapost::sample {

inline constexpr double grid_deg = 0.25;

/// A job with a window of setups so small that all of it can be tried.
struct WindowJob {
  jobs::ReorientJob job;
  std::vector<double> theta_x_deg, theta_z_deg;  ///< of a grid inside the window
};

class WindowJobs {
 public:
  WindowJobs(std::uint64_t seed, const std::vector<BundledMachine>& machines)
      : random_{seed}, machines_{machines} {}

  WindowJob next(jobs::Objective objective, double accuracy_deg, int steps) {
    WindowJob made{.job = {.job = {.machine = machine(), .path = jobs::PointPath{}}},
                   .theta_x_deg = {},
                   .theta_z_deg = {}};
    made.job.objective = objective;
    made.job.setup_accuracy_deg = accuracy_deg;
    add_limits(made.job.job);
    add_window(made, steps);
    made.job.job.path = path(made);
    if (chance(0.5)) made.job.job.gauge_length_mm = {{1, real(20.0, 200.0)}};
    if (chance(0.5))
      made.job.job.setup.origin_mm = Vec3{real(-40, 40), real(-40, 40), real(0, 150)};
    return made;
  }

 private:
  double real(double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random_);
  }
  int whole(int lower, int upper) {
    return std::uniform_int_distribution<int>{lower, upper}(random_);
  }
  bool chance(double share) { return real(0.0, 1.0) < share; }

  /// Of every topology: table-table, table-head, head-head, nutating, with a pole along Y.
  const machine::Definition& machine() {
    constexpr std::array names{
        "hermle-c600u", "dmu-50-evolution",   "dmu-80-monoblock", "generic-ca-head", "dmu-125p",
        "haas-umc-750", "linuxcnc-xyzac-trt", "pocket-nc-v2",     "huron-kx100",     "dmu-70-evo"};
    const std::string name = names[static_cast<std::size_t>(whole(0, names.size() - 1))];
    return std::find_if(machines_.begin(), machines_.end(),
                        [&](const auto& each) { return each.definition.name == name; })
        ->definition;
  }

  void add_limits(jobs::PostJob& job) {
    const kinematics::Model model{job.machine.chain};
    for (const std::string& name : model.rotary_names)
      if (chance(0.9)) job.limits[name].max_speed = real(0.1, 3.0);
    if (job.limits.empty()) job.limits[model.rotary_names[0]].max_speed = 1.0;
    if (chance(0.5))
      for (const std::string& name : model.linear_names)
        if (chance(0.7)) job.limits[name].max_speed = real(20.0, 500.0);
  }

  void add_window(WindowJob& made, int steps) {
    const double width_deg = grid_deg * steps;
    const double x_deg = std::round(real(-60.0, 60.0 - width_deg) * 4.0) / 4.0;
    const double z_deg = std::round(real(-179.0, 179.0 - width_deg) * 4.0) / 4.0;
    for (int i = 1; i < steps; ++i) {
      made.theta_x_deg.push_back(x_deg + grid_deg * i);
      made.theta_z_deg.push_back(z_deg + grid_deg * i);
    }
    jobs::ReorientJob& job = made.job;
    job.max_tilt_deg = 60.0;
    job.forbidden.push_back({.theta_x_deg = Range<double>{-60.0, x_deg}});
    job.forbidden.push_back({.theta_x_deg = Range<double>{x_deg + width_deg, 60.0}});
    switch (whole(0, 3)) {
      case 0:
        job.theta_x.step_deg = job.theta_z.step_deg = grid_deg;
        break;
      case 1: {
        const std::array<double, 3> picked{made.theta_z_deg.front(), made.theta_z_deg.back(),
                                           made.theta_z_deg[made.theta_z_deg.size() / 2]};
        job.theta_z.allowed_deg = made.theta_z_deg = {picked.begin(), picked.end()};
        return;
      }
      default:
        break;
    }
    job.forbidden.push_back({.theta_z_deg = Range<double>{-180.0, z_deg}});
    job.forbidden.push_back({.theta_z_deg = Range<double>{z_deg + width_deg, 180.0}});
  }

  /// A walk on the sphere that starts at some angle from the pole of the middle of the window.
  jobs::PointPath path(const WindowJob& made) {
    const kinematics::Model model{made.job.job.machine.chain};
    const Mat3 to_table = paper_turn(made.theta_x_deg[made.theta_x_deg.size() / 2],
                                     made.theta_z_deg[made.theta_z_deg.size() / 2]);
    const Vec3 pole = to_table.transpose() * model.fixed.a_drawn;
    const double least = std::abs(model.lambda_rad - model.mu_rad);
    const double most = std::min(model.lambda_rad + model.mu_rad, 0.6 * pi);
    const double gamma_rad = chance(0.5) ? least + real(0.0, 8.0) * rad_per_deg : real(least, most);
    Vec3 axis = random_axis_at(random_, pole, gamma_rad);
    jobs::PointPath path{.feed_mm_min = real(300.0, 4000.0), .tip_mm = {}, .axis = {}};
    const int points = whole(3, 12);
    const double step_deg = std::exp(real(std::log(0.3), std::log(12.0)));
    Vec3 tip_mm{real(-40, 40), real(-40, 40), real(0, 40)};
    Vec3 turn = random_axis(random_);
    for (int i = 0; i < points; ++i) {
      path.tip_mm.push_back(tip_mm);
      path.axis.push_back(axis);
      tip_mm += real(0.3, 6.0) * random_axis(random_);
      turn = (turn + 0.7 * random_axis(random_)).normalized();
      axis = Eigen::AngleAxisd{real(0.0, step_deg) * rad_per_deg, turn} * axis;
    }
    return path;
  }

  std::mt19937_64 random_;
  const std::vector<BundledMachine>& machines_;
};

}  // namespace pentapost::sample
