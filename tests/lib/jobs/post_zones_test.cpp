#include "lib/jobs/job_case.hpp"
#include "pentapost/jobs/analyse.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pentapost {
namespace {

jobs::PostJob cripps_job(const std::string& file = "cripps-2017-original.cl") {
  auto job = sample::cl_job("hermle-c600u", sample::papers_text(file));
  job.tolerances.axis_deg = 0.1;
  return job;
}

jobs::PostReport posted(const jobs::PostJob& job) {
  auto report = jobs::post(job);
  EXPECT_TRUE(report) << report.error().message;
  return report ? *report : jobs::PostReport{};
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char letter) { return letter >= 'a' && letter <= 'z' ? letter - 32 : letter; });
  return text;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(PostZones, AreThoseOfTheAnalysis) {
  const auto report = posted(cripps_job());
  const auto analysis = jobs::analyse({.job = cripps_job()});
  ASSERT_TRUE(analysis);
  ASSERT_EQ(report.zones.zones.size(), 1U);
  const auto &zone = report.zones.zones[0], &expected = analysis->zones.zones.at(0);
  EXPECT_NEAR(zone.from.tip_wp_mm.x(), 21.61, 0.05);
  EXPECT_NEAR(zone.to.tip_wp_mm.x(), 28.39, 0.05);
  EXPECT_NEAR(zone.peak_speed, expected.peak_speed, 1e-9);
  EXPECT_NEAR(zone.time_lost_s, expected.time_lost_s, 1e-9);
  EXPECT_NEAR(report.predicted_time_s.value(), analysis->predicted_time_s, 1e-9);
}

TEST(PostZones, AreNoneInTheReorientedPath) {
  const auto report = posted(cripps_job("cripps-2017-reoriented.cl"));
  EXPECT_TRUE(report.zones.zones.empty());
  EXPECT_NEAR(report.predicted_time_s.value(), report.programmed_time_s, 1e-9);
}

/// The zone begins on the move to X22.
TEST(PostZones, AreWarnedOfInTheProgramWhereTheyBegin) {
  auto job = cripps_job();
  const auto plain = posted(job);
  job.post.zone_comments = true;
  const std::string warning = "POLE: C 1193 OF 150 DEG/S TO CL LINE 75, HOLD 251 MM/MIN";
  for (const char* dialect : {"heidenhain-iso", "fanuc-30i"}) {
    for (const Output output : {Output::tcp, Output::axes}) {
      job.post.dialect = dialect;
      job.post.output = output;
      const auto report = posted(job);
      EXPECT_TRUE(report.verification.passed);
      EXPECT_EQ(count_of(upper(report.nc), warning), 1U) << report.nc;
    }
  }
  job.post.dialect = "heidenhain-iso";
  job.post.output = Output::tcp;
  const std::string nc = upper(posted(job).nc);
  const auto at = nc.find(warning);
  ASSERT_NE(at, std::string::npos);
  EXPECT_LT(nc.find("X+21"), at);
  EXPECT_GT(nc.find("X+22"), at);
  EXPECT_EQ(count_of(upper(plain.nc), "DEG/S"), 0U);
}

/// One long move that passes the pole half way, as joint values in many blocks: the warning stands
/// among them.
TEST(PostZones, AreWarnedOfInsideALongMove) {
  auto job = sample::cl_job("hermle-c600u", sample::cl_program("GOTO/0,0,0,-0.5,0.01,0.866\n"
                                                               "GOTO/60,0,0,0.5,0.01,0.866\n"));
  job.post.zone_comments = true;
  job.post.output = Output::axes;
  const auto report = posted(job);
  ASSERT_EQ(report.zones.total, 1U);
  EXPECT_GT(report.zones.zones[0].from.s_mm, 20.0);
  const auto warning = upper(report.nc).find("POLE: C");
  ASSERT_NE(warning, std::string::npos);
  const auto before = sample::motion_words(report.nc.substr(0, warning)).size();
  const auto all = sample::motion_words(report.nc).size();
  EXPECT_GT(before, 5U);
  EXPECT_LT(before, all / 2 + 1);
}

TEST(PostZones, OfABentPathAreThoseOfTheBentPath) {
  auto job = cripps_job();
  job.post.pole_axis_deg = 1.05;
  const auto report = posted(job);
  EXPECT_EQ(report.pole_bends.size(), 1U);
  EXPECT_TRUE(report.zones.zones.empty());
  EXPECT_NEAR(report.predicted_time_s.value(), report.programmed_time_s, 1e-9);
}

TEST(PostZones, NeedALimit) {
  auto job = cripps_job();
  job.machine.limits.clear();
  job.machine.controller.options["rotary_feed_deg_min"] = 1000.0;
  const auto report = posted(job);
  EXPECT_EQ(report.zones.total, 0U);
  EXPECT_NEAR(report.predicted_time_s.value(), report.programmed_time_s, 1e-9);
}

/// 60 deg in 60 mm past the pole at 0.001 deg: C turns 57296 deg a mm, and 150 deg/s are 0.157
/// mm/min.
TEST(PostZones, AWarningNeverSaysFeedNought) {
  auto job = sample::cl_job("hermle-c600u",
                            sample::cl_program("GOTO/0,0,0,-0.5,0.0000151150,0.8660254037\n"
                                               "GOTO/60,0,0,0.5,0.0000151150,0.8660254037\n"));
  job.tolerances.axis_deg = 0.1;
  job.post.zone_comments = true;
  const auto report = posted(job);
  EXPECT_NE(upper(report.nc).find("HOLD 0.157 MM/MIN"), std::string::npos) << report.nc;
}

}  // namespace
}  // namespace pentapost
