#include "pentapost/clearance/check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pentapost::clearance {
namespace {

using machine::ToolCylinder;
using path::Move;

const Mat3 straight = Mat3::Identity();
const Vec3 up = Vec3::UnitZ();

Vec3 leaning(double lean_deg) {
  return {std::sin(lean_deg * rad_per_deg), 0.0, std::cos(lean_deg * rad_per_deg)};
}

path::ToolPath path_of(const std::vector<std::pair<Vec3, Vec3>>& points, Move how = Move::feed) {
  path::ToolPath tool_path;
  for (const auto& [tip_mm, axis] : points)
    tool_path.add_point(tip_mm, axis, static_cast<std::uint32_t>(tool_path.size() + 10), how);
  return tool_path;
}

Check check_of(const path::ToolPath& tool_path, const Model& model, double gauge_length_mm = 0.0) {
  return {tool_path,
          {{.begin = 0,
            .end = static_cast<std::uint32_t>(tool_path.size()),
            .gauge_length_mm = gauge_length_mm}},
          model};
}

/// A holder of radius 20 mm from 50 to 100 mm above the tip.
const ToolCylinder holder{.radius_mm = 20, .from_mm = 50, .to_mm = 100};

Model over_table(double safety_mm = 2.0) {
  Model model;
  model.holder = {holder};
  model.machine.table = machine::TableDisc{.radius_mm = 200};
  model.safety_mm = safety_mm;
  return model;
}

bool collides(const path::ToolPath& tool_path, const Model& model, const Vec3& origin_mm,
              const Mat3& turn = straight) {
  return check_of(tool_path, model).first_collision(turn, origin_mm).has_value();
}

TEST(ClearanceCheck, TellsTheSafetyDistanceFromLessToAThousandth) {
  const auto tool_path = path_of({{{0, 0, 0}, up}});
  // The holder's end is 50 mm above the tip.
  EXPECT_FALSE(collides(tool_path, over_table(), {0, 0, -48 + 1e-3}));
  EXPECT_TRUE(collides(tool_path, over_table(), {0, 0, -48 - 1e-3}));
}

TEST(ClearanceCheck, TakesTheRimOfALeaningHolder) {
  const auto tool_path = path_of({{{0, 0, 0}, leaning(60)}});
  const double rim_mm = 50.0 * 0.5 - 20.0 * std::sin(60.0 * rad_per_deg);
  EXPECT_FALSE(collides(tool_path, over_table(), {0, 0, 2.0 - rim_mm + 1e-3}));
  EXPECT_TRUE(collides(tool_path, over_table(), {0, 0, 2.0 - rim_mm - 1e-3}));
}

TEST(ClearanceCheck, LetsAHolderLeanOverTheEdgeOfTheTable) {
  // The tip is below the face of the table, outside of its rim, and the tool leans away from it.
  const auto tool_path = path_of({{{0, 0, 0}, leaning(45)}});
  EXPECT_FALSE(collides(tool_path, over_table(), {205, 0, -25}));
  EXPECT_TRUE(collides(path_of({{{0, 0, 0}, leaning(-45)}}), over_table(), {205, 0, -25}));
}

TEST(ClearanceCheck, TurnsThePartBeforeItPutsItDown) {
  // The tool lies along +y in the part; turned by +90 deg about x it stands upright.
  const auto tool_path = path_of({{{0, 10, 0}, Vec3::UnitY()}});
  const Mat3 turn = Eigen::AngleAxisd{pi / 2, Vec3::UnitX()}.toRotationMatrix();
  // Tip at (0, 0, 10) + origin, end of the holder 50 mm above it.
  EXPECT_FALSE(collides(tool_path, over_table(), {0, 0, -58 + 1e-3}, turn));
  EXPECT_TRUE(collides(tool_path, over_table(), {0, 0, -58 - 1e-3}, turn));
}

TEST(ClearanceCheck, PutsTheTableWhereItIs) {
  Model model = over_table();
  model.machine.table->centre_mm = {0, 0, 30};
  model.machine.table->normal = UnitVector::normalised(Vec3::UnitX());
  // A wall, its face in x = 0: the side of the holder is 20 mm from the tool axis.
  const auto tool_path = path_of({{{0, 0, 0}, up}});
  EXPECT_FALSE(collides(tool_path, model, {22 + 1e-3, 0, 0}));
  EXPECT_TRUE(collides(tool_path, model, {22 - 1e-3, 0, 0}));
}

TEST(ClearanceCheck, EndsTheTableAtItsThickness) {
  Model model = over_table();
  model.machine.table->thickness_mm = 10;
  const auto tool_path = path_of({{{0, 0, 0}, up}});
  // The upper end of the holder is 100 mm above the tip.
  EXPECT_FALSE(collides(tool_path, model, {0, 0, -112 - 1e-3}));
  EXPECT_TRUE(collides(tool_path, model, {0, 0, -112 + 1e-3}));
}

TEST(ClearanceCheck, CountsTheSpindleFromTheGaugeLine) {
  Model model;
  model.machine.spindle = {{{.radius_mm = 60, .from_mm = 10, .to_mm = 200}}};
  model.machine.table = machine::TableDisc{.radius_mm = 200};
  const auto tool_path = path_of({{{0, 0, 0}, up}});
  const Check check = check_of(tool_path, model, 120.0);
  EXPECT_FALSE(check.first_collision(straight, {0, 0, -128 + 1e-3}));
  const auto collision = check.first_collision(straight, {0, 0, -128 - 1e-3});
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->what, "spindle 1");
}

