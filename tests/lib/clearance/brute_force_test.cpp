// The check against one that looks at every place by itself, without any bound or order of search.

#include "pentapost/clearance/check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace pentapost::clearance {
namespace {

using path::Move;

struct Placement {
  Mat3 turn;
  Vec3 origin_mm;
};

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_{seed} {}
  double between(double lower, double upper) {
    return std::uniform_real_distribution{lower, upper}(engine_);
  }
  int count(int lower, int upper) { return std::uniform_int_distribution{lower, upper}(engine_); }
  Vec3 within(double reach_mm) {
    return {between(-reach_mm, reach_mm), between(-reach_mm, reach_mm),
            between(-reach_mm, reach_mm)};
  }
  Vec3 direction() { return Vec3{within(1.0) + Vec3{0, 0, 1e-3}}.normalized(); }

  Placement setup() {
    return {.turn = Eigen::AngleAxisd{between(0, 1.5), direction()}.toRotationMatrix(),
            .origin_mm = within(60) + Vec3{0, 0, between(-40, 120)}};
  }
  machine::ToolCylinder cylinder(double from_mm) {
    return {.radius_mm = between(5, 50), .from_mm = from_mm, .to_mm = from_mm + between(5, 120)};
  }
  JigBox box() {
    const Vec3 corner = within(150);
    return {.min_mm = corner,
            .max_mm = corner + Vec3{between(5, 60), between(5, 60), between(5, 60)},
            .frame = count(0, 1) == 0 ? JigBox::Frame::table : JigBox::Frame::workpiece};
  }
  Model model() {
    Model model;
    for (int i = count(0, 2); i > 0; --i) model.holder.push_back(cylinder(between(20, 90)));
    if (count(0, 1) == 1) model.machine.spindle = {{cylinder(between(0, 20))}};
    if (count(0, 2) > 0)
      model.machine.table =
          machine::TableDisc{.radius_mm = between(50, 300),
                             .centre_mm = within(20),
                             .normal = UnitVector::normalised(Vec3{0, 0, 1} + 0.2 * direction()),
                             .thickness_mm = between(5, 100)};
    for (int i = count(0, 2); i > 0; --i) model.jig.push_back(box());
    model.safety_mm = count(0, 3) == 0 ? 0.0 : between(0.1, 10);
    return model;
  }
  path::ToolPath path(int points) {
    path::ToolPath tool_path;
    Vec3 tip_mm = within(50), axis = direction();
    for (int i = 0; i < points; ++i) {
      tip_mm += within(count(0, 9) == 0 ? 60 : 2);
      axis = (axis + within(count(0, 9) == 0 ? 0.5 : 0.03)).normalized();
      tool_path.add_point(tip_mm, axis, static_cast<std::uint32_t>(i + 1),
                          count(0, 9) == 0 ? Move::rapid : Move::feed);
    }
    return tool_path;
  }

 private:
  std::mt19937_64 engine_;
};

/// Where the tool is at `fraction` of a straight move.
Pose between(const path::ToolPath& tool_path, std::uint32_t point, double fraction) {
  const path::Segment segment{tool_path.tip_wp_mm[point - 1], tool_path.axis_wp[point - 1],
                              tool_path.tip_wp_mm[point], tool_path.axis_wp[point]};
  return {.tip_mm = segment.tip_mm(fraction), .axis = segment.axis(fraction)};
}

/// Every tool body in the base frame against every obstacle there.
class Scene {
 public:
  Scene(const Model& model, const Placement& setup, double gauge_length_mm, double margin_mm)
      : setup_{setup}, margin_mm_{margin_mm} {
    for (const auto& cylinder : model.holder) cylinders_.push_back(cylinder);
    if (model.machine.spindle)
      for (auto cylinder : *model.machine.spindle) {
        cylinder.from_mm += gauge_length_mm;
        cylinder.to_mm += gauge_length_mm;
        cylinders_.push_back(cylinder);
      }
    if (const auto& table = model.machine.table)
      obstacles_.push_back(
          Cylinder{.centre_mm = table->centre_mm - table->thickness_mm / 2 * table->normal.vec(),
                   .axis = table->normal.vec(),
                   .half_length_mm = table->thickness_mm / 2,
                   .radius_mm = table->radius_mm});
    for (const auto& jig : model.jig) {
      Box box{.centre_mm = (jig.min_mm + jig.max_mm) / 2,
              .half_size_mm = (jig.max_mm - jig.min_mm) / 2};
      if (jig.frame == JigBox::Frame::workpiece) {
        box.centre_mm = setup.turn * box.centre_mm + setup.origin_mm;
        box.directions = setup.turn;
      }
      obstacles_.push_back(box);
    }
  }

  bool collides(const Pose& pose) const {
    const Vec3 tip_mm = setup_.turn * pose.tip_mm + setup_.origin_mm;
    const Vec3 axis = setup_.turn * pose.axis;
    for (const auto& cylinder : cylinders_)
      for (const auto& obstacle : obstacles_)
        if (is_within({.centre_mm = tip_mm + (cylinder.from_mm + cylinder.to_mm) / 2 * axis,
                       .axis = axis,
                       .half_length_mm = (cylinder.to_mm - cylinder.from_mm) / 2,
                       .radius_mm = cylinder.radius_mm},
                      obstacle, margin_mm_))
          return true;
    return false;
  }

