#include "server/json/analysis_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace pentapost::server {
namespace {

using kinematics::SingularityKind;
using RepositioningKind = analysis::Repositioning::Kind;

jobs::PathPlace place(std::uint32_t number) {
  const double s_mm = number + 0.5;
  return {.point = number, .line = number + 1, .s_mm = s_mm, .tip_wp_mm = {s_mm, 0.0, -8.0}};
}

/// A report whose numbers are all different, so that none can stand in for another.
jobs::AnalyseReport report() {
  jobs::AnalyseReport report;
  report.machine_name = "demo";
  report.machine_version = "1.1.0";
  report.machine_sha256 = "aa";
  report.cl_units = "mm";
  report.cl_lines = 11;
  report.cl_points = 12;
  report.points = 13;
  report.length_mm = 14.5;
  report.programmed_time_s = 15.5;
  report.predicted_time_s = 16.5;
  report.repositioning_time_s = 0.75;
  report.closest_approach_deg = 17.5;
  report.peak_ratio = 18.5;
  report.operations = {{.tool_number = 5,
                        .operation = "CUT",
                        .length_mm = 19.5,
                        .programmed_time_s = 20.5,
                        .predicted_time_s = 21.5}};
  report.tools = {{5, {.length_mm = 38.5, .programmed_time_s = 39.5, .predicted_time_s = 40.5}}};
  report.axes = {{.name = "X", .rotary = false, .peak_speed = 0.0, .speed_limit = {}},
                 {.name = "C",
                  .rotary = true,
                  .span = Range<double>{-41.5, 42.5},
                  .peak_speed = 22.5,
                  .asked_speed = 43.5,
                  .amplification = 44.5,
                  .speed_limit = 23.5,
                  .peak_ratio = 24.5,
                  .peak_at = place(30),
                  .peak_acceleration = 45.5,
                  .acceleration_limit = 46.5}};
  report.zones.total = 7;
  report.zones.zones = {
      {.axis = "C",
       .rotary = true,
       .kind = SingularityKind::reach_boundary,
       .from = place(31),
       .to = place(32),
       .closest_deg = 25.5,
       .peak_speed = 26.5,
       .peak_ratio = 27.5,
       .amplification = 47.5,
       .lowest_feed_mm_min = 28.5,
       .programmed_time_s = 48.5,
       .time_lost_s = 29.5,
       .cures = {{.kind = jobs::Cure::Kind::feed,
                  .time_lost_s = 49.5,
                  .peak_ratio = 1.0,
                  .feed_mm_min = 50.5},
                 {.kind = jobs::Cure::Kind::axis_change,
                  .time_lost_s = 51.5,
                  .peak_ratio = 52.5,
                  .axis_change_deg = 53.5},
                 {.kind = jobs::Cure::Kind::solution, .time_lost_s = 54.5, .peak_ratio = 55.5},
                 {.kind = jobs::Cure::Kind::reorientation,
                  .time_lost_s = 56.5,
                  .peak_ratio = 57.5,
                  .theta_x_deg = -58.5,
                  .theta_z_deg = 59.5}}}};
  report.over_demands.total = 8;
  report.over_demands.zones = {
      {.axis = "Y", .from = place(33), .to = place(34), .peak_speed = 0.25}};
  report.repositionings = {{RepositioningKind::turn_in_place, place(35), 0.125},
                           {RepositioningKind::rapid, place(36), {}},
                           {RepositioningKind::retract, place(37), {}}};
  report.singular_directions = {{SingularityKind::pole, Vec3::UnitZ(), 0.0}};
  return report;
}

TEST(AnalysisJson, HasTheNamesOfTheContract) {
  EXPECT_EQ(
      analysis_json(report()),
      R"({"machine":{"name":"demo","version":"1.1.0","sha256":"aa"},)"
      R"("cl":{"lines":11,"points":12,"units":"mm"},)"
      R"("summary":{"points":13,"length_mm":14.5,"programmed_time_s":15.5,"predicted_time_s":16.5,)"
      R"("repositioning_time_s":0.75,)"
      R"("closest_approach_deg":17.5,"peak_ratio":18.5},)"
      R"("operations":[{"tool":5,"operation":"CUT","length_mm":19.5,"programmed_time_s":20.5,)"
      R"("predicted_time_s":21.5}],)"
      R"("tools":{"5":{"length_mm":38.5,"programmed_time_s":39.5,"predicted_time_s":40.5}},)"
      R"("axes":{"X":{"peak_mm_s":0},"C":{"min_deg":-41.5,"max_deg":42.5,"peak_deg_s":22.5,)"
      R"("asked_deg_s":43.5,"amplification":44.5,"limit_deg_s":23.5,"peak_deg_s2":45.5,)"
      R"("limit_deg_s2":46.5,"peak_ratio":24.5,)"
      R"("peak_at":{"point":30,"cl_line":31,"s_mm":30.5,"tip_mm":[30.5,0,-8]}}},)"
      R"("zones":[{"kind":"reach-boundary","axis":"C",)"
      R"("from":{"point":31,"cl_line":32,"s_mm":31.5,"tip_mm":[31.5,0,-8]},)"
      R"("to":{"point":32,"cl_line":33,"s_mm":32.5,"tip_mm":[32.5,0,-8]},"closest_deg":25.5,)"
      R"("peak_deg_s":26.5,"peak_ratio":27.5,"amplification":47.5,"lowest_feed_mm_min":28.5,)"
      R"("programmed_time_s":48.5,"time_lost_s":29.5,)"
      R"("cures":[{"kind":"feed","feed_mm_min":50.5,"peak_ratio":1,"time_lost_s":49.5},)"
      R"({"kind":"axis-change","pole_axis_deg":53.5,"peak_ratio":52.5,"time_lost_s":51.5},)"
      R"({"kind":"solution","peak_ratio":55.5,"time_lost_s":54.5},)"
      R"({"kind":"reorientation","theta_x_deg":-58.5,"theta_z_deg":59.5,"peak_ratio":57.5,)"
      R"("time_lost_s":56.5}]}],"zones_total":7,)"
      R"("over_demands":[{"axis":"Y",)"
      R"("from":{"point":33,"cl_line":34,"s_mm":33.5,"tip_mm":[33.5,0,-8]},)"
      R"("to":{"point":34,"cl_line":35,"s_mm":34.5,"tip_mm":[34.5,0,-8]},)"
      R"("peak_mm_s":0.25,"peak_ratio":0,"lowest_feed_mm_min":0,"programmed_time_s":0,)"
      R"("time_lost_s":0}],"over_demands_total":8,)"
      R"("repositionings":[{"kind":"turn-in-place",)"
      R"("at":{"point":35,"cl_line":36,"s_mm":35.5,"tip_mm":[35.5,0,-8]},"time_s":0.125},)"
      R"({"kind":"rapid","at":{"point":36,"cl_line":37,"s_mm":36.5,"tip_mm":[36.5,0,-8]}},)"
      R"({"kind":"retract","at":{"point":37,"cl_line":38,"s_mm":37.5,"tip_mm":[37.5,0,-8]}}],)"
      R"("repositionings_total":3,)"
      R"("singular_directions":[{"kind":"pole","direction":[0,0,1],"half_angle_deg":0}],)"
      R"("diagnostics":[],"diagnostics_total":0})");
}

/// Two places of a path, the second at a singularity.
TEST(AnalysisJson, HasSamplesInColumns) {
  auto sampled = report();
  sampled.samples = jobs::SampleColumns{
      .s_mm = {1.0, 2.0},
      .feed_mm_min = {3.0, 4.0},
      .line = {5, 6},
      .goes_on = {false, true},
      .amplification = {7.0, {}},
      .axis = {Vec3::UnitX(), Vec3::UnitZ()},
      .axes = {{.name = "X", .position = {}, .speed = {8.0, 9.0}, .acceleration = {10.0, {}}},
               {.name = "C",
                .rotary = true,
                .position = {11.0, 12.0},
                .speed = {13.0, 14.0},
                .acceleration = {15.0, {}}}}};
  EXPECT_NE(analysis_json(sampled).find(
                R"("samples":{"s_mm":[1,2],"cl_line":[5,6],"goes_on":[false,true],)"
                R"("feed_mm_min":[3,4],"amplification":[7,null],)"
                R"("axis_vectors":[[1,0,0],[0,0,1]],"axes":{)"
                R"("X":{"speed_mm_s":[8,9],"acceleration_mm_s2":[10,null]},)"
                R"("C":{"position_deg":[11,12],"speed_deg_s":[13,14],)"
                R"("acceleration_deg_s2":[15,null]}}})"),
            std::string::npos);
}

TEST(AnalysisJson, HoldsAHundredRepositioningsAndCountsAll) {
  auto many = report();
  many.repositionings.assign(101, {RepositioningKind::rapid, place(50), {}});
  const auto text = analysis_json(many);
  std::size_t count = 0;
  for (auto at = text.find("\"rapid\""); at != std::string::npos;
       at = text.find("\"rapid\"", at + 1))
    ++count;
  EXPECT_EQ(count, 100U);
  EXPECT_NE(text.find(R"("repositionings_total":101)"), std::string::npos);
}

TEST(AnalysisJson, NeverWritesANumberThatIsNotFinite) {
  auto broken = report();
  broken.peak_ratio = std::numeric_limits<double>::infinity();
  EXPECT_THROW(analysis_json(broken), std::logic_error);
}

}  // namespace
}  // namespace pentapost::server
