#pragma once

#include "pentapost/analysis/grid.hpp"
#include "pentapost/kinematics/singularity.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace pentapost::analysis {

/// A place of the path.
struct PathPlace {
  std::uint32_t point = 0;  ///< end of the move that it lies on: CL point, or NC block
  std::uint32_t line = 0;   ///< of that point in the CL data or the NC text
  double s_mm = 0.0;        ///< length of the tip's path from the first point
  Vec3 tip_wp_mm = Vec3::Zero();
  double fraction = 1.0;  ///< of the move
};

/// Largest speed of an axis while the tip moves at the programmed feed.
struct AxisPeak {
  double speed = 0.0;         ///< mm/s or rad/s
  double ratio = 0.0;         ///< over the limit; 0 where there is none
  double opening_sine = 1.0;  ///< there; see Demand
  Vec3 axis = Vec3::UnitZ();  ///< tool axis there, table frame
  PathPlace at;
};

/// The place nearest to a singularity.
struct Approach {
  double distance_rad = 0.0;
  kinematics::SingularityKind kind = kinematics::SingularityKind::pole;
  PathPlace at;
};

/// A stretch where an axis is over its allowance: a singular zone, or a demand that is plainly too
/// high.
struct Zone {
  std::size_t axis = 0;  ///< of the largest ratio among those that are over it for that cause
  PathPlace from, to;
  std::optional<Approach> closest;  ///< within the zone; nullopt: the machine has no singularity
  double peak_speed = 0.0;          ///< of that axis, mm/s or rad/s
  double peak_ratio = 0.0;
  double opening_sine = 1.0;        ///< at the peak; see Demand
  Vec3 tool_axis = Vec3::UnitZ();   ///< at the peak, table frame
  double lowest_feed_mm_min = 0.0;  ///< that the axes can hold all through the zone
  double programmed_time_s = 0.0;   ///< through the zone
  double time_lost_s = 0.0;         ///< against the programmed feed, by the speed limits
};

/// A cutting move whose tip moves, as the survey takes it.
struct SurveyedMove {
  std::uint32_t point = 0, line = 0;
  double s_from_mm = 0.0, length_mm = 0.0;
  double time_s = 0.0;  ///< at the programmed feed
  double feed_mm_min() const { return 60.0 * length_mm / time_s; }
  /// The part of the whole move to the point that this is.
  double fraction_from = 0.0, fraction_to = 1.0;
  PathPlace place(const Place& there) const {
    return {point, line, s_from_mm + there.fraction * length_mm, there.demand.tip_mm,
            fraction_from + there.fraction * (fraction_to - fraction_from)};
  }
};

/// How many times longer than programmed the way between two places takes by the speed limits.
double slowing(const Place& from, const Place& to);

/// Collects peaks, zones and times over the moves of a path, in order.
class Survey {
 public:
  Survey(const std::vector<kinematics::Singularity>& singularities, const Allowance& allowance);

  /// The places of one stretch of a move, as a Grid gives them.
  void take(const SurveyedMove& move, const std::vector<Place>& places);
  /// A move that is nowhere over its allowance.
  void pass(const SurveyedMove& move);
  /// The path does not go on: the tool is repositioned.
  void interrupt();

  const std::array<AxisPeak, axis_count>& peaks() const { return peaks_; }
  /// Largest of each axis, mm/s^2 or rad/s^2; nullopt: no place had any.
  const std::optional<PerAxis>& peak_accelerations() const { return peak_accelerations_; }
  /// Of each singularity; nullopt: nothing was cut.
  std::vector<std::optional<Approach>> approaches() const;
  const std::vector<Zone>& singular_zones() const { return singular_.zones; }
  const std::vector<Zone>& plain_zones() const { return plain_.zones; }
  /// Of all moves so far, slowed down wherever an axis is over its limit.
  double predicted_time_s() const { return predicted_time_s_; }

 private:
  struct Zones {
    bool (Load::*is_over)(std::size_t axis, double share) const;
    std::vector<Zone> zones = {};
    bool is_open = false;
  };
  /// A singularity, and the cosines between which a tool axis is nearer to it than all so far.
  struct Watched {
    kinematics::Singularity singularity;
    std::optional<Approach> closest = {};
    double least_cosine = -2.0, most_cosine = 2.0;
  };
  /// Between two places.
  struct Step {
    const Place &from, &to;
    double time_s;  ///< at the programmed feed
    double lost_s;
  };

  void approach(const SurveyedMove& move, const Place& place);
  void take_place(const SurveyedMove& move, const Place& place);
  void extend(Zones& zones, bool is_inside, const SurveyedMove& move, const Step& step) const;
  void raise(Zones& zones, const SurveyedMove& move, const Place& place) const;

  std::vector<Watched> watched_;
  Allowance allowance_;
  std::array<AxisPeak, axis_count> peaks_{};
  std::optional<PerAxis> peak_accelerations_;
  Zones singular_{&Load::is_singular}, plain_{&Load::is_plainly_over};
  double predicted_time_s_ = 0.0;
};

}  // namespace pentapost::analysis
