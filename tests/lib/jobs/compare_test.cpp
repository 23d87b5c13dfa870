#include "pentapost/jobs/compare.hpp"

#include "lib/jobs/job_case.hpp"
#include "pentapost/jobs/analyse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using Names = std::vector<std::string>;

machine::Definition machine_of(const std::string& name) { return sample::bundled_machine(name); }

jobs::CompareJob compare_job(std::string cl_text, const Names& machines) {
  jobs::CompareJob job{.job = sample::cl_job("generic-3axis", std::move(cl_text)), .machines = {}};
  for (const auto& name : machines) job.machines.push_back(machine_of(name));
  return job;
}

Names all_names() {
  Names names;
  for (const auto& each : sample::bundled_machines()) names.push_back(each.definition.name);
  return names;
}

jobs::CompareReport compared(const jobs::CompareJob& job) {
  auto report = jobs::compare(job);
  EXPECT_TRUE(report) << report.error().message;
  return report ? *report : jobs::CompareReport{};
}

Names names_of(const jobs::CompareReport& report) {
  Names names;
  for (const auto& row : report.rows) names.push_back(row.name);
  return names;
}

const jobs::CompareRow& row_of(const jobs::CompareReport& report, const std::string& name) {
  return *std::find_if(report.rows.begin(), report.rows.end(),
                       [&](const auto& row) { return row.name == name; });
}

/// Every number and word of a row, but its place in the job, without rounding.
std::string text_of(const jobs::CompareRow& row) {
  std::ostringstream text;
  text << std::hexfloat << row.name << ' ' << row.version << ' ' << row.title << ' ' << row.sha256
       << ' ' << row.dialect << ' ' << static_cast<int>(row.output) << '\n';
  if (!row.figures) {
    text << static_cast<int>(row.figures.error().code) << row.figures.error().message;
    return text.str();
  }
  const auto& figures = *row.figures;
  text << figures.within_limits << ' ' << figures.programmed_time_s << ' '
       << figures.predicted_time_s << ' ' << figures.repositioning_time_s << ' ' << figures.retracts
       << ' ' << figures.zones << ' ' << figures.over_demands << ' ' << figures.zones_time_lost_s
       << ' ' << figures.closest_approach_deg.value_or(-1.0) << ' '
       << (figures.peak ? figures.peak->name : "-") << ' '
       << (figures.peak ? figures.peak->peak_speed : 0.0) << ' '
       << figures.axes_without_limit.size() << ' ' << figures.diagnostics.total();
  for (const auto& each : figures.diagnostics.list()) text << '\n' << each.message;
  return text.str();
}

const std::string cripps = "cripps-2017-original.cl";

/// A cut below the horizon's side of a three-axis machine: its tool axis leans by 36.87 deg.
const std::string leaning = sample::cl_program("GOTO/0,0,0,0,0.6,0.8\nGOTO/10,0,0,0,0.6,0.8\n");
const std::string upright = sample::cl_program("GOTO/0,0,0,0,0,1\nGOTO/60,0,0,0,0,1\n");

TEST(CompareRow, SaysWhatTheAnalysisOfItsMachineSays) {
  const auto report = compared(compare_job(sample::papers_text(cripps), all_names()));
  ASSERT_EQ(report.rows.size(), all_names().size());
  std::size_t possible = 0;
  for (const auto& row : report.rows) {
    SCOPED_TRACE(row.name);
    const auto alone =
        jobs::analyse({.job = sample::cl_job(row.name, sample::papers_text(cripps))});
    ASSERT_EQ(row.figures.has_value(), alone.has_value());
    if (!alone) {
      EXPECT_EQ(row.figures.error().code, alone.error().code);
      EXPECT_EQ(row.figures.error().message, alone.error().message);
      EXPECT_EQ(row.figures.error().cl_line, alone.error().cl_line);
      continue;
    }
    ++possible;
    EXPECT_EQ(row.sha256, alone->machine_sha256);
    EXPECT_EQ(row.figures->programmed_time_s, alone->programmed_time_s);
    EXPECT_EQ(row.figures->predicted_time_s, alone->predicted_time_s);
    EXPECT_EQ(row.figures->repositioning_time_s, alone->repositioning_time_s);
    EXPECT_EQ(row.figures->closest_approach_deg, alone->closest_approach_deg);
    EXPECT_EQ(row.figures->zones, alone->zones.total);
    EXPECT_EQ(row.figures->zones_time_lost_s, alone->zones.time_lost_s);
    EXPECT_EQ(row.figures->over_demands, alone->over_demands.total);
    EXPECT_EQ(row.figures->over_demands_time_lost_s, alone->over_demands.time_lost_s);
    EXPECT_EQ(row.figures->peak ? row.figures->peak->peak_ratio : std::nullopt, alone->peak_ratio);
    const bool needs_gauge = row.name == "linuxcnc-bridgemill";  // axis words, the head turns
    EXPECT_EQ(row.figures->diagnostics.total() + report.diagnostics.total(),
              alone->diagnostics.total() + (needs_gauge ? 1 : 0));
  }
  EXPECT_GE(possible, 10U);
}

