#include "pentapost/plan/linearise.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/plan/block_bound.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {
namespace {

/// Halvings of a move before its tolerance counts as out of reach.
constexpr int largest_depth = 24;
/// Blocks of one move: far above any real need, so that no input exhausts the memory.
constexpr std::size_t largest_block_count = 1'000'000;

/// A straight block across more of an arc would be nearer to other parts of the arc than its own.
constexpr double largest_sweep_rad = pi / 2.0;

double square(double x) { return x * x; }

struct Place {
  double fraction;
  RotaryPair rotary;
  Posture posture;
};

class Division {
 public:
  Division(const kinematics::Model& model, const Settings& settings, BlockMaker& maker,
           const PlannedMove& move, const MovePart& part, double slack_rad, std::uint32_t cl_line,
           std::vector<Waypoint>& ends)
      : model_{model},
        settings_{settings},
        maker_{maker},
        cl_{move.cl},
        planned_{move.planned()},
        part_{part},
        slack_rad_{slack_rad},
        cl_line_{cl_line},
        ends_{ends} {}

  Status run(const Posture& from) {
    const Place start{part_.fraction_from, part_.from, from};
    auto end = place(part_.fraction_to, part_.to);
    if (!end) return std::move(end).error();
    return divide(start, *end, 0);
  }

 private:
  Result<Place> place(double fraction, const RotaryPair& rotary) {
    const Vec3 tip_mm = cl_.tip_mm(part_.in_place ? part_.fraction_from : fraction);
    auto posture = maker_.posture(tip_mm, rotary, cl_line_);
    if (!posture) return std::move(posture).error();
    return Place{fraction, rotary, *posture};
  }

  Status divide(const Place& from, const Place& to, int depth) {
    const BlockBound bound = bound_block(model_, settings_, maker_, cl_, from.fraction,
                                         from.posture, to.fraction, to.posture);
    const double excess =
        std::max({bound.tip_mm / (tolerance_share * settings_.tip_tolerance_mm),
                  bound.axis_rad / (tolerance_share * settings_.axis_tolerance_rad),
                  square((to.fraction - from.fraction) * cl_.sweep_rad() / largest_sweep_rad)});
    if (excess <= 1.0) {
      ends_.push_back({to.fraction, to.posture});
      if (ends_.size() <= largest_block_count) return ok();
      return Problem{.code = Code::too_large,
                     .message = "the move to CL line " + std::to_string(cl_line_) +
                                " needs more than a million blocks",
                     .cl_line = cl_line_};
    }
    if (depth >= largest_depth) return too_fine(bound);
    return divide_evenly(from, to, excess, depth);
  }

  /// The deviation of a smooth block falls with the square of its length.
  Status divide_evenly(const Place& from, const Place& to, double excess, int depth) {
    const int count = static_cast<int>(std::clamp(std::ceil(std::sqrt(excess)), 2.0, 16.0));
    Place start = from;
    for (int i = 1; i <= count; ++i) {
      Place end = to;
      if (i < count) {
        const double fraction = from.fraction + (to.fraction - from.fraction) * i / count;
        const auto rotary =
            rotary_inside(model_, planned_, part_, fraction, start.rotary, to.rotary, slack_rad_);
        if (!rotary) return out_of_reach();
        auto middle = place(fraction, *rotary);
        if (!middle) return std::move(middle).error();
        end = *std::move(middle);
      }
      if (auto status = divide(start, end, depth + (count > 4 ? 2 : 1)); !status) return status;
      start = end;
    }
    return ok();
  }

  Problem out_of_reach() const {
    return {.code = Code::out_of_reach,
            .message = "the tool axis leaves the reach of the rotary axes in the move to CL line " +
                       std::to_string(cl_line_),
            .cl_line = cl_line_};
  }

  Problem too_fine(const BlockBound& bound) const {
    return {.code = Code::tolerance_below_digits,
            .message = "the move to CL line " + std::to_string(cl_line_) +
                       " keeps the tolerances of " + number_text(settings_.tip_tolerance_mm) +
                       " mm and " + number_text(settings_.axis_tolerance_rad * deg_per_rad, 6) +
                       " deg by no division at the digits printed (" +
                       number_text(bound.tip_mm, 6) + " mm, " +
                       number_text(bound.axis_rad * deg_per_rad, 6) + " deg)",
            .cl_line = cl_line_};
  }

  const kinematics::Model& model_;
  const Settings& settings_;
  BlockMaker& maker_;
  const path::Segment& cl_;
  const path::Segment& planned_;
  const MovePart& part_;
  const double slack_rad_;
  const std::uint32_t cl_line_;
  std::vector<Waypoint>& ends_;
};

}  // namespace

Status linearise(const kinematics::Model& model, const Settings& settings, BlockMaker& maker,
                 const PlannedMove& move, const MovePart& part, const Posture& from,
                 double slack_rad, std::uint32_t cl_line, std::vector<Waypoint>& ends) {
  return Division{model, settings, maker, move, part, slack_rad, cl_line, ends}.run(from);
}

}  // namespace pentapost::plan
