#include "sample_server.hpp"
#include "server/json/job_json.hpp"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

namespace pentapost::server {
namespace {

Result<jobs::ReorientJob> read_parts(JobParts parts) {
  static const auto machines = sample::library();
  const auto dialects = dialect_names();
  return read_reorient_job(std::move(parts), {.machines = machines, .dialects = dialects});
}

Result<jobs::ReorientJob> read_with(const std::string& members) {
  return read_parts({.json = R"({"machine": "demo", "cl": "GOTO/1,2,3")" +
                             (members.empty() ? "" : ", " + members) + "}"});
}

TEST(ReorientJobJson, HasTheDefaultsOfTheContract) {
  const auto job = read_with("");
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->objective, jobs::Objective::peak_ratio);
  EXPECT_EQ(job->max_tilt_deg, 30.0);
  EXPECT_EQ(job->setup_accuracy_deg, 0.02);
  EXPECT_EQ(job->map_step_deg, 2.0);
  EXPECT_FALSE(job->theta_x.step_deg || job->theta_z.step_deg || job->origin_mm);
  EXPECT_TRUE(job->theta_x.allowed_deg.empty() && job->theta_z.allowed_deg.empty());
  EXPECT_TRUE(job->forbidden.empty() && job->candidates.empty());
}

TEST(ReorientJobJson, ReadsEveryKey) {
  const auto job = read_with(R"(
    "setup": {"origin_mm": [1, 2, 3], "theta_x_deg": 4}, "tolerances": {"axis_deg": 0.5},
    "objective": "rotary_travel", "max_tilt_deg": 180, "setup_accuracy_deg": 0,
    "step_deg": {"theta_x_deg": 5}, "allowed_deg": {"theta_z_deg": [0, 90.5, -360]},
    "forbidden_deg": [{"theta_x_deg": [-1, 1]}, {"theta_x_deg": [7, 7], "theta_z_deg": [8, 9]}],
    "candidates": [{"theta_x_deg": -10}, {"theta_x_deg": 10, "theta_z_deg": 20}],
    "origin_bounds_mm": {"min": [-1, -2, -3], "max": [1, -2, 3]}, "map": {"step_deg": 0.25})");
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(std::get<jobs::ClText>(job->job.path).text, "GOTO/1,2,3");
  EXPECT_EQ(job->job.setup.origin_mm, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(job->job.setup.theta_x_deg, 4.0);
  EXPECT_EQ(job->job.tolerances.axis_deg, 0.5);
  EXPECT_EQ(job->objective, jobs::Objective::rotary_travel);
  EXPECT_EQ(job->max_tilt_deg, 180.0);
  EXPECT_EQ(job->setup_accuracy_deg, 0.0);
  EXPECT_EQ(job->theta_x.step_deg, 5.0);
  EXPECT_EQ(job->theta_z.step_deg, std::nullopt);
  EXPECT_EQ(job->theta_z.allowed_deg, (std::vector{0.0, 90.5, -360.0}));
  ASSERT_EQ(job->forbidden.size(), 2U);
  EXPECT_EQ(job->forbidden[0].theta_x_deg, (Range<double>{-1.0, 1.0}));
  EXPECT_EQ(job->forbidden[0].theta_z_deg, std::nullopt);
  EXPECT_EQ(job->forbidden[1].theta_x_deg, (Range<double>{7.0, 7.0}));
  EXPECT_EQ(job->forbidden[1].theta_z_deg, (Range<double>{8.0, 9.0}));
  ASSERT_EQ(job->candidates.size(), 2U);
  EXPECT_EQ(job->candidates[0].theta_x_deg, -10.0);
  EXPECT_EQ(job->candidates[0].theta_z_deg, 0.0);
  EXPECT_EQ(job->candidates[1].theta_x_deg, 10.0);
  EXPECT_EQ(job->candidates[1].theta_z_deg, 20.0);
  ASSERT_TRUE(job->origin_mm);
  EXPECT_EQ((*job->origin_mm)[0], (Range<double>{-1.0, 1.0}));
  EXPECT_EQ((*job->origin_mm)[1], (Range<double>{-2.0, -2.0}));
  EXPECT_EQ((*job->origin_mm)[2], (Range<double>{-3.0, 3.0}));
  EXPECT_EQ(job->map_step_deg, 0.25);
}

TEST(ReorientJobJson, TakesOneStepForBothAngles) {
  const auto job = read_with(R"("step_deg": 2.5)");
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->theta_x.step_deg, 2.5);
  EXPECT_EQ(job->theta_z.step_deg, 2.5);
}

TEST(ReorientJobJson, HasAMapUnlessItIsRefused) {
  EXPECT_EQ(read_with(R"("map": true)").value().map_step_deg, 2.0);
  EXPECT_EQ(read_with(R"("map": {})").value().map_step_deg, 2.0);
  EXPECT_EQ(read_with(R"("map": null)").value().map_step_deg, 2.0);
  EXPECT_EQ(read_with(R"("map": false)").value().map_step_deg, std::nullopt);
}

TEST(ReorientJobJson, TakesWords) {
  const auto job = read_parts({.cl = "x",
                               .words = {{"machine", "demo"},
                                         {"objective", "time"},
                                         {"max_tilt_deg", "12.5"},
                                         {"setup_accuracy_deg", "0"}}});
  ASSERT_TRUE(job) << job.error().message;
  EXPECT_EQ(job->objective, jobs::Objective::time);
  EXPECT_EQ(job->max_tilt_deg, 12.5);
  EXPECT_EQ(job->setup_accuracy_deg, 0.0);
  EXPECT_EQ(std::get<jobs::ClText>(job->job.path).text, "x");
}

TEST(ReorientJobJson, RefusesWordsOutsideTheirDomain) {
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"objective", "speed"},
                                                        {"max_tilt_deg", "-0.5"},
                                                        {"max_tilt_deg", "180.5"},
                                                        {"setup_accuracy_deg", "-0.01"},
                                                        {"setup_accuracy_deg", "5.01"},
                                                        {"setup_accuracy_deg", ""}}) {
    const auto job = read_parts({.cl = "x", .words = {{"machine", "demo"}, {name, text}}});
    ASSERT_FALSE(job) << name << " " << text;
    EXPECT_EQ(job.error().code, Code::out_of_domain) << name << " " << text;
    EXPECT_EQ(job.error().pointer, "/" + name) << text;
  }
}

