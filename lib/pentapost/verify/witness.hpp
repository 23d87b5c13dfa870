#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/path/motion.hpp"
#include "pentapost/path/tool_path.hpp"

#include <cstddef>
#include <cstdint>

namespace pentapost::verify {

/// What a block on the path covers: part of the CL move from point - 1 to point.
/// Point 0 has no move before it: a block that reaches it covers the point alone.
struct Covered {
  std::uint32_t point = 0;
  double from_fraction = 0.0, to_fraction = 1.0;
};

/// Holds the witness to what it claims: that the blocks on the path cover it from the first point
/// to the last, in order and without a gap.
class Coverage {
 public:
  explicit Coverage(std::size_t points) : points_{points} {}

  /// @return Problem proof_failed where the block skips, repeats or goes back.
  Result<Covered> advance(const path::Block& block);
  /// @return Problem proof_failed unless the last CL point was reached.
  Status finish() const;

 private:
  std::size_t points_;
  bool entered_ = false;
  std::uint32_t point_ = 0;  ///< the move that is under way; finished when fraction_ is 1
  double fraction_ = 1.0;
};

}  // namespace pentapost::verify