/// Cripps et al. 2017, section 2: C needs 198.9 rpm of its 25 rpm, 1 deg off the pole.
TEST(CompareRow, HasThePeakOfCripps) {
  const auto report = compared(compare_job(sample::papers_text(cripps), {"hermle-c600u"}));
  const auto& figures = *report.rows.at(0).figures;
  EXPECT_EQ(figures.peak.value().name, "C");
  EXPECT_NEAR(figures.peak->peak_speed, 198.9 * 6.0, 0.6);
  EXPECT_NEAR(figures.peak->peak_ratio.value(), 198.9 / 25.0, 0.005);
  EXPECT_NEAR(figures.peak->peak_at.value().tip_wp_mm.x(), 25.0, 1e-3);
  EXPECT_NEAR(figures.closest_approach_deg.value(), 1.0, 0.0005);
  EXPECT_EQ(figures.zones, 1U);
  EXPECT_FALSE(figures.within_limits);
}

TEST(CompareRow, NamesTheAxesWithoutLimit) {
  auto job = compare_job(upright, {"hermle-c600u"});
  job.machines[0].limits = {{"A", {.max_speed = 1.0}}, {"X", {.max_acceleration = 1.0}}};
  auto figures = *compared(job).rows.at(0).figures;
  EXPECT_EQ(figures.limits_known, jobs::LimitsKnown::some);
  std::sort(figures.axes_without_limit.begin(), figures.axes_without_limit.end());
  EXPECT_EQ(figures.axes_without_limit, (Names{"C", "X", "Y", "Z"}));
}

TEST(CompareRow, OfAMachineWithoutLimitsHasNoRatioAndTheProgrammedTime) {
  auto job = compare_job(sample::papers_text(cripps), {"hermle-c600u"});
  job.machines[0].limits.clear();
  const auto figures = *compared(job).rows.at(0).figures;
  EXPECT_EQ(figures.limits_known, jobs::LimitsKnown::none);
  EXPECT_EQ(figures.peak, std::nullopt);
  EXPECT_EQ(figures.zones, 0U);
  EXPECT_NEAR(figures.predicted_time_s, figures.programmed_time_s, 1e-9);
}

TEST(CompareRow, OfAThreeAxisMachineSaysWhereItEnds) {
  const auto report = compared(compare_job(leaning, {"generic-3axis"}));
  const auto& problem = report.rows.at(0).figures.error();
  EXPECT_EQ(problem.code, Code::out_of_reach);
  EXPECT_EQ(problem.cl_line, 5U);
}

TEST(CompareRow, HasDialectAndOutputOfItsDefinition) {
  auto job = compare_job(upright, {"hermle-c600u", "generic-3axis"});
  const auto own = compared(job);
  EXPECT_EQ(row_of(own, "hermle-c600u").dialect, "heidenhain-iso");
  EXPECT_EQ(row_of(own, "generic-3axis").dialect, "fanuc-30i");
  EXPECT_EQ(row_of(own, "hermle-c600u").output, Output::tcp);
}

TEST(CompareOverrides, HoldForEveryMachine) {
  auto job = compare_job(upright, {"hermle-c600u", "generic-3axis"});
  job.job.post.dialect = "fanuc-30i";
  job.job.post.output = Output::axes;
  for (const auto& row : compared(job).rows) {
    EXPECT_EQ(row.dialect, "fanuc-30i");
    EXPECT_EQ(row.output, Output::axes);
    EXPECT_TRUE(row.figures);
  }
}