TEST(ReorientJobJson, HasNoWordsOfAnAnalysis) {
  const auto job = read_parts({.cl = "x", .words = {{"machine", "demo"}, {"zone_share", "1"}}});
  ASSERT_FALSE(job);
  EXPECT_EQ(job.error().code, Code::unknown_key);
}

TEST(ReorientJobJson, LeavesItsWordsToNoOtherJob) {
  static const auto machines = sample::library();
  const auto dialects = dialect_names();
  const JobContext context{.machines = machines, .dialects = dialects};
  const JobParts parts{.cl = "x", .words = {{"machine", "demo"}, {"objective", "time"}}};
  for (const auto& problem :
       {read_post_job(parts, context).error(), read_analyse_job(parts, context).error()}) {
    EXPECT_EQ(problem.code, Code::unknown_key);
    EXPECT_EQ(problem.pointer, "/objective");
  }
}

TEST(ReorientJobJson, RefusesAnNcProgram) {
  const auto apart = read_parts({.json = R"({"machine": "demo"})", .nc = "%"});
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().pointer, "/nc");
  EXPECT_EQ(read_parts({.json = R"({"machine": "demo", "nc": "%"})"}).error().pointer, "/nc");
}

TEST(ReorientJobJson, RefusesWithThePlace) {
  std::string many = "0";
  for (int i = 0; i < 10'000; ++i) many += ",0";
  std::string many_setups = "{}";
  for (int i = 0; i < 1000; ++i) many_setups += ",{}";
  std::string many_ranges = R"({"theta_x_deg": [0, 1]})";
  for (int i = 0; i < 100; ++i) many_ranges += R"(,{"theta_x_deg": [0, 1]})";
  for (const auto& [members, code, pointer] :
       std::vector<std::tuple<std::string, Code, std::string>>{
           {R"("objectives": "time")", Code::unknown_key, "/objectives"},
           {R"("objective": "fast")", Code::out_of_domain, "/objective"},
           {R"("objective": 1)", Code::wrong_type, "/objective"},
           {R"("max_tilt_deg": -0.5)", Code::out_of_domain, "/max_tilt_deg"},
           {R"("max_tilt_deg": 180.1)", Code::out_of_domain, "/max_tilt_deg"},
           {R"("max_tilt_deg": "30")", Code::wrong_type, "/max_tilt_deg"},
           {R"("setup_accuracy_deg": -1)", Code::out_of_domain, "/setup_accuracy_deg"},
           {R"("setup_accuracy_deg": 5.1)", Code::out_of_domain, "/setup_accuracy_deg"},
           {R"("step_deg": "5")", Code::wrong_type, "/step_deg"},
           {R"("step_deg": 0)", Code::out_of_domain, "/step_deg"},
           {R"("step_deg": 361)", Code::out_of_domain, "/step_deg"},
           {R"("step_deg": {"theta_z_deg": 0.0001})", Code::out_of_domain, "/step_deg/theta_z_deg"},
           {R"("step_deg": {"theta_y_deg": 5})", Code::unknown_key, "/step_deg/theta_y_deg"},
           {R"("allowed_deg": [0])", Code::wrong_type, "/allowed_deg"},
           {R"("allowed_deg": {"theta_x_deg": 5})", Code::wrong_type, "/allowed_deg/theta_x_deg"},
           {R"("allowed_deg": {"theta_x_deg": []})", Code::out_of_domain,
            "/allowed_deg/theta_x_deg"},
           {R"("allowed_deg": {"theta_x_deg": ["0"]})", Code::wrong_type,
            "/allowed_deg/theta_x_deg/0"},
           {R"("allowed_deg": {"theta_x_deg": [0, 360.5]})", Code::out_of_domain,
            "/allowed_deg/theta_x_deg"},
           {R"("allowed_deg": {"theta_z_deg": [)" + many + "]}", Code::out_of_domain,
            "/allowed_deg/theta_z_deg"},
           {R"("allowed_deg": {"theta_y_deg": [0]})", Code::unknown_key,
            "/allowed_deg/theta_y_deg"},
           {R"("step_deg": 5, "allowed_deg": {"theta_x_deg": [0]})", Code::conflicting_keys,
            "/allowed_deg/theta_x_deg"},
           {R"("step_deg": {"theta_z_deg": 5}, "allowed_deg": {"theta_z_deg": [0]})",
            Code::conflicting_keys, "/allowed_deg/theta_z_deg"},
           {R"("forbidden_deg": {})", Code::wrong_type, "/forbidden_deg"},
           {R"("forbidden_deg": [{}])", Code::missing_key, "/forbidden_deg/0"},
           {R"("forbidden_deg": [{"theta_x_deg": [1]}])", Code::wrong_type,
            "/forbidden_deg/0/theta_x_deg"},
           {R"("forbidden_deg": [{"theta_x_deg": [2, 1]}])", Code::out_of_domain,
            "/forbidden_deg/0/theta_x_deg"},
           {R"("forbidden_deg": [{"theta_x_deg": [0, 1]}, {"theta_z_deg": [0, 361]}])",
            Code::out_of_domain, "/forbidden_deg/1/theta_z_deg"},
           {R"("forbidden_deg": [{"theta_x_deg": [0, 1], "from": 0}])", Code::unknown_key,
            "/forbidden_deg/0/from"},
           {R"("forbidden_deg": [)" + many_ranges + "]", Code::out_of_domain, "/forbidden_deg"},
           {R"("origin_bounds_mm": [])", Code::wrong_type, "/origin_bounds_mm"},
           {R"("origin_bounds_mm": {"min": [0, 0, 0]})", Code::missing_key,
            "/origin_bounds_mm/max"},
           {R"("origin_bounds_mm": {"min": [0, 0], "max": [1, 1, 1]})", Code::wrong_type,
            "/origin_bounds_mm/min"},
           {R"("origin_bounds_mm": {"min": [0, 0, 0], "max": [1, 1, 1000001]})",
            Code::out_of_domain, "/origin_bounds_mm/max"},
           {R"("origin_bounds_mm": {"min": [0, 2, 0], "max": [1, 1, 1]})", Code::out_of_domain,
            "/origin_bounds_mm"},
           {R"("origin_bounds_mm": {"min": [0, 0, 0], "max": [1, 1, 1], "step": 1})",
            Code::unknown_key, "/origin_bounds_mm/step"},
           {R"("candidates": {"theta_x_deg": 1})", Code::wrong_type, "/candidates"},
           {R"("candidates": [1])", Code::wrong_type, "/candidates/0"},
           {R"("candidates": [{}, {"theta_x_deg": 361}])", Code::out_of_domain,
            "/candidates/1/theta_x_deg"},
           {R"("candidates": [{"x": 1}])", Code::unknown_key, "/candidates/0/x"},
           {R"("candidates": [)" + many_setups + "]", Code::out_of_domain, "/candidates"},
           {R"("map": 2)", Code::wrong_type, "/map"},
           {R"("map": {"step_deg": 0.2})", Code::out_of_domain, "/map/step_deg"},
           {R"("map": {"step_deg": 46})", Code::out_of_domain, "/map/step_deg"},
           {R"("map": {"step": 2})", Code::unknown_key, "/map/step"},
           {R"("zone_share": 1)", Code::unknown_key, "/zone_share"},
           {R"("samples": true)", Code::unknown_key, "/samples"}}) {
    const std::string shown = members.substr(0, 80);
    const auto job = read_with(members);
    ASSERT_FALSE(job) << shown;
    EXPECT_EQ(row_of(job.error().code).name, row_of(code).name) << shown;
    EXPECT_EQ(job.error().pointer, pointer) << shown;
  }
}

}  // namespace
}  // namespace pentapost::server