 private:
  Placement setup_;
  double margin_mm_;
  std::vector<machine::ToolCylinder> cylinders_;
  std::vector<Obstacle> obstacles_;
};

/// First point of the path that collides; `steps` places on each move count for its end.
std::optional<std::uint32_t> naive_first(const path::ToolPath& tool_path, const Scene& scene,
                                         int steps) {
  for (std::uint32_t i = 0; i < tool_path.size(); ++i) {
    if (i > 0 && tool_path.move[i] == Move::feed)
      for (int step = 1; step < steps; ++step)
        if (scene.collides(between(tool_path, i, static_cast<double>(step) / steps))) return i;
    if (scene.collides({.tip_mm = tool_path.tip_wp_mm[i], .axis = tool_path.axis_wp[i]})) return i;
  }
  return std::nullopt;
}

constexpr double gauge_length_mm = 130.0;
constexpr std::uint32_t never = 0xffffffff;

TEST(ClearanceCheck, OfPointsAloneFindsWhatNaiveSearchFinds) {
  Random random{1};
  int colliding = 0, clear = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    auto tool_path = random.path(random.count(1, 150));
    std::fill(tool_path.move.begin(), tool_path.move.end(), Move::rapid);
    const Model model = random.model();
    const auto size = static_cast<std::uint32_t>(tool_path.size());
    const Check check{tool_path, {{0, size, gauge_length_mm}}, model};
    for (int j = 0; j < 5; ++j) {
      const Placement setup = random.setup();
      const auto found = check.first_collision(setup.turn, setup.origin_mm);
      const auto naive =
          naive_first(tool_path, {model, setup, gauge_length_mm, model.safety_mm}, 1);
      ASSERT_EQ(found.has_value(), naive.has_value());
      if (found) {
        ASSERT_EQ(found->point, *naive);
        ASSERT_LE(found->distance_mm, model.safety_mm + 1e-3);
      }
      ++(found ? colliding : clear);
    }
  }
  EXPECT_GT(colliding, 300);
  EXPECT_GT(clear, 300);
}

// Between points the two look at other places: what the naive search finds with the whole step of
// margin inside the safety distance must be found, what it doesn't find without must not.
TEST(ClearanceCheck, OfMovesFindsWhatNaiveSearchFindsWithinItsStep) {
  Random random{2};
  int colliding = 0, clear = 0;
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE(i);
    const auto tool_path = random.path(random.count(2, 40));
    Model model = random.model();
    model.safety_mm += 1.0;
    const auto size = static_cast<std::uint32_t>(tool_path.size());
    const Check check{tool_path, {{0, size, gauge_length_mm}}, model};
    ASSERT_EQ(check.step_mm(), 0.25);
    for (int j = 0; j < 3; ++j) {
      const Placement setup = random.setup();
      const auto found = check.first_collision(setup.turn, setup.origin_mm);
      const std::uint32_t point = found ? found->point : never;
      const double step_mm = check.step_mm() + 1e-3;
      const Scene inner{model, setup, gauge_length_mm, model.safety_mm - step_mm};
      ASSERT_LE(point, naive_first(tool_path, inner, 100).value_or(never));
      const Scene outer{model, setup, gauge_length_mm, model.safety_mm + step_mm};
      ASSERT_GE(point, naive_first(tool_path, outer, 300).value_or(never));
      ++(found ? colliding : clear);
    }
  }
  EXPECT_GT(colliding, 50);
  EXPECT_GT(clear, 50);
}

TEST(ClearanceCheck, OfAHundredThousandPointsFindsTheOneThatCollides) {
  path::ToolPath tool_path;
  constexpr std::uint32_t size = 100'000, deepest = 77'777;
  for (std::uint32_t i = 0; i < size; ++i) {
    const double turn_rad = 1e-3 * i;
    const double tilt_rad = 0.3 * std::sin(7e-4 * i);
    tool_path.add_point(
        {50 * std::cos(turn_rad), 50 * std::sin(turn_rad), i == deepest ? -9.0 : 0.0},
        {std::sin(tilt_rad), 0.0, std::cos(tilt_rad)}, i + 1, Move::feed);
  }
  Model model;
  model.holder = {{.radius_mm = 20, .from_mm = 50, .to_mm = 100}};
  model.machine.table = machine::TableDisc{.radius_mm = 300};
  const Check check{tool_path, {{0, size, 0.0}}, model};
  // At the deepest point it leans by 0.3 sin(54.4439) = -0.25824 rad: 43.2345 mm above the tip.
  EXPECT_FALSE(check.first_collision(Mat3::Identity(), {0, 0, -32.2344}));
  const auto collision = check.first_collision(Mat3::Identity(), {0, 0, -32.2346});
  ASSERT_TRUE(collision);
  EXPECT_EQ(collision->point, deepest);
}

}  // namespace
}  // namespace pentapost::clearance
