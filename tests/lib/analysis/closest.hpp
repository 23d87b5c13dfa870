#pragma once

#include "pentapost/analysis/path_analysis.hpp"

#include <optional>

namespace pentapost::sample {

/// The nearest approach to any singularity, in range or not.
inline std::optional<analysis::Approach> closest(const analysis::PathAnalysis& analysis) {
  std::optional<analysis::Approach> closest;
  for (const auto& each : analysis.approaches)
    if (each && (!closest || each->distance_rad < closest->distance_rad)) closest = each;
  return closest;
}

}  // namespace pentapost::sample
