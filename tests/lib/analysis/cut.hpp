#pragma once

#include "machines/bundled.hpp"
#include "pentapost/analysis/cl_analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace pentapost::sample {

/// A cut of 1 mm steps along X on a bundled machine.
struct Cut {
  explicit Cut(const std::string& name) : machine{sample::bundled_machine(name)} {
    settings.limits = machine.limits;
    settings.preferences = machine.preferences;
    path.add_event(1, path::FeedRate{.value = 2000.0});
  }
  void to(const Vec3& axis) {
    const auto count = static_cast<std::uint32_t>(path.size());
    path.add_point({static_cast<double>(count), 0.0, 0.0}, axis.normalized(), count + 2,
                   count == 0 ? path::Move::rapid : path::Move::feed);
  }
  void limit(const std::string& axis, double deg_s) {
    settings.limits[axis].max_speed = deg_s * rad_per_deg;
  }
  analysis::PathAnalysis analysed(const analysis::AnalysisOptions& options = {}) const {
    const kinematics::Model model{machine.chain};
    const auto analysis = analysis::analyse_path(model, plan::joint_ranges(machine.chain, model),
                                                 path, settings, options);
    EXPECT_TRUE(analysis) << analysis.error().message;
    return analysis ? *analysis : analysis::PathAnalysis{};
  }

  machine::Definition machine;
  plan::Settings settings;
  path::ToolPath path;
};

/// Tool axis at `tilt_deg` from Z towards `azimuth_deg`.
inline Vec3 tilted(double tilt_deg, double azimuth_deg) {
  const double tilt = tilt_deg * rad_per_deg, azimuth = azimuth_deg * rad_per_deg;
  return {std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt)};
}

}  // namespace pentapost::sample
