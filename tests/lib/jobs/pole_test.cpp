#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace pentapost {
namespace {

using sample::span;
using sample::words;

/// A tool axis tilted by `tilt_deg` towards azimuth `azimuth_deg`, as a GOTO at x with 7 digits.
std::string goto_line(double x_mm, double tilt_deg, double azimuth_deg) {
  const double tilt = tilt_deg * rad_per_deg, azimuth = azimuth_deg * rad_per_deg;
  char text[160];
  std::snprintf(text, sizeof text, "GOTO/%.4f,0.0,0.0,%.7f,%.7f,%.7f\n", x_mm,
                std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                std::cos(tilt));
  return text;
}

TEST(Pole, RoundingNoiseDoesNotTurnC) {
  const std::string noise =
      "GOTO/0,0,0,0.0,0.0,1.0\n"
      "GOTO/1,0,0,0.0000001,0.0,1.0\n"
      "GOTO/2,0,0,-0.0000001,0.0000001,1.0\n"
      "GOTO/3,0,0,0.0,-0.0000001,1.0\n";
  const auto posted = jobs::post(sample::cl_job("hermle-c600u", sample::cl_program(noise)));
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_EQ(span(words(posted->nc, 'C')), 0.0);
  EXPECT_EQ(span(words(posted->nc, 'A')), 0.0);
  EXPECT_LE(posted->pole_axis_change_deg, 1e-5);
  EXPECT_GT(posted->pole_axis_change_deg, 0.0);
}

TEST(Pole, AStraightPathThroughThePoleKeepsCStillOnAnOrthogonalTable) {
  std::string path;
  for (int i = 0; i <= 10; ++i) path += goto_line(i, std::abs(5.0 - i), i < 5 ? 30.0 : 210.0);
  const auto posted = jobs::post(sample::cl_job("hermle-c600u", sample::cl_program(path)));
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_LE(span(words(posted->nc, 'C')), 0.002);
  EXPECT_NEAR(words(posted->nc, 'A').front(), 5.0, 1e-3);
  EXPECT_NEAR(words(posted->nc, 'A').back(), -5.0, 1e-3);
}

/// The same where no CL point lies on the pole: it is inside a move.
TEST(Pole, APathThroughThePoleBetweenTwoPointsKeepsCStill) {
  std::string path;
  for (int i = 0; i < 10; ++i) path += goto_line(i, std::abs(4.5 - i), i < 5 ? 100.0 : 280.0);
  const auto posted = jobs::post(sample::cl_job("hermle-c600u", sample::cl_program(path)));
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_LE(span(words(posted->nc, 'C')), 0.002);
  EXPECT_EQ(posted->inserted_points, 1U);  // the pole itself
}

/// In general dC/dB = -1/2 cos(lambda): -0.354 on a 45 deg table (lib/README.md section 4).
TEST(Pole, OnANutatingTableCTurnsBySlightlyMoreThanAThirdOfB) {
  std::string path;
  for (int i = 0; i <= 8; ++i) path += goto_line(i, 0.1 * std::abs(4.0 - i), i < 4 ? 0.0 : 180.0);
  jobs::PostJob job = sample::cl_job("dmu-80p-duoblock", sample::cl_program(path));
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;

  auto b = words(posted->nc, 'B'), c = words(posted->nc, 'C');
  b.pop_back();  // the way out along the tool axis
  c.pop_back();
  const double slope = (c.back() - c[c.size() - 2]) / (b.back() - b[b.size() - 2]);
  EXPECT_NEAR(std::abs(slope), 0.5 * std::cos(45.0 * rad_per_deg), 0.01);
  EXPECT_LT(span(c), 1.0);
  EXPECT_LT(b.back() * b.front(), 0.0);
}

/// Tilt plane 0.1 deg beside the pole: C turns by 180 deg less twice the angle at which the path
/// is seen from the pole at its ends, and A keeps its sign.
TEST(Pole, APathThatMissesThePoleTurnsCAndNothingFlips) {
  std::string path;
  for (int i = 0; i <= 20; ++i) {
    const double along_deg = -5.0 + 0.5 * i;
    char text[160];
    const double u = along_deg * rad_per_deg, v = 0.1 * rad_per_deg;
    std::snprintf(text, sizeof text, "GOTO/%d.0,0.0,0.0,%.10f,%.10f,%.10f\n", i,
                  std::sin(u) * std::cos(v), std::sin(v), std::cos(u) * std::cos(v));
    path += text;
  }
  const auto posted = jobs::post(sample::cl_job("hermle-c600u", sample::cl_program(path)));
  ASSERT_TRUE(posted) << posted.error().message;

  const double end_azimuth_deg =
      std::atan2(std::sin(0.1 * rad_per_deg),
                 std::sin(5.0 * rad_per_deg) * std::cos(0.1 * rad_per_deg)) *
      deg_per_rad;
  EXPECT_NEAR(span(words(posted->nc, 'C')), 180.0 - 2.0 * end_azimuth_deg, 0.002);
  for (const double a : words(posted->nc, 'A')) EXPECT_GT(a, 0.0);
  EXPECT_LE(posted->verification.axis_deviation_deg, 0.05);
}

TEST(Pole, APathWhollyAtThePoleKeepsCAtTheStartPreference) {
  const auto posted = jobs::post(
      sample::cl_job("hermle-c600u", sample::cl_program("GOTO/0,0,5,0,0,1\nGOTO/9,0,5,0,0,1\n")));
  ASSERT_TRUE(posted) << posted.error().message;

  for (const double c : words(posted->nc, 'C')) EXPECT_EQ(c, 0.0);
}

/// The tool leaves the pole in another direction than it came: C turns in the rapid, not in the
/// cut.
TEST(Pole, CTurnsInTheAirWhereTheStretchAtThePoleHasAnAirMove) {
  const std::string path = goto_line(0, 2, 0) + goto_line(1, 0, 0) + goto_line(2, 0, 0) +
                           "RAPID\n" + goto_line(40, 0, 0) + goto_line(41, 0, 0) +
                           goto_line(42, 2, 60);
  const auto posted = jobs::post(sample::cl_job("hermle-c600u", sample::cl_program(path)));
  ASSERT_TRUE(posted) << posted.error().message;

  const auto c = words(posted->nc, 'C');
  ASSERT_GE(c.size(), 6U);
  const std::size_t n = c.size();
  EXPECT_EQ(c[n - 6], c[n - 4]);                            // cut at the pole before the rapid
  EXPECT_EQ(c[n - 3], c[n - 1]);                            // after it
  EXPECT_NEAR(std::abs(c[n - 3] - c[n - 4]), 60.0, 0.002);  // the rapid itself
}

}  // namespace
}  // namespace pentapost
