#include "pentapost/jobs/clearances.hpp"

#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace pentapost::jobs {
namespace {

using clearance::JigBox;
using clearance::Model;

/// One point, tool upright, with tool 1 of gauge length 120 mm; origin 30 mm above the table.
PostJob job_of(const std::string& goto_lines = "GOTO/0,0,0,0,0,1\n") {
  PostJob job = sample::cl_job("hermle-c600u", sample::cl_program(goto_lines));
  job.setup.origin_mm = Vec3{0, 0, 30};
  job.gauge_length_mm = {{1, 120.0}};
  return job;
}

Model holder_over_table() {
  Model model;
  model.holder = {{.radius_mm = 20, .from_mm = 50, .to_mm = 100}};
  model.machine.table = machine::TableDisc{.radius_mm = 300};
  return model;
}

const machine::Clearance defined{.spindle = {{{.radius_mm = 80, .from_mm = 0, .to_mm = 200}}},
                                 .table = machine::TableDisc{.radius_mm = 300}};

Result<std::optional<clearance::Check>> check_of(const PostJob& job,
                                                 const std::optional<Model>& requested,
                                                 bool origin_bounded = false,
                                                 Diagnostics* diagnostics = nullptr) {
  Diagnostics own;
  const auto prepared = prepare(job).value();
  return clearance_check(job, prepared, requested, origin_bounded,
                         diagnostics != nullptr ? *diagnostics : own);
}

std::optional<clearance::Collision> collision_of(const PostJob& job,
                                                 const std::optional<Model>& requested) {
  return check_of(job, requested)
      .value()
      .value()
      .first_collision(turn_of(job.setup), *job.setup.origin_mm);
}

TEST(Clearances, AreNotCheckedWhereNothingIsGiven) {
  const auto check = check_of(job_of(), std::nullopt);
  ASSERT_TRUE(check);
  EXPECT_FALSE(check->has_value());
}

TEST(Clearances, OfTheRequestAreChecked) {
  PostJob job = job_of();
  EXPECT_FALSE(collision_of(job, holder_over_table()));
  job.setup.origin_mm = Vec3{0, 0, -49};
  const auto collision = collision_of(job, holder_over_table());
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->what, "holder 1");
  EXPECT_EQ(collision->cl_line, 5u);
}

TEST(Clearances, OfTheDefinitionAreCheckedUnasked) {
  PostJob job = job_of();
  job.machine.clearance = defined;
  EXPECT_FALSE(collision_of(job, std::nullopt));
  job.setup.origin_mm = Vec3{0, 0, -119};
  const auto collision = collision_of(job, std::nullopt);
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->what, "spindle 1");
}

TEST(Clearances, OfTheRequestReplaceThoseOfTheDefinitionPartByPart) {
  PostJob job = job_of();
  job.machine.clearance = defined;
  job.setup.origin_mm = Vec3{0, 0, -119};
  Model narrow;
  narrow.machine.spindle = {{{.radius_mm = 80, .from_mm = 10, .to_mm = 200}}};
  EXPECT_FALSE(collision_of(job, narrow));
  Model lower;
  lower.machine.table = machine::TableDisc{.radius_mm = 300, .centre_mm = {0, 0, -20}};
  EXPECT_FALSE(collision_of(job, lower));
  EXPECT_TRUE(collision_of(job, Model{}));
}

TEST(Clearances, AreAskedInClCoordinatesWhateverTheSetupOfTheJob) {
  // The tool lies along +y; theta_x = -90 turns the part by +90 about x, and it stands upright.
  PostJob job = job_of("GOTO/0,0,0,0,1,0\n");
  job.setup.theta_x_deg = -90.0;
  job.setup.origin_mm = Vec3{0, 0, -47};
  EXPECT_FALSE(collision_of(job, holder_over_table()));
  job.setup.origin_mm = Vec3{0, 0, -49};
  EXPECT_TRUE(collision_of(job, holder_over_table()));
}

