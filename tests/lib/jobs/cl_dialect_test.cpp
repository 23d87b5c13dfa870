#include "job_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost::jobs {
namespace {

PostJob job_with_dialect(const std::string& name) {
  PostJob job = sample::cl_job("generic-3axis", sample::cl_program("GOTO/0,0,0\nGOTO/1,0,0\n"));
  std::get<ClText>(job.path).dialect = name;
  return job;
}

TEST(ClDialectOfAJob, IsTakenByItsName) {
  const auto report = post(job_with_dialect("creo-ncl"));

  ASSERT_TRUE(report.has_value()) << report.error().message;
  EXPECT_EQ(report->cl_dialect, "creo-ncl");
}

TEST(ClDialectOfAJob, IsRefusedWithItsPlaceItselfAndTheKnownOnes) {
  const auto report = post(job_with_dialect("nx"));

  ASSERT_FALSE(report.has_value());
  EXPECT_EQ(report.error().code, Code::unknown_dialect);
  EXPECT_EQ(report.error().pointer, "/cl_dialect");
  EXPECT_EQ(report.error().message,
            R"(found "nx", expected one of nx-clsf, catia-apt, creo-ncl, makino-aptcl, )"
            "solidworks-cam-clt, solidworks-cam-apt, nccs-apt, fusion-apt, apt");
}

}  // namespace
}  // namespace pentapost::jobs
