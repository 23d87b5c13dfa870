#include "lib/jobs/random_job.hpp"

#include "pentapost/plan/branches.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace pentapost {
namespace {

/// What a machine cannot do, or a job lacks. Anything else is a defect.
bool is_fitting(Code code) {
  static const std::set<Code> fitting{Code::out_of_reach,
                                      Code::rotary_range,
                                      Code::linear_range,
                                      Code::linear_singular,
                                      Code::half_turn,
                                      Code::no_feed,
                                      Code::tolerance_below_digits,
                                      Code::gauge_length_missing,
                                      Code::no_rotary_feed,
                                      Code::out_of_domain};
  return fitting.contains(code);
}

TEST(RandomPaths, PostWithAProofOrSayWhatCannotBeDone) {
  const auto machines = sample::bundled_machines();
  int posted_count = 0, retracting_count = 0;
  for (std::uint64_t seed = 0; seed < 5000; ++seed) {
    const sample::RandomJob random{seed, machines};
    const auto posted = jobs::post(random.job());
    if (posted) {
      EXPECT_TRUE(posted->verification.passed);
      ++posted_count;
      if (!posted->retracts.empty()) ++retracting_count;
      continue;
    }
    EXPECT_TRUE(is_fitting(posted.error().code))
        << "seed " << seed << ": " << posted.error().message;
    EXPECT_FALSE(posted.error().message.empty()) << "seed " << seed;
  }
  EXPECT_GT(posted_count, 1500);
  EXPECT_GT(retracting_count, 100);
}

/// A walk of the joints within their ranges, with the first axis at rest where the branches meet
/// and the pole itself as a point: the joints show that the path needs no retract.
class JointWalk {
 public:
  explicit JointWalk(std::uint64_t seed, const std::vector<sample::BundledMachine>& machines)
      : random_{seed}, job_{sample::RandomJob{seed, machines}.job()}, model_{job_.machine.chain} {
    job_.setup = {};
    job_.tolerances = {.tip_mm = 0.05, .axis_deg = 0.1};
    job_.post.flank = false;
    job_.gauge_length_mm = {{1, 100.0}};
    job_.limits.clear();
    for (const auto& name : model_.rotary_names) job_.limits[name].max_speed = 1.0;
  }
  bool has_two_axes() const { return model_.rotary_count == 2; }

  jobs::PostJob job() {
    const auto ranges = plan::joint_ranges(job_.machine.chain, model_);
    const Range<double> first = inner(ranges.rotary_rad[0]), second = inner(ranges.rotary_rad[1]);
    double first_rad = real(first.lower, first.upper),
           second_rad = real(second.lower, second.upper);
    double first_step = real(-0.15, 0.15), second_step = real(-0.1, 0.1);
    jobs::PointPath path{.feed_mm_min = 1000.0, .tip_mm = {}, .axis = {}};
    Vec3 tip_mm = Vec3::Zero();
    const int count = 20 + static_cast<int>(real(0.0, 200.0));
    for (int i = 0; i < count; ++i) {
      path.tip_mm.push_back(tip_mm);
      path.axis.push_back(kinematics::forward_axis(model_, first_rad, second_rad));
      tip_mm += Vec3{real(-1, 1), real(-1, 1), real(-1, 1)};
      if (real(0.0, 1.0) < 0.05) {
        first_step = real(-0.15, 0.15);
        second_step = real(-0.1, 0.1);
      }
      if (!first.contains(first_rad + first_step)) first_step = -first_step;
      if (!second.contains(second_rad + second_step)) second_step = -second_step;
      double next_rad = second_rad + second_step;
      const bool near_end = to_end(next_rad) < 0.15 || to_end(second_rad) < 0.15;
      if (near_end && !is_pole(next_rad) && to_end(next_rad) < to_end(second_rad)) {
        second_step = -second_step;
        next_rad = second_rad;
      }
      if (near_end && opening(second_rad) * opening(next_rad) < 0.0)
        next_rad =
            second_rad - (std::abs(opening(second_rad)) < 1.0
                              ? opening(second_rad)
                              : opening(second_rad) - std::copysign(pi, opening(second_rad)));
      if (!near_end) first_rad += first_step;
      second_rad = next_rad;
    }
    job_.path = path;
    return job_;
  }

 private:
  double real(double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random_);
  }
  /// A part of the range at a little distance from its ends, two turns at most.
  Range<double> inner(const std::optional<Range<double>>& range) {
    Range<double> part = range.value_or(Range<double>{-20.0, 20.0});
    part = {part.lower + 0.03, part.upper - 0.03};
    if (part.upper - part.lower <= 12.0) return part;
    const double middle = real(part.lower + 6.0, part.upper - 6.0);
    return {middle - 6.0, middle + 6.0};
  }
  double opening(double second_rad) const {
    return std::remainder(second_rad - model_.beta_zero_rad, 2.0 * pi);
  }
  double to_end(double second_rad) const {
    const double size = std::abs(opening(second_rad));
    return std::min(size, pi - size);
  }
  bool is_pole(double second_rad) const {
    constexpr double rounding = 1e-9;
    return std::abs(opening(second_rad)) < 1.0
               ? std::abs(model_.lambda_rad - model_.mu_rad) < rounding
               : std::abs(model_.lambda_rad + model_.mu_rad - pi) < rounding;
  }

  std::mt19937_64 random_;
  jobs::PostJob job_;
  kinematics::Model model_;
};

TEST(RandomPaths, APathThatTheJointsCanFollowNeedsNoRetract) {
  const auto machines = sample::bundled_machines();
  int posted_count = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    JointWalk walk{seed, machines};
    if (!walk.has_two_axes()) continue;
    const auto posted = jobs::post(walk.job());
    if (posted) {
      ++posted_count;
      EXPECT_TRUE(posted->retracts.empty())
          << "seed " << seed << ": " << posted->retracts.front().reason << " at point "
          << posted->retracts.front().cl_line;
      continue;
    }
    const Code code = posted.error().code;
    EXPECT_TRUE(code == Code::tolerance_below_digits || code == Code::linear_singular ||
                code == Code::out_of_domain)
        << "seed " << seed << ": " << posted.error().message;
  }
  EXPECT_GT(posted_count, 1100);
}

}  // namespace
}  // namespace pentapost