TEST(ClearanceCheck, GivesEveryToolItsGaugeLength) {
  Model model;
  model.machine.spindle = {{{.radius_mm = 60, .from_mm = 0, .to_mm = 200}}};
  model.machine.table = machine::TableDisc{.radius_mm = 200};
  const auto tool_path = path_of({{{0, 0, 0}, up}, {{0, 0, 0}, up}});
  const Check check{tool_path, {{0, 1, 120.0}, {1, 2, 80.0}}, model};
  const auto collision = check.first_collision(straight, {0, 0, -100});
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->point, 1u);
}

TEST(ClearanceCheck, TurnsAJigOfTheWorkpieceWithThePart) {
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {30, -10, 0}, .max_mm = {40, 10, 80}, .frame = JigBox::Frame::workpiece}};
  const auto far_path = path_of({{{8 - 1e-3, 0, 0}, up}});
  const auto near_path = path_of({{{8 + 1e-3, 0, 0}, up}});
  const Mat3 turn = Eigen::AngleAxisd{1.0, Vec3{1, 2, 3}.normalized()}.toRotationMatrix();
  for (const Mat3& any : {straight, turn}) {
    EXPECT_FALSE(collides(far_path, model, {1, 2, 3}, any));
    EXPECT_TRUE(collides(near_path, model, {1, 2, 3}, any));
  }
}

TEST(ClearanceCheck, LeavesAJigOfTheTableWhereItIs) {
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {30, -10, 0}, .max_mm = {40, 10, 80}}};
  const auto tool_path = path_of({{{0, 0, 0}, up}});
  EXPECT_FALSE(collides(tool_path, model, {8 - 1e-3, 0, 0}));
  EXPECT_TRUE(collides(tool_path, model, {8 + 1e-3, 0, 0}));
  // Turned by 90 deg about z the part is elsewhere and the box is not.
  const Mat3 turn = Eigen::AngleAxisd{pi / 2, up}.toRotationMatrix();
  const auto aside = path_of({{{0, -8 - 1e-3, 0}, up}});
  EXPECT_TRUE(collides(aside, model, {0, 0, 0}, turn));
  EXPECT_FALSE(collides(aside, model, {0, 0, 0}));
}

