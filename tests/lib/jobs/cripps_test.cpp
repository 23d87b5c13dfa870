#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pentapost {
namespace {

/// Motion words of the blocks N80 to N620 of a program of the paper.
std::vector<std::string> paper_blocks(const std::string& file) {
  const std::string text = sample::papers_text(file);
  const auto begin = text.find("N80 "), end = text.find("N630 ");
  return sample::motion_words(text.substr(begin, end - begin));
}

jobs::PostJob cripps_job(const std::string& file) {
  jobs::PostJob job = sample::cl_job("hermle-c600u", sample::papers_text(file));
  job.tolerances.axis_deg = 0.1;
  return job;
}

/// The paper's labels of its appendices are exchanged: Appendix 2 is the original path.
TEST(CrippsAppendix, OriginalPathGivesTheBlocksOfAppendixTwo) {
  const auto posted = jobs::post(cripps_job("cripps-2017-original.cl"));
  ASSERT_TRUE(posted) << posted.error().message;

  const auto expected = paper_blocks("cripps-2017-appendix-2.nc");
  auto found = sample::motion_words(posted->nc);

  ASSERT_EQ(expected.size(), 55U);
  ASSERT_GE(found.size(), expected.size());
  found.erase(found.begin(), found.end() - static_cast<std::ptrdiff_t>(expected.size()));
  EXPECT_EQ(found, expected);
}

TEST(CrippsAppendix, ReorientedPathGivesTheBlocksOfAppendixOne) {
  const auto posted = jobs::post(cripps_job("cripps-2017-reoriented.cl"));
  ASSERT_TRUE(posted) << posted.error().message;

  const auto expected = paper_blocks("cripps-2017-appendix-1.nc");
  auto found = sample::motion_words(posted->nc);

  ASSERT_EQ(expected.size(), 55U);
  ASSERT_GE(found.size(), expected.size());
  found.erase(found.begin(), found.end() - static_cast<std::ptrdiff_t>(expected.size()));
  EXPECT_EQ(found, expected);
}

/// 1 mm blocks leave the great circle by up to 0.0491 deg next to the pole (kinematics of the
/// path), by the digits printed a little more or less.
TEST(CrippsAppendix, ProofMeasuresTheDeviationNextToThePole) {
  const auto posted = jobs::post(cripps_job("cripps-2017-original.cl"));
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_TRUE(posted->verification.passed);
  EXPECT_NEAR(posted->verification.axis_deviation_deg, 0.0491, 0.0007);
  EXPECT_LE(posted->verification.tip_deviation_mm, 1e-9);
}

TEST(CrippsAppendix, ATighterToleranceDividesTheBlocksNextToThePole) {
  jobs::PostJob job = cripps_job("cripps-2017-original.cl");
  job.tolerances.axis_deg = 0.01;
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_GT(posted->inserted_points, 5U);
  EXPECT_LE(posted->verification.axis_deviation_deg, 0.01);
}

}  // namespace
}  // namespace pentapost
