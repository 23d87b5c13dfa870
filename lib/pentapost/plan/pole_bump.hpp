#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/plan/great_circle.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pentapost::plan {

/// How far a bent first joint turns for each radian of the tool axis, where it passes the pole. The
/// bump that moves the axis by delta reaches out to sqrt(2 delta / this) from the pole.
inline constexpr double bent_turn_ratio = 1.0;

/// The change that leads a path exactly through a pole that it passes at a distance delta
/// (lib/README.md section 4). With c the distance of an axis from the pole,
///   x^2 = (c^2 - c_nearest^2) / (c_end^2 - c_nearest^2)
/// is 0 at the nearest place and 1 at the end of a side. The axis is turned towards the pole by
/// delta w(x), w = (1 - x (x - x0) / (1 - x0))^2, which depends on the axis alone and moves it by
/// no more than delta. For x <= x0, the core, it lies on one great circle through the pole.
/// Corners of the CL path are for the caller to round off.
class PoleBump {
 public:
  /// Before the nearest place, and after it.
  static constexpr std::size_t before = 0, after = 1;
  static constexpr double core = 1.0 / 128.0;
  static constexpr double same_share = 1e-6;  ///< x this close, relatively, are one

  /// @param nearest  axis at the nearest place, not the pole.
  /// @param end_chord  by side, beyond the nearest.
  PoleBump(const Vec3& pole, const Vec3& nearest, const std::array<double, 2>& end_chord);

  double delta_rad() const { return delta_rad_; }
  double x_of(const Vec3& axis, std::size_t side) const;

  /// Where a part of a great circle is to be divided so that the straight pieces between bent
  /// places follow the bump: at its core, at its end, and where x grows by more than 40 percent or
  /// 0.1. Then a piece turns the first joint at most 1.4 times as fast as the bump itself.
  /// @param from_fraction, to_fraction  of the circle's turn; the distance grows or falls all
  /// along.
  /// @return fractions between them, in order.
  std::vector<double> divisions(const GreatCircle& turn, double from_fraction, double to_fraction,
                                std::size_t side) const;

  /// Lays the core's line through the pole.
  /// @param core_ends  axes at the ends of the core.
  /// @return false where the path turns there by too much for a line.
  bool set_core(const std::array<Vec3, 2>& core_ends);
  /// The changed axis. After set_core().
  /// @param azimuth_turn_rad  outside the core: by which it is turned about the pole on top.
  Vec3 bent(const Vec3& axis, std::size_t side, double azimuth_turn_rad) const;

  /// Where an axis is about the pole once it is turned by all of delta.
  struct Polar {
    double tilt_rad, azimuth_rad;
  };
  Polar polar(const Vec3& axis) const;
  /// By side: what the end of the core is turned by about the pole to lie on the core's line.
  double core_turn_rad(std::size_t side) const { return core_turn_rad_[side]; }

 private:
  Vec3 shifted(const Vec3& axis, double share) const;
  double azimuth_rad(const Vec3& axis) const;

  Vec3 pole_, towards_, beside_;  ///< orthonormal, right-handed: towards the nearest axis, beside
  Vec3 normal_;                   ///< about which the nearest axis turns to the pole
  double delta_rad_;
  double nearest_square_;
  std::array<double, 2> width_square_;
  double line_rad_ = 0.0;                  ///< azimuth of the core after the pole
  std::array<double, 2> core_turn_rad_{};  ///< by side
};

/// The largest turn of a joint about `pole` for each radian along the great circle between two
/// axes; 0 where it leads through the pole.
double turn_ratio(const Vec3& pole, const Vec3& from, const Vec3& to);

}  // namespace pentapost::plan
