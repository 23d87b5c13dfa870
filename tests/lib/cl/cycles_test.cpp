#include "pentapost/cl/cycles.hpp"

#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace pentapost::cl {
namespace {

using path::Move;

const std::function<bool(std::uint32_t)> none = [](std::uint32_t) { return false; };
const std::function<bool(std::uint32_t)> all = [](std::uint32_t) { return true; };

path::ToolPath one_hole(path::CycleStart cycle, const Vec3& axis = Vec3::UnitZ()) {
  path::ToolPath path;
  path.add_event(1, path::Spindle{path::Spindle::State::clockwise, 1000.0});
  path.add_event(2, path::FeedRate{500.0});
  path.add_point({0, 0, 100}, axis, 3, Move::rapid);
  path.add_event(4, cycle);
  path.add_point({1, 2, 3}, axis, 5, Move::hole);
  path.add_event(6, path::CycleEnd{});
  path.add_point({9, 9, 3}, axis, 7, Move::feed);
  return path;
}

/// Heights above the reference point and kinds of the moves of the hole at CL line 5: "r2 f-5".
std::string moves_of_hole(const path::ToolPath& path) {
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.cl_line[i] != 5) continue;
    const double height_mm = (path.tip_wp_mm[i] - Vec3{1, 2, 3}).dot(path.axis_wp[i]);
    std::string number = std::to_string(height_mm);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    text +=
        (text.empty() ? "" : " ") + std::string{path.move[i] == Move::rapid ? "r" : "f"} + number;
  }
  return text;
}

TEST(ExpandCycles, DrillsInOneGo) {
  EXPECT_EQ(moves_of_hole(expand_cycles(one_hole({.depth_mm = 5, .clearance_mm = 2}), none)),
            "r97 r2 f-5 r2");
}

TEST(ExpandCycles, ReturnsToTheRetractHeight) {
  EXPECT_EQ(moves_of_hole(expand_cycles(
                one_hole({.depth_mm = 5, .clearance_mm = 2, .retract_mm = 20}), none)),
            "r97 r2 f-5 r20");
}

/// The moves from the hole at CL line 20 on, "r20,0,33": rapid to (20, 0, 33).
std::string moves_from_line_20(const path::ToolPath& path) {
  std::string text;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path.cl_line[i] < 20) continue;
    text += (text.empty() ? "" : " ") + std::string{path.move[i] == Move::rapid ? "r" : "f"};
    for (const double component : path.tip_wp_mm[i])
      text += std::to_string(std::lround(component)) + ",";
    text.pop_back();
  }
  return text;
}

/// A hole at (0, 0, 0), then one at `second_mm`, CL line 20; both along `axis`.
path::ToolPath two_holes(const path::CycleStart& cycle, const Vec3& second_mm,
                         const Vec3& axis = Vec3::UnitZ()) {
  path::ToolPath path;
  path.add_event(1, path::FeedRate{500.0});
  path.add_event(1, cycle);
  path.add_point(Vec3::Zero(), axis, 10, Move::hole);
  path.add_point(second_mm, axis, 20, Move::hole);
  return path;
}

TEST(ExpandCycles, RisesToAHigherClearanceBeforeItGoesAcross) {
  const auto path = two_holes({.depth_mm = 10, .clearance_mm = 3}, {20, 0, 30});
  EXPECT_EQ(moves_from_line_20(expand_cycles(path, none)), "r0,0,33 r20,0,33 f20,0,20 r20,0,33");
}

TEST(ExpandCycles, GoesAcrossBeforeItComesDownToALowerClearance) {
  const auto path = two_holes({.depth_mm = 10, .clearance_mm = 3}, {20, 0, -30});
  EXPECT_EQ(moves_from_line_20(expand_cycles(path, none)), "r20,0,3 r20,0,-27 f20,0,-40 r20,0,-27");
}

TEST(ExpandCycles, RisesToTheRetractHeightOfAHigherHole) {
  const auto path = two_holes({.depth_mm = 10, .clearance_mm = 3, .retract_mm = 8.0}, {20, 0, 30});
  EXPECT_EQ(moves_from_line_20(expand_cycles(path, none)),
            "r0,0,38 r20,0,38 r20,0,33 f20,0,20 r20,0,38");
}

TEST(ExpandCycles, RisesAlongATiltedAxis) {
  const auto path = two_holes({.depth_mm = 10, .clearance_mm = 3}, {30, 20, 0}, Vec3::UnitX());
  EXPECT_EQ(moves_from_line_20(expand_cycles(path, none)), "r33,0,0 r33,20,0 f20,20,0 r33,20,0");
}

TEST(ExpandCycles, RisesFromAMoveBelowTheClearance) {
  auto path = two_holes({.depth_mm = 10, .clearance_mm = 3}, {20, 0, 0});
  path.move[0] = Move::feed;
  EXPECT_EQ(moves_from_line_20(expand_cycles(path, none)), "r0,0,3 r20,0,3 f20,0,-10 r20,0,3");
}