TEST(Clearances, FollowHolesToTheirDepth) {
  const std::string cycle = "CYCLE/DRILL,DEPTH,30,CLEAR,5,MMPM,200\nGOTO/0,0,0,0,0,1\nCYCLE/OFF\n";
  PostJob job = job_of(cycle);
  job.setup.origin_mm = Vec3{0, 0, -10};
  const auto collision = collision_of(job, holder_over_table());
  EXPECT_FALSE(collision);  // 10 mm above at the depth
  job.setup.origin_mm = Vec3{0, 0, -19};
  EXPECT_TRUE(collision_of(job, holder_over_table()));
}

void expect_problem(const Result<std::optional<clearance::Check>>& check, Code code,
                    const std::string& pointer) {
  ASSERT_FALSE(check);
  EXPECT_EQ(check.error().code, code) << check.error().message;
  EXPECT_EQ(check.error().pointer, pointer) << check.error().message;
}

TEST(Clearances, NeedTheOriginForWhatStandsOnTheTable) {
  PostJob job = job_of();
  job.setup.origin_mm.reset();
  expect_problem(check_of(job, holder_over_table()), Code::origin_missing, "/setup/origin_mm");
  EXPECT_TRUE(check_of(job, holder_over_table(), true));
}

TEST(Clearances, NeedNoOriginForAJigOnTheWorkpiece) {
  PostJob job = job_of();
  job.setup.origin_mm.reset();
  Model model;
  model.holder = holder_over_table().holder;
  model.jig = {{.min_mm = {0, 0, 0}, .max_mm = {1, 1, 1}, .frame = JigBox::Frame::workpiece}};
  EXPECT_TRUE(check_of(job, model));
}

TEST(Clearances, NeedTheGaugeLengthForTheSpindle) {
  PostJob job = job_of();
  job.gauge_length_mm.clear();
  EXPECT_TRUE(check_of(job, holder_over_table()));
  Model model = holder_over_table();
  model.machine.spindle = defined.spindle;
  expect_problem(check_of(job, model), Code::gauge_length_missing, "/tools");
}

TEST(Clearances, OfTheDefinitionThatLackSomethingAreAWarning) {
  PostJob job = job_of();
  job.machine.clearance = defined;
  job.gauge_length_mm.clear();
  Diagnostics diagnostics;
  const auto check = check_of(job, std::nullopt, false, &diagnostics);
  ASSERT_TRUE(check);
  EXPECT_FALSE(check->has_value());
  ASSERT_EQ(diagnostics.list().size(), 1u);
  EXPECT_EQ(diagnostics.list()[0].code, Code::clearance_unchecked);
}

TEST(Clearances, ThatCannotMeetAreRefused) {
  expect_problem(check_of(job_of(), Model{}), Code::missing_key, "/clearance");
  Model model = holder_over_table();
  model.machine.table.reset();
  expect_problem(check_of(job_of(), model), Code::missing_key, "/clearance");
}

TEST(Clearances, RefuseNumbersOutOfTheirDomain) {
  const auto refused = [](auto change, const std::string& pointer) {
    Model model = holder_over_table();
    change(model);
    expect_problem(check_of(job_of(), model), Code::out_of_domain, pointer);
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](Model& model) { model.safety_mm = nan; }, "/clearance/safety_mm");
  refused([](Model& model) { model.holder[0].radius_mm = 0.0; }, "/clearance/holder/0");
  refused([](Model& model) { model.holder[0].to_mm = 50.0; }, "/clearance/holder/0");
  refused([](Model& model) { model.machine.table->radius_mm = nan; }, "/clearance/table");
  refused([](Model& model) { model.jig = {{}}; }, "/clearance/jig/0");
  refused([](Model& model) { model.holder.resize(17, model.holder[0]); }, "/clearance/holder");
}

}  // namespace
}  // namespace pentapost::jobs
