#include "pentapost/verify/witness.hpp"

#include "pentapost/core/number_text.hpp"

#include <string>

namespace pentapost::verify {
namespace {

std::string place_text(std::uint32_t point, double fraction) {
  return "CL point " + std::to_string(point + 1) + ", fraction " + number_text(fraction);
}

Problem out_of_order(std::uint32_t point, double fraction, const path::Block& block) {
  return {Code::proof_failed, "The path is at " + place_text(point, fraction) +
                                  ", but the block goes on to " +
                                  place_text(block.point, block.fraction)};
}

}  // namespace

Result<Covered> Coverage::advance(const path::Block& block) {
  if (block.point >= points_)
    return Problem{Code::proof_failed, "The block belongs to CL point " +
                                           std::to_string(block.point + 1) + " of " +
                                           std::to_string(points_)};
  if (!(block.fraction > 0.0 && block.fraction <= 1.0))
    return Problem{Code::proof_failed, "The block ends at fraction " + number_text(block.fraction) +
                                           " of its CL move, expected is 0 < fraction <= 1"};
  const bool goes_on = entered_ && block.point == point_ && block.fraction > fraction_;
  // A program may enter the path at point 0 without a block of its own: the replay holds the
  // position of the tool against the point.
  const std::uint32_t next = entered_ ? point_ + 1 : 1;
  const bool is_next = fraction_ == 1.0 && block.point == next;
  const bool is_first = !entered_ && block.point == 0 && block.fraction == 1.0;
  if (!goes_on && !is_next && !is_first) return out_of_order(point_, fraction_, block);

  const Covered covered{block.point, goes_on ? fraction_ : 0.0, block.fraction};
  entered_ = true;
  point_ = block.point;
  fraction_ = block.fraction;
  return covered;
}

Status Coverage::finish() const {
  if (points_ == 0) return ok();
  if (entered_ && point_ + 1 == points_ && fraction_ == 1.0) return ok();
  return Problem{Code::proof_failed, "The program ends at " + place_text(point_, fraction_) +
                                         ", but the CL path has " + std::to_string(points_) +
                                         " points"};
}

}  // namespace pentapost::verify
