#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace pentapost {
namespace {

/// Values of B in the cutting blocks, as printed.
std::vector<double> b_words(const std::string& nc) {
  std::vector<double> found;
  for (const std::string& block : sample::motion_words(nc))
    if (block.find('X') != std::string::npos)
      found.push_back(std::strtod(block.c_str() + block.find('B') + 1, nullptr));
  return found;
}

/// My, eq. (5): B = arccos(2 K - 1) on the 45 deg table; K of the five cutting points.
TEST(NutatingTable, TheExampleOfThePaperPostsWithItsB) {
  jobs::PostJob job =
      sample::cl_job("dmu-50-evolution", sample::papers_text("my-nutating-table.cl"));
  job.tolerances = {.tip_mm = 0.1, .axis_deg = 1.0};
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;

  auto b = b_words(posted->nc);
  ASSERT_EQ(b.size(), 8U);
  b.erase(b.begin());  // the way down to the first point
  const double k[] = {0.7668850879, 0.7668850879, 0.7668850879, 0.8164508563,
                      0.8599796455, 0.8974695903, 0.9288638808};
  for (std::size_t i = 0; i < b.size(); ++i)
    EXPECT_NEAR(b[i], std::acos(2.0 * k[i] - 1.0) * deg_per_rad, 0.0005 + 1e-9) << i;
  EXPECT_TRUE(posted->verification.passed);
}

/// As printed: "90,2364093318" makes seven values of the first cutting GOTO, which starts in
/// line 22.
TEST(NutatingTable, TheExampleAsPrintedIsRefusedAtItsFirstDamagedGoto) {
  std::string text = sample::papers_text("my-nutating-table.cl");
  const auto put = [&](const std::string& from, const std::string& to) {
    const auto place = text.find(from);
    ASSERT_NE(place, std::string::npos);
    text.replace(place, from.size(), to);
  };
  put("90.2364093318", "90,2364093318");
  put("95.2743669780", "95,2743669780");
  put("5.000000, MMPM", "5.000000. MMPM");

  const auto posted = jobs::post(sample::cl_job("dmu-50-evolution", text));

  ASSERT_FALSE(posted);
  EXPECT_EQ(posted.error().code, Code::damaged_motion);
  EXPECT_EQ(posted.error().cl_line, 22U);
}

}  // namespace
}  // namespace pentapost
