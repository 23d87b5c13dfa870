#pragma once

#include "pentapost/path/motion.hpp"

#include <cstddef>
#include <stdexcept>
#include <variant>

namespace pentapost::nc {

/// Hands actions and blocks of `motion` in program order to `writer.act(action)` and
/// `writer.write(block)`. Both give false where they kept a Problem; the walk stops there.
/// Actions that are not in order of their blocks are a std::logic_error.
template <class Writer>
bool walk(const path::Motion& motion, Writer& writer) {
  auto action = motion.actions.begin();
  const auto act_before = [&](std::size_t block) {
    for (; action != motion.actions.end() && action->before_block <= block; ++action) {
      if (action->before_block != block)
        throw std::logic_error{"walk: the actions are not in order of their blocks"};
      const auto one = [&](const auto& what) { return writer.act(what, action->cl_line); };
      if (!std::visit(one, action->what)) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < motion.blocks.size(); ++i) {
    if (!act_before(i) || !writer.write(motion.blocks[i])) return false;
  }
  if (!act_before(motion.blocks.size())) return false;
  if (action != motion.actions.end())
    throw std::logic_error{"walk: an action stands behind the last block"};
  return true;
}

}  // namespace pentapost::nc