/// Not the path lacks it but the words of a head that turns: the analysis goes without.
TEST(CompareOverrides, WarnOfAGaugeLengthThatTheProgramNeeds) {
  auto job = compare_job(leaning, {"generic-ca-head", "hermle-c600u"});
  job.job.post.output = Output::axes;
  const auto warns = [&](const std::string& name) {
    const auto figures = *row_of(compared(job), name).figures;
    const auto& list = figures.diagnostics.list();
    return std::any_of(list.begin(), list.end(), [](const Diagnostic& each) {
      return each.code == Code::gauge_length_missing;
    });
  };
  EXPECT_TRUE(warns("generic-ca-head"));
  EXPECT_FALSE(warns("hermle-c600u"));
  job.job.gauge_length_mm = {{1, 100.0}};
  EXPECT_FALSE(warns("generic-ca-head"));
}

/// Without rotary axes the tip is where the linear axes are, which here are not X Y Z of the part.
TEST(CompareOverrides, OfAnOutputThatAMachineCannotHaveAreItsProblem) {
  auto job = compare_job(upright, {"hermle-c600u", "generic-3axis"});
  const auto& chain = job.machines[1].chain;
  const auto turned = [](std::span<const machine::Joint> joints) {
    std::vector<machine::Joint> copy{joints.begin(), joints.end()};
    for (auto& joint : copy) {
      auto& linear = std::get<machine::LinearJoint>(joint.kind);
      linear.direction = UnitVector::normalised(-linear.direction.vec());
    }
    return copy;
  };
  job.machines[1].chain =
      *machine::Chain::make(turned(chain.table()), turned(chain.head()), chain.tool_axis());
  job.job.post.output = Output::tcp;
  EXPECT_EQ(row_of(compared(job), "generic-3axis").figures.error().code, Code::unsupported_output);
  job.job.post.output = Output::axes;
  EXPECT_TRUE(row_of(compared(job), "generic-3axis").figures);
}

TEST(CompareOverrides, OfAToleranceBelowTheDigitsAreTheProblemOfThatControl) {
  auto job = compare_job(upright, {"hermle-c600u", "generic-3axis"});
  job.machines[1].controller.options["decimals_mm"] = 2.0;
  job.job.tolerances.tip_mm = 0.002;
  const auto report = compared(job);
  EXPECT_TRUE(row_of(report, "hermle-c600u").figures);
  EXPECT_EQ(row_of(report, "generic-3axis").figures.error().code, Code::tolerance_below_digits);
}

TEST(CompareFailure, LeavesTheOtherRowsAsTheyAre) {
  const auto alone = compared(compare_job(leaning, {"hermle-c600u", "dmu-50-evolution"}));
  auto job = compare_job(
      leaning, {"generic-3axis", "hermle-c600u", "mazak-variaxis-630", "dmu-50-evolution"});
  job.machines[2].controller.options["decimals_mm"] = std::string{"three"};
  const auto report = compared(job);
  ASSERT_EQ(report.rows.size(), 4U);
  for (const std::string name : {"hermle-c600u", "dmu-50-evolution"})
    EXPECT_EQ(text_of(row_of(report, name)), text_of(row_of(alone, name)));
  EXPECT_EQ(row_of(report, "mazak-variaxis-630").figures.error().code, Code::bad_option);
  EXPECT_EQ(row_of(report, "mazak-variaxis-630").figures.error().pointer,
            "/machine/controller/options/decimals_mm");
  EXPECT_EQ(row_of(report, "generic-3axis").figures.error().code, Code::out_of_reach);
}

/// A definition of a dialect that the library does not have came past the reading of definitions.
TEST(CompareFailure, OfAnUnknownDialectIsThatMachines) {
  auto job = compare_job(upright, {"hermle-c600u", "generic-3axis"});
  job.machines[0].controller.dialect = "none";
  const auto report = compared(job);
  EXPECT_EQ(names_of(report), (Names{"generic-3axis", "hermle-c600u"}));
  EXPECT_EQ(report.rows[1].figures.error().code, Code::unknown_dialect);
}

