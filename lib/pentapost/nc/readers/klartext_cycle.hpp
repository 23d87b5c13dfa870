#pragma once

#include "pentapost/nc/reader.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/klartext_scanner.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace pentapost::nc::readers::klartext {

/// Q parameters of one CYCL DEF.
class CycleParameters {
 public:
  static constexpr std::size_t most = 40;

  /// Reads "Q200=+2 ;SET-UP CLEARANCE ~ ..." behind the cycle's name.
  /// @return false: the stream has the Problem.
  bool read(Scanner& scanner, ItemStream& items);

  /// nullopt: not stated, or a word such as MAX.
  std::optional<double> value(int number) const;

  struct One {
    int number = 0;
    std::optional<double> value;  ///< nullopt: a word such as MAX
  };
  const One* begin() const { return all_.data(); }
  const One* end() const { return all_.data() + count_; }

 private:
  std::array<One, most> all_{};
  std::size_t count_ = 0;
};

/// A drilling cycle as it was defined; lengths in mm as written.
struct Cycle {
  std::string_view word;  ///< "CYCL DEF 200"
  int number = 0;
  ReadMotion::Hole hole = ReadMotion::Hole::other;
  double surface_z_mm = 0.0;
  double depth_mm = 0.0;  ///< > 0, below the surface
  double clearance_mm = 0.0;
  double retract_mm = 0.0;  ///< of the way back, above the surface
  double peck_mm = 0.0;
  double dwell_s = 0.0;
  double feed_mm_min = 0.0;  ///< 0: follows from pitch and speed
  double pitch_mm = 0.0;     ///< > 0: of cycles that couple spindle and axis

  /// The spindle stands still behind it.
  bool stops_spindle() const { return number == 207 || number == 209; }
};

/// Whether the cycle drills holes in a way that is understood.
bool is_drilling_cycle(int number);

/// The cycle that `parameters` define; nullopt: the stream has the Problem (bad_cycle).
std::optional<Cycle> drilling_cycle(int number, const CycleParameters& parameters,
                                    ItemStream& items);

}  // namespace pentapost::nc::readers::klartext
