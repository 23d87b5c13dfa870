#include "server/json/report_json.hpp"

#include "sample_server.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace pentapost::server {
namespace {

TEST(ReportJson, HasTheNamesOfTheContract) {
  const std::string a(64, 'a');
  const std::string c(64, 'c');
  EXPECT_EQ(
      report_json(sample::report()),
      R"({"machine":{"name":"demo","version":"1.1.0","sha256":")" + a +
          R"("},"dialect":"fanuc-30i","output":"axes","cl":{"sha256":")" + c +
          R"(","dialect":"nx","lines":11,"points":12,"units":"inch"},"blocks":13,"length_mm":15.5,)"
          R"("programmed_time_s":16.25,"predicted_time_s":17.25,"axes":{"A":{"unit":"deg","min":-1.5,"max":2.5,)"
          R"("range":[-110,110],"speed_limit":150},"X":{"unit":"mm","min":3.5,"max":4.5}},)"
          R"("zones":[{"kind":"pole","axis":"C",)"
          R"("from":{"point":20,"cl_line":21,"s_mm":22.5,"tip_mm":[1,2,3]},)"
          R"("to":{"point":23,"cl_line":24,"s_mm":25.5,"tip_mm":[4,5,6]},"peak_deg_s":26.5,)"
          R"("peak_ratio":27.5,"lowest_feed_mm_min":28.5,"programmed_time_s":29.5,)"
          R"("time_lost_s":30.5,"cures":[]}],"zones_total":1,)"
          R"("over_demands":[],"over_demands_total":0,)"
          R"("inserted_points":14,"insertions":[{"from_cl_line":18,"to_cl_line":19,"points":14,)"
          R"("reason":"arc_as_lines"}],"insertions_total":1,"pole_axis_change_deg":0.125,)"
          R"("pole_bends":[{"cl_line":16,"change_deg":0.0625}],)"
          R"("retracts":[{"cl_line":17,"reason":"C is wound up"}],)"
          R"("verification":{"passed":true,"tip_deviation_mm":0.0078125,)"
          R"("axis_deviation_deg":0.03125,"blocks_read":18},)"
          R"("lint":[{"nc_line":7,"rule":"long_line","message":"too long"}],"lint_total":8,)"
          R"("line_map":{"nc_line":[5,6],"cl_line":[0,18],"fraction":[1,0.5],)"
          R"("kind":["off_path","arc"]},)"
          R"("diagnostics":[{"severity":"warning","code":"unit_assumed","cl_line":19,)"
          R"("message":"mm were assumed"}],"diagnostics_total":1})");
}

TEST(ReportJson, NeverWritesANumberThatIsNotFinite) {
  auto report = sample::report();
  report.length_mm = std::nan("");
  EXPECT_THROW(report_json(report), std::logic_error);
}

TEST(PostAnswerJson, HoldsTheProgramAsItIs) {
  const auto text = post_answer_json(sample::report());
  EXPECT_TRUE(text.starts_with(R"({"nc":"%\nO1 (A \"B\\C\")\nM30\n%\n","report":{"machine")"))
      << text;
}

}  // namespace
}  // namespace pentapost::server