TEST(ClearanceCheck, MeetsTheCornerOfABox) {
  Model model;
  model.holder = {holder};
  // The corner (18, 24, 45) is 30 mm from the tool axis and 5 mm below the holder's end.
  model.jig = {{.min_mm = {18, 24, -5}, .max_mm = {60, 60, 45}}};
  model.safety_mm = std::hypot(10.0, 5.0);
  const auto tool_path = path_of({{{0, 0, 0}, up}});
  EXPECT_FALSE(collides(tool_path, model, {0, 0, 1e-2}));
  EXPECT_TRUE(collides(tool_path, model, {0, 0, -1e-2}));
}

TEST(ClearanceCheck, TellsWhoMeetsWhatAndWhere) {
  Model model = over_table();
  model.holder.insert(model.holder.begin(), {.radius_mm = 5, .from_mm = 60, .to_mm = 70});
  const auto tool_path = path_of({{{0, 0, 100}, up}, {{0, 0, 3}, up}, {{0, 0, 0}, up}});
  const auto collision = check_of(tool_path, model).first_collision(straight, {0, 0, -49});
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->point, 2u);
  EXPECT_EQ(collision->cl_line, 12u);
  EXPECT_EQ(collision->what, "holder 2");
  EXPECT_EQ(collision->with, "table");
}

TEST(ClearanceCheck, NamesThePlaceThatIsFirstOnThePathWhateverCollidesThere) {
  Model model = over_table();
  model.jig = {{.min_mm = {90, -10, 0}, .max_mm = {110, 10, 80}}};
  const auto tool_path = path_of(
      {{{0, 0, 0}, up}, {{100, 0, 0}, up}, {{100, 0, 200}, up}, {{0, 0, -100}, up}}, Move::rapid);
  const auto collision = check_of(tool_path, model).first_collision(straight, {0, 0, 0});
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->point, 1u);
  EXPECT_EQ(collision->with, "jig 1");
}

TEST(ClearanceCheck, SaysHowNearItGets) {
  const auto tool_path = path_of({{{0, 0, 0}, up}});
  const auto near = check_of(tool_path, over_table()).first_collision(straight, {0, 0, -48.75});
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->distance_mm, 1.25, 1e-3);
  const auto inside = check_of(tool_path, over_table()).first_collision(straight, {0, 0, -60});
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->distance_mm, 0.0);
}

TEST(ClearanceCheck, SeesAPostThatALongMovePasses) {
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {498, -2, 0}, .max_mm = {502, 2, 60}}};
  const auto ends = std::vector<std::pair<Vec3, Vec3>>{{{0, 0, 0}, up}, {{1000, 0, 0}, up}};
  const auto collision = check_of(path_of(ends), model).first_collision(straight, {0, 0, 0});
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->point, 1u);
}

TEST(ClearanceCheck, DoesNotGuessTheWayOfARapid) {
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {498, -2, 0}, .max_mm = {502, 2, 60}}};
  const auto ends = std::vector<std::pair<Vec3, Vec3>>{{{0, 0, 0}, up}, {{1000, 0, 0}, up}};
  EXPECT_FALSE(collides(path_of(ends, Move::rapid), model, {0, 0, 0}));
}

TEST(ClearanceCheck, DoesNotJoinStretches) {
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {498, -2, 0}, .max_mm = {502, 2, 60}}};
  const auto tool_path = path_of({{{0, 0, 0}, up}, {{1000, 0, 0}, up}});
  const Check check{tool_path, {{0, 1, 0.0}, {1, 2, 0.0}}, model};
  EXPECT_FALSE(check.first_collision(straight, {0, 0, 0}));
}

TEST(ClearanceCheck, SeesAHolderThatSwingsDownBetweenTwoPoints) {
  // Upright at no point, but from +80 to -80 deg: on the way it stands upright under the beam.
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {-5, -5, 104 - 4}, .max_mm = {5, 5, 200}}};
  const auto swing = path_of({{{0, 0, 0}, leaning(80)}, {{0, 0, 0}, leaning(-80)}});
  EXPECT_TRUE(collides(swing, model, {0, 0, 1}));
  EXPECT_FALSE(collides(path_of({{{0, 0, 0}, leaning(80)}}), model, {0, 0, 1}));
  EXPECT_FALSE(collides(path_of({{{0, 0, 0}, leaning(-80)}}), model, {0, 0, 1}));
}