TEST(ComparePath, OfOneMachineTwiceGivesTwoEqualRows) {
  const auto report =
      compared(compare_job(sample::papers_text(cripps), {"hermle-c600u", "hermle-c600u"}));
  ASSERT_EQ(report.rows.size(), 2U);
  EXPECT_EQ(report.rows[0].index, 0U);
  EXPECT_EQ(report.rows[1].index, 1U);
  EXPECT_EQ(text_of(report.rows[0]), text_of(report.rows[1]));
}

TEST(ComparePath, IsTurnedByTheSetupForEveryMachineOnce) {
  auto job = compare_job(sample::papers_text(cripps), {"hermle-c600u", "hermle-c600u"});
  job.job.setup.theta_x_deg = -10.0;
  for (const auto& row : compared(job).rows)
    EXPECT_NEAR(row.figures->closest_approach_deg.value(), 11.0, 0.0005);
}

TEST(CompareHead, IsOfThePath) {
  const auto text = sample::papers_text(cripps);
  const auto report = compared(compare_job(text, {"hermle-c600u"}));
  const auto alone = *jobs::analyse({.job = sample::cl_job("hermle-c600u", text)});
  EXPECT_EQ(report.cl_sha256, alone.cl_sha256);
  EXPECT_EQ(report.cl_points, alone.cl_points);
  EXPECT_EQ(report.cl_lines, alone.cl_lines);
  EXPECT_EQ(report.machine_name, "");
}

struct Fault {
  std::string name;
  void (*spoil)(jobs::CompareJob&);
  Code code;
  std::string pointer;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class CompareFault : public ::testing::TestWithParam<Fault> {};

TEST_P(CompareFault, IsOneErrorForAll) {
  auto job = compare_job(upright, {"hermle-c600u", "generic-3axis", "generic-ca-head"});
  GetParam().spoil(job);
  const auto report = jobs::compare(job);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, GetParam().code);
  EXPECT_EQ(report.error().pointer, GetParam().pointer);
}

const std::vector<Fault> faults{
    {"NoMachine", [](jobs::CompareJob& job) { job.machines.clear(); }, Code::out_of_domain,
     "/machines"},
    {"TooManyMachines",
     [](jobs::CompareJob& job) {
       const auto machine = job.machines.front();
       job.machines.assign(jobs::CompareJob::most_machines + 1, machine);
     },
     Code::out_of_domain, "/machines"},
    {"NoMotion", [](jobs::CompareJob& job) { job.job.path = jobs::ClText{.text = "FINI\n"}; },
     Code::no_motion, ""},
    {"DamagedMotion",
     [](jobs::CompareJob& job) { job.job.path = jobs::ClText{.text = "UNITS/MM\nGOTO/1,x,2\n"}; },
     Code::damaged_motion, ""},
    {"NoPoints",
     [](jobs::CompareJob& job) {
       job.job.path = jobs::PointPath{1.0, {}, {}};
     },
     Code::no_motion, "/path/points"},
    {"ZoneShare",
     [](jobs::CompareJob& job) { job.zone_share = std::numeric_limits<double>::quiet_NaN(); },
     Code::out_of_domain, "/zone_share"},
    {"Tolerance", [](jobs::CompareJob& job) { job.job.tolerances.tip_mm = 0.0; },
     Code::out_of_domain, "/tolerances/tip_mm"},
    {"Dialect", [](jobs::CompareJob& job) { job.job.post.dialect = "none"; }, Code::unknown_dialect,
     "/post/dialect"},
    {"LimitOfNoMachine", [](jobs::CompareJob& job) { job.job.limits["W"].max_speed = 1.0; },
     Code::out_of_domain, "/limits/W"},
    {"FeedThatNoNumberHolds",
     [](jobs::CompareJob& job) {
       job.job.path = jobs::PointPath{.feed_mm_min = 1e-310,
                                      .tip_mm = {Vec3{0, 0, 0}, Vec3{10, 0, 0}},
                                      .axis = {Vec3{0, 0, 1}, Vec3{0, 0, 1}}};
     },
     Code::out_of_domain, ""},
};

