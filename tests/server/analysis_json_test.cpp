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
  return {.point = number, .cl_line = number + 1, .s_mm = s_mm, .tip_wp_mm = {s_mm, 0.0, -8.0}};
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
  report.closest_approach_deg = 17.5;
  report.peak_ratio = 18.5;
  report.operations = {{.tool_number = 5,
                        .operation = "CUT",
                        .length_mm = 19.5,
                        .programmed_time_s = 20.5,
                        .predicted_time_s = 21.5}};
  report.axes = {{.name = "X", .rotary = false, .peak_speed = 0.0, .speed_limit = {}},
                 {.name = "C",
                  .rotary = true,
                  .peak_speed = 22.5,
                  .speed_limit = 23.5,
                  .peak_ratio = 24.5,
                  .peak_at = place(30)}};
  report.zones = {{.axis = "C",
                   .rotary = true,
                   .kind = SingularityKind::reach_boundary,
                   .from = place(31),
                   .to = place(32),
                   .closest_deg = 25.5,
                   .peak_speed = 26.5,
                   .peak_ratio = 27.5,
                   .lowest_feed_mm_min = 28.5,
                   .time_lost_s = 29.5}};
  report.over_demands = {{.axis = "Y", .from = place(33), .to = place(34), .peak_speed = 0.25}};
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
      R"("closest_approach_deg":17.5,"peak_ratio":18.5},)"
      R"("operations":[{"tool":5,"operation":"CUT","length_mm":19.5,"programmed_time_s":20.5,)"
      R"("predicted_time_s":21.5}],)"
      R"("axes":{"X":{"peak_mm_s":0},"C":{"peak_deg_s":22.5,"limit_deg_s":23.5,"peak_ratio":24.5,)"
      R"("peak_at":{"point":30,"cl_line":31,"s_mm":30.5,"tip_mm":[30.5,0,-8]}}},)"
      R"("zones":[{"kind":"reach-boundary","axis":"C",)"
      R"("from":{"point":31,"cl_line":32,"s_mm":31.5,"tip_mm":[31.5,0,-8]},)"
      R"("to":{"point":32,"cl_line":33,"s_mm":32.5,"tip_mm":[32.5,0,-8]},"closest_deg":25.5,)"
      R"("peak_deg_s":26.5,"peak_ratio":27.5,"lowest_feed_mm_min":28.5,"time_lost_s":29.5}],)"
      R"("over_demands":[{"axis":"Y",)"
      R"("from":{"point":33,"cl_line":34,"s_mm":33.5,"tip_mm":[33.5,0,-8]},)"
      R"("to":{"point":34,"cl_line":35,"s_mm":34.5,"tip_mm":[34.5,0,-8]},)"
      R"("peak_mm_s":0.25,"peak_ratio":0,"lowest_feed_mm_min":0,"time_lost_s":0}],)"
      R"("repositionings":[{"kind":"turn-in-place",)"
      R"("at":{"point":35,"cl_line":36,"s_mm":35.5,"tip_mm":[35.5,0,-8]},"time_s":0.125},)"
      R"({"kind":"rapid","at":{"point":36,"cl_line":37,"s_mm":36.5,"tip_mm":[36.5,0,-8]}},)"
      R"({"kind":"retract","at":{"point":37,"cl_line":38,"s_mm":37.5,"tip_mm":[37.5,0,-8]}}],)"
      R"("repositionings_total":3,)"
      R"("singular_directions":[{"kind":"pole","direction":[0,0,1],"half_angle_deg":0}],)"
      R"("diagnostics":[],"diagnostics_total":0})");
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
