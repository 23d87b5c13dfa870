#pragma once

#include "pentapost/analysis/survey.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pentapost::analysis {

/// One place of the path, for plots.
struct Sample {
  PathPlace at;
  double feed_mm_min = 0.0;       ///< programmed
  PerAxis joints{};               ///< mm, rad
  PerAxis speed{};                ///< signed; mm/s, rad/s
  PerAxis acceleration{};         ///< signed; mm/s^2, rad/s^2
  bool has_acceleration = false;  ///< false: none at a singularity
  double opening_sine = 1.0;      ///< see Demand
  Vec3 axis = Vec3::UnitZ();      ///< tool axis, table frame
  bool goes_on = false;           ///< from the sample before without a repositioning between
};

/// Keeps a bounded number of places of a path of any length: of runs of equally many places the
/// first and each axis's fastest, and of the whole path the ends of every axis's span. So no peak
/// of any axis is ever thinned away.
class Samples {
 public:
  static constexpr std::size_t fewest = 100;

  /// @param most  at least fewest.
  explicit Samples(std::size_t most);

  /// The places of one stretch, as a Grid gives them.
  void take(const SurveyedMove& move, const std::vector<Place>& places);
  void interrupt() { is_interrupted_ = true; }
  /// All that were kept, in order.
  std::vector<Sample> finish() &&;

 private:
  struct Row {
    std::uint64_t number;  ///< of the place, from 0
    std::uint64_t course;  ///< number of interruptions before it
    Sample sample;
  };
  void thin();
  void keep_of_runs();
  void keep_extremes(const Row& row);

  std::size_t most_rows_;
  std::uint64_t run_length_ = 1, count_ = 0, course_ = 0;
  bool is_interrupted_ = false;
  std::vector<Row> rows_;
  std::array<std::array<std::optional<Row>, 2>, axis_count> ends_;  ///< of the axes' spans
};

}  // namespace pentapost::analysis