INSTANTIATE_TEST_SUITE_P(, CompareFault, ::testing::ValuesIn(faults),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(CompareLimits, AreOfTheMachinesThatHaveTheAxis) {
  auto job = compare_job(sample::papers_text(cripps), {"hermle-c600u", "linuxcnc-xyzbc-trt"});
  const auto before = compared(job);
  job.job.limits["A"].max_speed = 0.1;  // 5.73 deg/s
  const auto report = compared(job);
  EXPECT_EQ(text_of(row_of(report, "linuxcnc-xyzbc-trt")),
            text_of(row_of(before, "linuxcnc-xyzbc-trt")));
  EXPECT_GT(row_of(report, "hermle-c600u").figures->predicted_time_s,
            row_of(before, "hermle-c600u").figures->predicted_time_s + 0.1);
}

/// A number of mm/s cannot be one of deg/s.
TEST(CompareLimits, OfANameWithTwoKindsAreRefused) {
  auto job = compare_job(upright, {"hermle-c600u", "generic-3axis"});
  const auto& chain = job.machines[1].chain;
  std::vector<machine::Joint> table{chain.table().begin(), chain.table().end()};
  std::vector<machine::Joint> head{chain.head().begin(), chain.head().end()};
  (table.empty() ? head : table).front().name = "A";
  job.machines[1].chain = *machine::Chain::make(table, head, chain.tool_axis());
  job.job.limits["A"].max_speed = 1.0;
  const auto report = jobs::compare(job);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().pointer, "/limits/A");
}

jobs::CompareJob reorient_job(const Names& machines) {
  auto job = compare_job(sample::papers_text(cripps), machines);
  job.reorient = jobs::ReorientJob{.job = job.job};
  job.reorient->max_tilt_deg = 10.0;
  job.reorient->setup_accuracy_deg = 0.1;
  return job;
}

TEST(CompareReorientation, IsThatOfReorientOnTheMachine) {
  auto job = reorient_job({"hermle-c600u"});
  job.reorient->candidates = {{.theta_x_deg = 5.0}};  // counts for nothing
  const auto report = compared(job);
  EXPECT_EQ(report.objective, jobs::Objective::peak_ratio);
  const auto& row = report.rows.at(0);
  ASSERT_TRUE(row.reorientation && *row.reorientation);
  auto alone_job = *job.reorient;
  alone_job.job.machine = job.machines[0];
  const auto alone = jobs::reorient(alone_job);
  ASSERT_TRUE(alone) << alone.error().message;
  const auto& found = **row.reorientation;
  ASSERT_TRUE(found.best && alone->best);
  EXPECT_EQ(found.best->setup.theta_x_deg, alone->best->setup.theta_x_deg);
  EXPECT_EQ(found.best->setup.theta_z_deg, alone->best->setup.theta_z_deg);
  EXPECT_EQ(found.best->peak_ratio, alone->best->peak_ratio);
  EXPECT_EQ(found.optimality_gap, alone->optimality_gap);
  EXPECT_LT(found.best->peak_ratio.value(), row.figures->peak->peak_ratio.value());
}

TEST(CompareReorientation, LeavesTheFiguresAsTheyAre) {
  const auto with = compared(reorient_job({"hermle-c600u", "huron-kx100"}));
  const auto without =
      compared(compare_job(sample::papers_text(cripps), {"hermle-c600u", "huron-kx100"}));
  for (const auto& row : without.rows) EXPECT_EQ(text_of(row), text_of(row_of(with, row.name)));
  EXPECT_EQ(without.objective, std::nullopt);
}

/// A machine that cannot be reoriented for is its row alone.
TEST(CompareReorientation, OfAMachineWithoutRotaryAxesIsItsProblem) {
  auto job = reorient_job({"hermle-c600u", "generic-3axis"});
  job.job.path = jobs::ClText{.text = upright};
  const auto report = compared(job);
  const auto& row = row_of(report, "generic-3axis");
  EXPECT_TRUE(row.figures);
  ASSERT_TRUE(row.reorientation && !*row.reorientation);
  EXPECT_EQ(row.reorientation->error().code, Code::not_reorientable);
  EXPECT_TRUE(row_of(report, "hermle-c600u").reorientation.value());
}

TEST(CompareReorientation, WithABadNumberIsOneErrorForAll) {
  auto job = reorient_job({"hermle-c600u", "huron-kx100"});
  job.reorient->setup_accuracy_deg = -1.0;
  const auto report = jobs::compare(job);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().code, Code::out_of_domain);
  EXPECT_EQ(report.error().pointer, "/reorient/setup_accuracy_deg");
}

}  // namespace
}  // namespace pentapost
