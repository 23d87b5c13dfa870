#pragma once

#include "pentapost/reorient/setup_domain.hpp"
#include "pentapost/reorient/setup_values.hpp"

#include <cstddef>
#include <queue>
#include <vector>

namespace pentapost::reorient {

/// A part of the domain that may hold what is searched for.
struct SearchCell {
  SetupCell cell;
  double least_value = 0.0;
  Hints hints;
  std::size_t widest = 0;  ///< dimension to be halved
};

struct HigherLeastValue {
  bool operator()(const SearchCell& x, const SearchCell& y) const {
    return x.least_value > y.least_value;
  }
};
using SearchQueue = std::priority_queue<SearchCell, std::vector<SearchCell>, HigherLeastValue>;

}  // namespace pentapost::reorient
