#pragma once

#include "pentapost/cl/reader.hpp"
#include "pentapost/cl/words.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace pentapost::cl {

/// What a file says about its unit of length, and where.
struct UnitStatements {
  std::optional<Units> stated = {};  ///< by the first UNIT statement
  std::uint32_t stated_line = 0;
  std::optional<Units> by_feed = {};  ///< by the first unit word of a FEDRAT or CYCLE
  std::uint32_t feed_line = 0;
};

/// Looks through the text as far as the first UNIT statement.
UnitStatements find_units(std::string_view text);

/// The unit that a UNIT statement names; nullopt: none that is known.
std::optional<Units> stated_unit(const Words& words);

/// A unit of feed as a statement says it.
struct FeedUnit {
  std::optional<Units> length = {};  ///< nullopt: the file's
  bool per_revolution = false;
};

/// The unit of feed that `word` names (IPM, MMPM, IPR, MMPR, PERMIN, PERREV); nullopt: none.
std::optional<FeedUnit> feed_unit(const Word& word);

inline double mm_per(Units units) { return units == Units::inch ? mm_per_inch : 1.0; }
inline std::string_view name_of(Units units) { return units == Units::inch ? "inch" : "mm"; }

}  // namespace pentapost::cl