TEST(ExpandCycles, RisesFromANativeHole) {
  const auto path = two_holes({.depth_mm = 10, .clearance_mm = 3}, {20, 0, 30});
  EXPECT_EQ(moves_from_line_20(expand_cycles(path, [](std::uint32_t point) { return point == 0; })),
            "r0,0,33 r20,0,33 f20,0,20 r20,0,33");
}

/// From there the tool comes down along its axis; where it was before says nothing.
TEST(ExpandCycles, ComesFromAToolChangeOrHomeStraightToTheHole) {
  for (const path::EventKind& event :
       {path::EventKind{path::ToolChange{.number = 2}}, path::EventKind{path::GoHome{}}}) {
    auto path = two_holes({.depth_mm = 10, .clearance_mm = 3}, {20, 0, 30});
    path.events.push_back({1, 15, event});
    EXPECT_EQ(moves_from_line_20(expand_cycles(path, none)), "r20,0,33 f20,0,20 r20,0,33");
  }
}

TEST(ExpandCycles, ACallOfTheToolInUseChangesNoWay) {
  auto path = two_holes({.depth_mm = 10, .clearance_mm = 3}, {20, 0, 30});
  path.events.push_back({1, 15, path::ToolChange{.number = 1}});
  EXPECT_EQ(moves_from_line_20(expand_cycles(path, none)), "r0,0,33 r20,0,33 f20,0,20 r20,0,33");
}

/// Radial holes of a cylinder: the straight way from one to the next leads through it.
TEST(ExpandCycles, GoesByWayOfHomeToAHoleWithAnotherToolAxis) {
  auto path = two_holes({.depth_mm = 10, .clearance_mm = 3}, {20, 0, 0});
  path.axis_wp[1] = Vec3::UnitX();
  const auto expanded = expand_cycles(path, none);
  EXPECT_EQ(moves_from_line_20(expanded), "r23,0,0 f10,0,0 r23,0,0");
  const auto home = std::find_if(
      expanded.events.begin(), expanded.events.end(),
      [](const path::Event& event) { return std::holds_alternative<path::GoHome>(event.what); });
  ASSERT_NE(home, expanded.events.end());
  EXPECT_EQ(home->before_point, 3U);
  EXPECT_EQ(expanded.tip_wp_mm[2], Vec3(0, 0, 3));
}

TEST(ExpandCycles, PecksDeepHolesWithFullRetracts) {
  EXPECT_EQ(moves_of_hole(expand_cycles(one_hole({.kind = path::CycleStart::Kind::deep,
                                                  .depth_mm = 5,
                                                  .clearance_mm = 2,
                                                  .peck_mm = 2}),
                                        none)),
            "r97 r2 f-2 r2 r-1.5 f-4 r2 r-3.5 f-5 r2");
}

TEST(ExpandCycles, BreaksChipsWithSmallRetracts) {
  EXPECT_EQ(moves_of_hole(expand_cycles(one_hole({.kind = path::CycleStart::Kind::break_chip,
                                                  .depth_mm = 4,
                                                  .clearance_mm = 1,
                                                  .peck_mm = 2}),
                                        none)),
            "r97 r1 f-2 r-1.75 f-4 r1");
}

/// As the native cycles do: G85 feeds out, G86 stops the spindle and leaves at rapid rate (FANUC
/// Series 0i, 30i operator's manuals, canned cycles).
TEST(ExpandCycles, FeedsOutOfReamedAndBoredHoles) {
  for (const auto kind : {path::CycleStart::Kind::ream, path::CycleStart::Kind::bore})
    EXPECT_EQ(
        moves_of_hole(expand_cycles(
            one_hole({.kind = kind, .depth_mm = 4, .clearance_mm = 1, .retract_mm = 9}), none)),
        "r97 r1 f-4 f1 r9");
}

TEST(ExpandCycles, DwellsAtTheBottom) {
  const auto path =
      expand_cycles(one_hole({.depth_mm = 5, .clearance_mm = 2, .dwell_s = 0.5}), none);
  for (const auto& event : path.events)
    if (std::holds_alternative<path::Dwell>(event.what)) {
      EXPECT_EQ(path.tip_wp_mm[event.before_point - 1], Vec3(1, 2, -2));
    }
  EXPECT_EQ(events_of<path::Dwell>(path).size(), 1U);
}

