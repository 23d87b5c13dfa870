#pragma once

#include "pentapost/clearance/places.hpp"
#include "pentapost/clearance/shapes.hpp"
#include "pentapost/machine/clearance.hpp"

#include <cstdint>
#include <optional>

namespace pentapost::clearance {

/// One piece of the tool side against one obstacle.
struct Pair {
  machine::ToolCylinder cylinder;  ///< heights from the tool tip
  const Obstacle& obstacle;        ///< CL coordinates
  double safety_mm = 0.0;
  double step_mm = 0.0;  ///< > 0; see Check
};

struct FoundPlace {
  std::uint32_t point = 0;  ///< there, or on the move that leads there
  double distance_mm = 0.0;
};

/// The first place of a stretch where the pair is within its safety distance.
///
/// @param stretch  index into Places::stretches().
/// @param before  only points before this one are of interest.
std::optional<FoundPlace> first_place(const Places& places, std::size_t stretch, const Pair& pair,
                                      std::uint32_t before);

}  // namespace pentapost::clearance
