#include "lib/analysis/cut.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace pentapost::analysis {
namespace {

using sample::Cut;
using sample::tilted;

/// A wandering axis, now near the pole and now far from it.
Cut wandering(std::size_t points) {
  Cut cut{"hermle-c600u"};
  std::mt19937_64 random{20261122};
  std::uniform_real_distribution<double> step{-1.0, 1.0};
  double tilt_deg = 20.0, azimuth_deg = 0.0;
  for (std::size_t i = 0; i < points; ++i) {
    tilt_deg = std::clamp(tilt_deg + step(random), 1.0, 60.0);
    azimuth_deg += step(random);
    cut.to(tilted(tilt_deg, azimuth_deg));
  }
  return cut;
}

TEST(Samples, AreAtMostAsManyAsAskedForAndKeepEveryPeak) {
  const Cut cut = wandering(20'000);
  for (const std::size_t most : {std::size_t{100}, std::size_t{777}, std::size_t{5000}}) {
    const PathAnalysis analysis = cut.analysed({.most_samples = most});
    EXPECT_LE(analysis.samples.size(), most);
    EXPECT_GT(analysis.samples.size(), most / 4);
    for (std::size_t i = 0; i < axis_count; ++i) {
      double fastest = 0.0;
      for (const Sample& each : analysis.samples)
        fastest = std::max(fastest, std::abs(each.speed[i]));
      EXPECT_EQ(fastest, analysis.peaks[i].speed) << i << " of " << most;
    }
  }
}

TEST(Samples, AreInOrderFromTheFirstPlaceToNearTheLast) {
  const Cut cut = wandering(3000);
  const auto samples = cut.analysed({.most_samples = 400}).samples;
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples.front().at.s_mm, 0.0);
  EXPECT_GT(samples.back().at.s_mm, 2900.0);
  EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end(), [](const Sample& x, const Sample& y) {
    return x.at.s_mm < y.at.s_mm;
  }));
}

TEST(Samples, OfAShortPathAreAllPlaces) {
  Cut cut{"generic-3axis"};
  for (int i = 0; i < 4; ++i) cut.to(Vec3::UnitZ());
  const auto samples = cut.analysed({.most_samples = Samples::fewest}).samples;
  // two of each of three moves
  ASSERT_EQ(samples.size(), 6U);
  EXPECT_NEAR(samples[3].speed[0], 2000.0 / 60.0, 1e-9);
  EXPECT_NEAR(samples[5].joints[0], 3.0, 1e-12);
}

/// The axes' own way is the truth: a rate is its difference, an acceleration that of the rate.
TEST(Samples, HaveTheSpeedsAndAccelerationsOfTheirOwnPositions) {
  Cut cut{"dmu-50-evolution"};
  cut.settings.origin_mm = {30.0, -20.0, 50.0};
  cut.to(tilted(20.0, 0.0));
  cut.path.add_point({10.0, 5.0, -2.0}, tilted(50.0, 70.0), 3, path::Move::feed);
  const auto samples = cut.analysed({.most_samples = 5000}).samples;
  ASSERT_GT(samples.size(), 20U);
  const double mm_s = 2000.0 / 60.0;
  const auto peak_accelerations = cut.analysed({.most_samples = 5000}).peak_accelerations.value();
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const Sample &from = samples[k - 1], &to = samples[k];
    const double time_s = (to.at.s_mm - from.at.s_mm) / mm_s;
    ASSERT_GT(time_s, 0.0);
    ASSERT_TRUE(from.has_acceleration && to.has_acceleration);
    for (std::size_t i = 0; i < axis_count; ++i) {
      // Corrected trapezoid: what it leaves is of the fifth order in the time.
      const double way = 0.5 * time_s * (from.speed[i] + to.speed[i]) +
                         time_s * time_s / 12.0 * (from.acceleration[i] - to.acceleration[i]);
      EXPECT_NEAR(to.joints[i] - from.joints[i], way,
                  2e-5 * time_s * (1.0 + std::abs(to.speed[i])));
      const double gain = 0.5 * time_s * (from.acceleration[i] + to.acceleration[i]);
      EXPECT_NEAR(to.speed[i] - from.speed[i], gain, 0.01 * time_s * peak_accelerations[i]);
    }
  }
}

TEST(Samples, DoNotGoOnOverARapid) {
  Cut cut{"hermle-c600u"};
  cut.to(tilted(30.0, 0.0));
  cut.to(tilted(31.0, 0.0));
  cut.path.add_point({50.0, 0.0, 0.0}, tilted(40.0, 0.0), 4, path::Move::rapid);
  cut.path.add_point({51.0, 0.0, 0.0}, tilted(41.0, 0.0), 5, path::Move::feed);
  const auto samples = cut.analysed({.most_samples = 1000}).samples;
  EXPECT_EQ(std::count_if(samples.begin(), samples.end(),
                          [](const Sample& each) { return !each.goes_on; }),
            2);
}

TEST(Samples, AreNotTakenWhereNoneAreAskedFor) {
  const PathAnalysis analysis = wandering(10).analysed();
  EXPECT_TRUE(analysis.samples.empty());
  EXPECT_FALSE(analysis.peak_accelerations);
}

/// Of a point at y = z = 100 mm on a table that tilts about X from 30 to 60 deg, the one axis goes
/// to the whole radius at 45 deg, in the middle of the move.
TEST(Spans, HoldTheTurningOfAnAxisInsideAMove) {
  Cut cut{"hermle-c600u"};
  cut.settings.origin_mm = {0.0, 100.0, 100.0};
  cut.path.add_point(Vec3::Zero(), tilted(30.0, -90.0), 2, path::Move::rapid);
  cut.path.add_point({1e-3, 0.0, 0.0}, tilted(60.0, -90.0), 3, path::Move::feed);
  const auto spans = cut.analysed().spans.of_axes();
  ASSERT_TRUE(spans);
  const double radius_mm = std::hypot(100.0, 100.0);
  const double farthest_mm = std::max({std::abs((*spans)[1].lower), std::abs((*spans)[1].upper),
                                       std::abs((*spans)[2].lower), std::abs((*spans)[2].upper)});
  EXPECT_NEAR(farthest_mm, radius_mm, 1e-6);
  EXPECT_NEAR((*spans)[second_axis].upper * deg_per_rad, 60.0, 1e-9);
  EXPECT_NEAR((*spans)[second_axis].lower * deg_per_rad, 30.0, 1e-9);
}

TEST(Spans, CountTheTurnsOfAWoundAxis) {
  Cut cut{"hermle-c600u"};
  for (int i = 0; i <= 100; ++i) cut.to(tilted(30.0, 10.0 * i));
  const auto spans = cut.analysed().spans.of_axes();
  ASSERT_TRUE(spans);
  EXPECT_NEAR(((*spans)[first_axis].upper - (*spans)[first_axis].lower) * deg_per_rad, 1000.0,
              1e-9);
}

}  // namespace
}  // namespace pentapost::analysis