TEST(ExpandCycles, ReversesTheSpindleAtTheBottomOfATap) {
  const auto path = expand_cycles(
      one_hole(
          {.kind = path::CycleStart::Kind::tap, .depth_mm = 5, .clearance_mm = 2, .pitch_mm = 1.5}),
      none);
  EXPECT_EQ(moves_of_hole(path), "r97 r2 f-5 f2");
  const auto spindles = events_of<path::Spindle>(path);
  ASSERT_EQ(spindles.size(), 3U);
  EXPECT_EQ(spindles[1].state, path::Spindle::State::counterclockwise);
  EXPECT_EQ(spindles[2].state, path::Spindle::State::clockwise);
  EXPECT_EQ(events_of<path::FeedRate>(path)[1].value, 1500.0);
}

TEST(ExpandCycles, WarnsOnceACycleOfTapsWithoutCoupledSpindle) {
  path::ToolPath path = one_hole(
      {.kind = path::CycleStart::Kind::tap, .depth_mm = 5, .clearance_mm = 2, .pitch_mm = 1.5});
  path.move[2] = Move::hole;  // behind the end of the cycle: none
  Diagnostics diagnostics;
  expand_cycles(path, none, &diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 1U);
  EXPECT_EQ(diagnostics.list()[0].code, Code::cycle_expanded);
  EXPECT_EQ(diagnostics.list()[0].cl_line, 4U);

  Diagnostics of_native;
  expand_cycles(path, all, &of_native);
  EXPECT_TRUE(of_native.list().empty());
}

TEST(ExpandCycles, StopsTheSpindleToDragOutOfABore) {
  const auto spindles = events_of<path::Spindle>(expand_cycles(
      one_hole({.kind = path::CycleStart::Kind::bore_drag, .depth_mm = 5, .clearance_mm = 2}),
      none));
  ASSERT_EQ(spindles.size(), 3U);
  EXPECT_EQ(spindles[1].state, path::Spindle::State::off);
  EXPECT_EQ(spindles[2].state, path::Spindle::State::clockwise);
}

TEST(ExpandCycles, RestoresTheFeedBehindTheHole) {
  const auto path =
      expand_cycles(one_hole({.depth_mm = 5, .clearance_mm = 2, .feed_mm_min = 80.0}), none);
  const auto feeds = events_of<path::FeedRate>(path);
  ASSERT_EQ(feeds.size(), 3U);
  EXPECT_EQ(feeds[0].value, 500.0);
  EXPECT_EQ(feeds[1].value, 80.0);
  EXPECT_EQ(feeds[2].value, 500.0);
  EXPECT_EQ(path.events.back().before_point, path.size() - 1);
}

TEST(ExpandCycles, FollowsATiltedAxis) {
  const auto path =
      expand_cycles(one_hole({.depth_mm = 5, .clearance_mm = 2}, Vec3::UnitX()), none);
  EXPECT_EQ(path.tip_wp_mm[1], Vec3(3, 0, 100));
  EXPECT_EQ(path.tip_wp_mm[2], Vec3(3, 2, 3));
  EXPECT_EQ(path.tip_wp_mm[3], Vec3(-4, 2, 3));
}

TEST(ExpandCycles, LeavesNativeHolesWithTheirEvents) {
  const auto before = one_hole({.depth_mm = 5, .clearance_mm = 2, .feed_mm_min = 80.0});
  const auto path = expand_cycles(before, all);
  EXPECT_EQ(path.move, before.move);
  EXPECT_EQ(events_of<path::CycleStart>(path).size(), 1U);
  EXPECT_EQ(events_of<path::CycleEnd>(path).size(), 1U);
}

TEST(ExpandCycles, EndsTheNativeCycleAroundAnExpandedHole) {
  const auto result = read_as("creo-ncl",
                              "UNITS/MM\nFEDRAT/5,MMPM\nCYCLE/DRILL,DEPTH,3,CLEAR,1\nGOTO/1,0,0\n"
                              "GOTO/2,0,0,0,1,0\nGOTO/3,0,0,0,0,1\nCYCLE/OFF\n");
  const auto path = expand_cycles(result.path, [](std::uint32_t point) { return point != 1; });
  EXPECT_EQ(path.move,
            (std::vector<Move>{Move::hole, Move::rapid, Move::feed, Move::rapid, Move::hole}));
  EXPECT_EQ(events_of<path::CycleStart>(path).size(), 2U);
  EXPECT_EQ(events_of<path::CycleEnd>(path).size(), 2U);
}

TEST(ExpandCycles, KeepsWhatIsNoHole) {
  const auto before =
      read("UNITS/MM\nPARTNO/X\nLOADTL/3\nFEDRAT/9\nGOTO/1,2,3,0,0.6,0.8\nGOTO/1,2,4\n").path;
  const auto path = expand_cycles(before, none);
  EXPECT_EQ(path.tip_wp_mm, before.tip_wp_mm);
  EXPECT_EQ(path.events.size(), before.events.size());
  EXPECT_EQ(path.program_name, "X");
  EXPECT_EQ(path.axis_rounding_rad, before.axis_rounding_rad);
  EXPECT_TRUE(path.has_tool_change);
}

}  // namespace
}  // namespace pentapost::cl
