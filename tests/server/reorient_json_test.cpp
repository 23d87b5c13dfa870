#include "server/json/reorient_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace pentapost::server {
namespace {

/// A setup whose numbers are all different, so that none can stand in for another.
jobs::SetupReport setup() {
  jobs::SetupReport report;
  report.setup = {.origin_mm = Vec3{1.5, 2.5, 3.5}, .theta_x_deg = -10.25, .theta_z_deg = 20.5};
  report.twin = jobs::SetupAngles{.theta_x_deg = 10.25, .theta_z_deg = 200.5};
  report.tilt_deg = 10.25;
  report.possible = true;
  report.within_limits = true;
  report.peak_ratio = 0.75;
  report.nominal_peak_ratio = 0.625;
  report.peak_axis = "C";
  report.peak_rotary = true;
  report.peak_speed = 31.5;
  report.peak_at =
      jobs::PathPlace{.point = 41, .line = 42, .s_mm = 43.5, .tip_wp_mm = {44.5, 45.5, 46.5}};
  report.predicted_time_s = 32.5;
  report.programmed_time_s = 33.5;
  report.rotary_travel_deg = 34.5;
  report.repositioning_time_s = 35.5;
  report.retracts = 36;
  report.zones = 37;
  report.closest_approach_deg = 38.5;
  report.singular_directions = {
      {.kind = kinematics::SingularityKind::pole, .direction = Vec3::UnitY()}};
  report.axes = {{.demand = {.name = "A",
                             .rotary = true,
                             .span = Range<double>{-51.5, 52.5},
                             .peak_speed = 53.5,
                             .speed_limit = 54.5,
                             .peak_ratio = 55.5},
                  .range = Range<double>{-110.0, 111.0},
                  .margin = 57.5},
                 {.demand = {.name = "X", .peak_speed = 58.5},
                  .range = Range<double>{-300.0, 301.0},
                  .margin = 59.5}};
  report.instructions = {"turn", "tilt"};
  return report;
}

constexpr std::string_view setup_text =
    R"({"theta_x_deg":-10.25,"theta_z_deg":20.5,)"
    R"("twin":{"theta_x_deg":10.25,"theta_z_deg":200.5},"tilt_deg":10.25,)"
    R"("setup":{"origin_mm":[1.5,2.5,3.5],"theta_x_deg":-10.25,"theta_z_deg":20.5},)"
    R"("possible":true,"within_limits":true,"obstacle":null,"peak_ratio":0.75,)"
    R"("peak_unbounded":false,"nominal_peak_ratio":0.625,)"
    R"("peak":{"axis":"C","deg_s":31.5,)"
    R"("at":{"point":41,"cl_line":42,"s_mm":43.5,"tip_mm":[44.5,45.5,46.5]}},)"
    R"("predicted_time_s":32.5,"programmed_time_s":33.5,"rotary_travel_deg":34.5,)"
    R"("repositioning_time_s":35.5,"retracts":36,"zones":37,"closest_approach_deg":38.5,)"
    R"("singular_directions":[{"kind":"pole","direction":[0,1,0],"half_angle_deg":0}],)"
    R"("axes":{"A":{"min_deg":-51.5,"max_deg":52.5,"peak_deg_s":53.5,"limit_deg_s":54.5,)"
    R"("peak_ratio":55.5,"range_deg":[-110,111],"margin_deg":57.5},)"
    R"("X":{"peak_mm_s":58.5,"range_mm":[-300,301],"margin_mm":59.5}},)"
    R"("instructions":["turn","tilt"]})";

/// Without figures: out of reach.
jobs::SetupReport impossible_setup() {
  jobs::SetupReport report;
  report.setup.theta_x_deg = 60.0;
  report.tilt_deg = 60.0;
  report.obstacle = jobs::Obstacle{.kind = jobs::Obstacle::Kind::problem,
                                   .axis = {},
                                   .message = "A would turn too far",
                                   .cl_line = 7,
                                   .code = Code::rotary_range};
  return report;
}

constexpr std::string_view impossible_text =
    R"({"theta_x_deg":60,"theta_z_deg":0,"twin":null,"tilt_deg":60,)"
    R"("setup":{"theta_x_deg":60,"theta_z_deg":0},"possible":false,"within_limits":false,)"
    R"("obstacle":{"kind":"problem","code":"rotary_range","message":"A would turn too far",)"
    R"("cl_line":7},"instructions":[]})";

jobs::ReorientReport report() {
  jobs::ReorientReport report;
  report.machine_name = "demo";
  report.machine_version = "1.1.0";
  report.machine_sha256 = "aa";
  report.cl_units = "mm";
  report.cl_lines = 11;
  report.cl_points = 12;
  report.baseline = impossible_setup();
  return report;
}

std::string holding(const jobs::SetupReport& baseline) {
  auto with = report();
  with.baseline = baseline;
  return reorient_json(with);
}

bool contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(ReorientJson, HasTheNamesOfTheContract) {
  auto full = report();
  full.objective = jobs::Objective::rotary_travel;
  full.best = setup();
  full.smallest_tilt = setup();
  full.smallest_tilt_gap_deg = 0.25;
  full.pareto = {setup()};
  full.candidates = {impossible_setup(), setup()};
  full.map = jobs::SetupMap{.theta_x_deg = {0.0, 2.0},
                            .theta_z_deg = {0.0, 90.0, 180.0},
                            .value = {{1.5, {}, 2.5}, {3.5, 4.5, {}}}};
  full.optimality_gap = 0.125;
  full.setups_evaluated = 71;
  full.setups_colliding = 72;
  const std::string good{setup_text}, bad{impossible_text};
  EXPECT_EQ(reorient_json(full),
            R"({"machine":{"name":"demo","version":"1.1.0","sha256":"aa"},)"
            R"("cl":{"lines":11,"points":12,"units":"mm"},"objective":"rotary_travel",)"
            R"("baseline":)" +
                bad + R"(,"best":)" + good + R"(,"smallest_tilt":)" + good +
                R"(,"smallest_tilt_gap_deg":0.25,"pareto":[)" + good + R"(],"candidates":[)" + bad +
                "," + good +
                R"(],"map":{"theta_x_deg":[0,2],"theta_z_deg":[0,90,180],)"
                R"("value":[[1.5,null,2.5],[3.5,4.5,null]]},"optimality_gap":0.125,)"
                R"("setups_evaluated":71,"setups_colliding":72,"obstacle":null,)"
                R"("diagnostics":[],"diagnostics_total":0})");
}

TEST(ReorientJson, SaysNullWhereThereIsNoSetup) {
  auto none = report();
  none.obstacle = jobs::Obstacle{
      .kind = jobs::Obstacle::Kind::speed, .axis = "C", .message = "C needs 200 of 150 deg/s"};
  const auto text = reorient_json(none);
  EXPECT_TRUE(contains(
      text,
      R"("best":null,"smallest_tilt":null,"smallest_tilt_gap_deg":null,"pareto":[],"candidates":[],)"
      R"("optimality_gap":null)"))
      << text;
  EXPECT_TRUE(contains(text, R"("obstacle":{"kind":"speed","axis":"C",)"
                             R"("message":"C needs 200 of 150 deg/s"},"diagnostics")"))
      << text;
}

TEST(ReorientJson, NamesACollision) {
  auto colliding = impossible_setup();
  colliding.obstacle =
      jobs::Obstacle{.kind = jobs::Obstacle::Kind::collision, .axis = {}, .message = "holder"};
  EXPECT_TRUE(
      contains(holding(colliding), R"("obstacle":{"kind":"collision","message":"holder"})"));
}

TEST(ReorientJson, SaysThatARatioHasNoBound) {
  auto unbounded = setup();
  unbounded.peak_ratio = std::nullopt;
  unbounded.peak_unbounded = true;
  EXPECT_TRUE(contains(holding(unbounded),
                       R"("peak_ratio":null,"peak_unbounded":true,"nominal_peak_ratio":0.625)"));
}

TEST(ReorientJson, GivesThePeakOfALinearAxisInMillimetres) {
  auto linear = setup();
  linear.peak_axis = "X";
  linear.peak_rotary = false;
  linear.peak_at = std::nullopt;
  EXPECT_TRUE(contains(holding(linear), R"("peak":{"axis":"X","mm_s":31.5})"));
}

TEST(ReorientJson, HasNoPeakWhereNoAxisHasALimit) {
  auto limitless = setup();
  limitless.peak_ratio = limitless.nominal_peak_ratio = std::nullopt;
  limitless.peak_axis = std::nullopt;
  limitless.closest_approach_deg = std::nullopt;
  const auto text = holding(limitless);
  EXPECT_TRUE(contains(text, R"("nominal_peak_ratio":null,"peak":null,"predicted_time_s")"));
  EXPECT_TRUE(contains(text, R"("closest_approach_deg":null)"));
}

// 0.1 + 0.2 has no shorter text than its 17 digits.
TEST(ReorientJson, WritesAnglesThatReadBackAsTheSameNumbers) {
  auto exact = setup();
  exact.setup.theta_x_deg = 0.1 + 0.2;
  EXPECT_TRUE(contains(holding(exact), R"("setup":{"origin_mm":[1.5,2.5,3.5],)"
                                       R"("theta_x_deg":0.30000000000000004,)"));
}

TEST(ReorientJson, NeverWritesANumberThatIsNotFinite) {
  auto broken = setup();
  broken.peak_ratio = std::numeric_limits<double>::infinity();
  EXPECT_THROW(holding(broken), std::logic_error);
}

}  // namespace
}  // namespace pentapost::server
