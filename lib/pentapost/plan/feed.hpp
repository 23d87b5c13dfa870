#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/motion.hpp"
#include "pentapost/plan/block_maker.hpp"
#include "pentapost/plan/settings.hpp"

#include <array>
#include <cstdint>
#include <optional>

namespace pentapost::plan {

/// Feed words of cutting blocks (lib/README.md section 6).
class FeedRule {
 public:
  FeedRule(const kinematics::Model& model, const Settings& settings, const WordColumns& columns);

  /// Sets feed and feed mode of a block.
  /// @param length_mm  of the tip's path that the block stands for.
  /// @param feed_mm_min  of the CL data; nullopt: none was given.
  /// @return Problem no_feed or no_rotary_feed with the CL line.
  Status set(path::Block& block, const Posture& from, const Posture& to, double length_mm,
             std::optional<double> feed_mm_min) const;

  /// Shortest time that the limits of the axes allow for the block, in minutes; 0: no limit known.
  double axis_time_min(const Posture& from, const Posture& to) const;

 private:
  Status set_in_place(path::Block& block, const Posture& from, const Posture& to) const;
  // No faster than the control can be told.
  void set_per_minute(path::Block& block, double feed) const;
  void set_inverse_time(path::Block& block, double time_min) const;

  const Settings& settings_;
  std::array<std::optional<double>, 3> linear_mm_s_;
  std::array<std::optional<double>, 2> rotary_rad_s_;
  WordColumns columns_;
};

}  // namespace pentapost::plan
