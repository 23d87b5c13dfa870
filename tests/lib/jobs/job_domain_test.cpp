#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace pentapost {
namespace {

jobs::PostJob plain_job() {
  return sample::cl_job("hermle-c600u", sample::cl_program("GOTO/0,0,0,0,0,1\nGOTO/9,0,0,0,0,1\n"));
}

struct Refused {
  std::function<void(jobs::PostJob&)> change;
  std::string pointer, found, limit;
};

TEST(JobDomain, RefusesWithPlaceValueAndLimit) {
  for (const auto& [change, pointer, found, limit] : std::vector<Refused>{
           {[](auto& job) { job.tolerances.tip_mm = 1000.0; }, "/tolerances/tip_mm", "1000", "1"},
           {[](auto& job) { job.tolerances.tip_mm = std::nextafter(1.0, 2.0); },
            "/tolerances/tip_mm", "1.0000000000000002", "1"},
           {[](auto& job) { job.tolerances.tip_mm = 0.0; }, "/tolerances/tip_mm", "0", "1"},
           {[](auto& job) { job.tolerances.tip_mm = std::numeric_limits<double>::quiet_NaN(); },
            "/tolerances/tip_mm", "nan", "1"},
           {[](auto& job) { job.tolerances.axis_deg = 360.0; }, "/tolerances/axis_deg", "360", "5"},
           {[](auto& job) { job.tolerances.axis_deg = -0.1; }, "/tolerances/axis_deg", "-0.1", "5"},
           {[](auto& job) { job.setup.theta_x_deg = 1e9; }, "/setup/theta_x_deg", "1e+09", "360"},
           {[](auto& job) { job.setup.theta_z_deg = -360.5; }, "/setup/theta_z_deg", "-360.5",
            "-360"},
           {[](auto& job) { job.post.pole_axis_deg = 5.5; }, "/post/pole_axis_deg", "5.5", "5"},
           {[](auto& job) { job.post.pole_axis_deg = -0.5; }, "/post/pole_axis_deg", "-0.5",
            "at least 0"},
           {[](auto& job) { job.post.pole_axis_deg = std::numeric_limits<double>::quiet_NaN(); },
            "/post/pole_axis_deg", "nan", "5"},
       }) {
    SCOPED_TRACE(pointer + " " + found);
    auto job = plain_job();
    change(job);
    const auto posted = jobs::post(job);
    ASSERT_FALSE(posted);
    EXPECT_EQ(posted.error().code, Code::out_of_domain);
    EXPECT_EQ(posted.error().pointer, pointer);
    EXPECT_NE(posted.error().message.find("found " + found + ";"), std::string::npos)
        << posted.error().message;
    EXPECT_NE(posted.error().message.find(limit), std::string::npos) << posted.error().message;
  }
}

TEST(JobDomain, TakesTheLimitsThemselves) {
  auto job = plain_job();
  job.tolerances = {.tip_mm = 1.0, .axis_deg = 5.0};
  job.setup.theta_z_deg = -360.0;
  const auto posted = jobs::post(job);
  EXPECT_TRUE(posted) << posted.error().message;
}

TEST(JobDomain, AToleranceBelowTheDigitsNamesItsPlace) {
  auto job = plain_job();
  job.tolerances.axis_deg = 1e-5;
  const auto posted = jobs::post(job);
  ASSERT_FALSE(posted);
  EXPECT_EQ(posted.error().code, Code::tolerance_below_digits);
  EXPECT_EQ(posted.error().pointer, "/tolerances/axis_deg");
}

}  // namespace
}  // namespace pentapost
