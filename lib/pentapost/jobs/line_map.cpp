#include "pentapost/jobs/line_map.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace pentapost::jobs {
namespace {

using path::Block;

bool is_arc(const Block& block) {
  return block.kind == Block::Kind::arc_clockwise ||
         block.kind == Block::Kind::arc_counterclockwise;
}

LineMap::Kind kind_of(const Block& block) {
  if (!block.on_path) return LineMap::Kind::off_path;
  switch (block.kind) {
    case Block::Kind::rapid:
      return LineMap::Kind::rapid;
    case Block::Kind::line:
      return LineMap::Kind::line;
    case Block::Kind::arc_clockwise:
    case Block::Kind::arc_counterclockwise:
      return LineMap::Kind::arc;
    case Block::Kind::drill:
      return LineMap::Kind::hole;
  }
  throw std::logic_error{"kind_of: no such block"};
}

std::uint32_t cl_line_of(const path::ToolPath& tool_path, const Block& block) {
  return block.point < tool_path.size() ? tool_path.cl_line[block.point] : 0;
}

}  // namespace

LineMap line_map(const path::Motion& motion, const path::ToolPath& tool_path,
                 std::span<const std::uint32_t> nc_lines) {
  if (nc_lines.size() != motion.blocks.size())
    throw std::logic_error{"line_map: not one line a block"};
  LineMap map;
  map.nc_line.assign(nc_lines.begin(), nc_lines.end());
  for (const Block& block : motion.blocks) {
    map.cl_line.push_back(cl_line_of(tool_path, block));
    map.fraction.push_back(block.fraction);
    map.kind.push_back(kind_of(block));
  }
  return map;
}

std::vector<InsertedStretch> inserted_stretches(const path::Motion& motion,
                                                const path::ToolPath& tool_path) {
  using Reason = InsertedStretch::Reason;
  std::vector<InsertedStretch> stretches;
  std::uint32_t last_point = 0;
  const auto add = [&](const Block& first, std::uint64_t points, Reason reason) {
    const std::uint32_t line = cl_line_of(tool_path, first);
    const bool goes_on =
        !stretches.empty() && stretches.back().reason == reason && first.point <= last_point + 1;
    if (!goes_on) stretches.push_back({.from_cl_line = line, .reason = reason});
    stretches.back().to_cl_line = line;
    stretches.back().points += points;
    last_point = first.point;
  };
  const std::size_t rotary = 3, words = motion.letters.size();
  const auto& blocks = motion.blocks;
  for (std::size_t i = 0; i < blocks.size();) {
    const Block& first = blocks[i];
    if (!first.on_path) {
      ++i;
      continue;
    }
    std::uint64_t points = 0;
    bool turns = false;
    const Block* before = i > 0 ? &blocks[i - 1] : nullptr;
    for (; i < blocks.size() && blocks[i].point == first.point; ++i) {
      const Block& block = blocks[i];
      if (!block.on_path) continue;
      if (block.fraction != 1.0) ++points;
      for (std::size_t word = rotary; before != nullptr && word < words; ++word)
        turns = turns || block.word[word] != before->word[word];
      before = &block;
    }
    if (points > 0)
      add(first, points,
          is_arc(first) ? Reason::arc_in_parts
          : turns       ? Reason::turning
                        : Reason::arc_as_lines);
  }
  return stretches;
}

}  // namespace pentapost::jobs