TEST(ClearanceCheck, FollowsAnArcAndNotItsChord) {
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {-5, 95, 0}, .max_mm = {5, 105, 80}}};
  path::ToolPath tool_path;
  tool_path.add_point({100, 0, 0}, up, 1, Move::feed);
  tool_path.add_event(2, path::Arc{.sweep_rad = pi});
  tool_path.add_point({-100, 0, 0}, up, 2, Move::feed);
  EXPECT_TRUE(collides(tool_path, model, {0, 0, 0}));
  // The box on the chord is not met.
  model.jig = {{.min_mm = {-5, -5, 0}, .max_mm = {5, 5, 80}}};
  EXPECT_FALSE(collides(tool_path, model, {0, 0, 0}));
}

TEST(ClearanceCheck, FollowsWholeTurns) {
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {-105, -5, 0}, .max_mm = {-95, 5, 80}}};
  path::ToolPath tool_path;
  tool_path.add_point({100, 0, 0}, up, 1, Move::feed);
  tool_path.add_event(2, path::Arc{.sweep_rad = 2 * pi});
  tool_path.add_point({100, 0, 0}, up, 2, Move::feed);
  EXPECT_TRUE(collides(tool_path, model, {0, 0, 0}));
}

TEST(ClearanceCheck, OfNothingFindsNothing) {
  const auto tool_path = path_of({{{0, 0, -500}, up}});
  EXPECT_FALSE(collides(tool_path, Model{}, {0, 0, 0}));
  Model only_holder;
  only_holder.holder = {holder};
  EXPECT_FALSE(collides(tool_path, only_holder, {0, 0, 0}));
  Model only_table = over_table();
  only_table.holder.clear();
  EXPECT_FALSE(collides(tool_path, only_table, {0, 0, 0}));
}

TEST(ClearanceCheck, OfNoPathFindsNothing) {
  const Check check{path::ToolPath{}, {}, over_table()};
  EXPECT_FALSE(check.first_collision(straight, {0, 0, 0}));
}

TEST(ClearanceCheck, NeedsTheOriginForWhatStandsOnTheTable) {
  const auto tool_path = path_of({{{0, 0, 0}, up}});
  EXPECT_TRUE(check_of(tool_path, over_table()).needs_origin());
  Model model;
  model.holder = {holder};
  model.jig = {{.min_mm = {0, 0, 0}, .max_mm = {1, 1, 1}, .frame = JigBox::Frame::workpiece}};
  EXPECT_FALSE(check_of(tool_path, model).needs_origin());
  model.jig[0].frame = JigBox::Frame::table;
  EXPECT_TRUE(check_of(tool_path, model).needs_origin());
}

TEST(ClearanceCheck, TakesLongerStepsOnlyOnVeryLongPaths) {
  const auto tool_path = path_of({{{0, 0, 0}, up}, {{1000, 0, 0}, up}});
  EXPECT_EQ(check_of(tool_path, over_table()).step_mm(), 0.25);
  std::vector<std::pair<Vec3, Vec3>> there_and_back;
  for (int i = 0; i <= 100; ++i) there_and_back.push_back({{i % 2 * 1e6, 0, 0}, up});
  EXPECT_EQ(check_of(path_of(there_and_back), over_table()).step_mm(), 1.0);
}

TEST(ClearanceCheck, RefusesStretchesOutOfOrder) {
  const auto tool_path = path_of({{{0, 0, 0}, up}, {{1, 0, 0}, up}});
  EXPECT_THROW((Check{tool_path, {{1, 2, 0.0}, {0, 1, 0.0}}, over_table()}), std::logic_error);
  EXPECT_THROW((Check{tool_path, {{0, 3, 0.0}}, over_table()}), std::logic_error);
  EXPECT_THROW((Check{tool_path, {{0, 0, 0.0}}, over_table()}), std::logic_error);
}

}  // namespace
}  // namespace pentapost::clearance
