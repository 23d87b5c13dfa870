#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::machine {

/// Those of `names` that `name` may be a misspelling of, nearest first; at most 3.
///
/// Near: up to a third of the letters changed, inserted, left out or exchanged with a neighbour,
/// whatever their case; or one is a part of the other. Empty: none is near.
std::vector<std::string> near_names(std::string_view name, std::span<const std::string> names);

}  // namespace pentapost::machine
