#include "lib/nc/siemens_reader_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace pentapost {
namespace {

using nc::ReadMotion;
using sample::siemens::expect_refused;
using sample::siemens::last_motion;
using sample::siemens::motions_of;
using sample::siemens::read_after_start;
using Hole = ReadMotion::Hole;
using Kind = ReadMotion::Kind;

ReadMotion hole(std::string_view call) {
  return last_motion("MCALL " + std::string{call} + "\nX1 Y2\nMCALL");
}

TEST(Siemens840dReader, DrillsBehindEveryBlockOfAModalCall) {
  const auto motions = motions_of("MCALL CYCLE81(10,0,2,-15)\nX1 Y2\nM8\nX3\nMCALL\nX4");

  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[0].kind, Kind::drill);
  EXPECT_EQ(motions[0].position, (std::array<double, 5>{1, 2, -15, 0, 0}));
  EXPECT_EQ(motions[0].travel_z_mm, 100.0);
  EXPECT_EQ(motions[0].clearance_z_mm, 2.0);
  EXPECT_EQ(motions[0].retract_z_mm, 10.0);
  EXPECT_EQ(motions[0].feed, 200.0);
  EXPECT_EQ(motions[0].cycle, "CYCLE81");
  EXPECT_EQ(motions[1].travel_z_mm, 10.0);
  EXPECT_EQ(motions[1].position[0], 3.0);
  EXPECT_EQ(motions[2].kind, Kind::rapid);
  EXPECT_EQ(motions[2].position[2], 10.0);
}

TEST(Siemens840dReader, MovesBeforeItDrillsWhereOtherAxesAreStated) {
  const auto motions = motions_of("MCALL CYCLE81(10,0,2,-15)\nG0 X1 Y2 Z20");

  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0].kind, Kind::rapid);
  EXPECT_EQ(motions[0].position[2], 20.0);
  EXPECT_EQ(motions[1].kind, Kind::drill);
  EXPECT_EQ(motions[1].travel_z_mm, 20.0);
}

TEST(Siemens840dReader, TakesARotaryWordThatStaysForNoMove) {
  EXPECT_EQ(motions_of("MCALL CYCLE81(10,0,2,-15)\nX1 Y2 A0 C=DC(0)").size(), 1u);
  EXPECT_EQ(motions_of("MCALL CYCLE81(10,0,2,-15)\nX1 Y2 A0 C5").size(), 2u);
}

TEST(Siemens840dReader, DrillsOnceWhereACycleStandsAlone) {
  const auto motions = motions_of("X5\nCYCLE82(10,0,2,,15,0.5)\nX6");

  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[1].kind, Kind::drill);
  EXPECT_EQ(motions[1].position[0], 5.0);
  EXPECT_EQ(motions[1].position[2], -15.0);
  EXPECT_EQ(motions[1].dwell_s, 0.5);
  EXPECT_EQ(motions[2].kind, Kind::rapid);
}

TEST(Siemens840dReader, ReadsDeepHoles) {
  const auto deep = hole("CYCLE83(10,0,2,-15,,,3,0,0,0,1,1)");
  EXPECT_EQ(deep.hole, Hole::deep);
  EXPECT_EQ(deep.peck_mm, 3.0);
  const auto chips = hole("CYCLE83(10,0,2,-15,0,-4,0,0,0.2,0,1,0,3,,0.5)");
  EXPECT_EQ(chips.hole, Hole::break_chip);
  EXPECT_EQ(chips.peck_mm, 4.0);
  EXPECT_EQ(chips.dwell_s, 0.2);
  EXPECT_EQ(hole("CYCLE83(10,0,2,-15,,,3,1,0,0,1,1)").hole, Hole::other);
}

TEST(Siemens840dReader, TapsByPitchAndSpeed) {
  const auto tap = hole("CYCLE84(10,0,2,-15,,0,3,,0.8,0,477,477)");
  EXPECT_EQ(tap.hole, Hole::tap);
  EXPECT_DOUBLE_EQ(tap.feed, 381.6);
  EXPECT_EQ(tap.pitch_mm, 0.8);
  EXPECT_EQ(hole("CYCLE84(10,0,2,-15,,0,4,,-0.8,0,477,477)").hole, Hole::tap_left);
}

TEST(Siemens840dReader, ReadsTheFeedOfCycle85) {
  const auto bore = hole("CYCLE85(10,0,2,-15,,1,120,240)");
  EXPECT_EQ(bore.hole, Hole::feed_out);
  EXPECT_EQ(bore.feed, 120.0);
  EXPECT_EQ(bore.dwell_s, 1.0);
}

TEST(Siemens840dReader, StopsTheSpindleWithCycle86) {
  const auto read = read_after_start("S100 M3\nMCALL CYCLE86(10,0,2,-15,,0,3,0,0,0,0)\nX1\nX2");
  const auto spindle = read.all<nc::ReadSpindle>();
  using State = nc::ReadSpindle::State;
  ASSERT_EQ(spindle.size(), 4u) << read.message();
  EXPECT_EQ(spindle[1].state, State::off);
  EXPECT_EQ(spindle[2].state, State::clockwise);
  EXPECT_EQ(spindle[3].state, State::off);
  EXPECT_EQ(read.motions().back().hole, Hole::spindle_stop);
  EXPECT_EQ(hole("CYCLE86(10,0,2,-15,,0,3,0.2,0,0,0)").hole, Hole::other);
}

TEST(Siemens840dReader, RefusesCyclesThatItCannotFollow) {
  const auto refused = [](std::string_view block, std::string_view word) {
    expect_refused(block, word, Code::bad_cycle);
  };
  refused("TRAORI\nMCALL CYCLE81(10,0,2,-15)", "TRAORI");
  refused("G18\nMCALL CYCLE81(10,0,2,-15)", "G17");
  refused("MCALL CYCLE81(10,0,2,-15)\nG93 X1 F5", "G93");
  refused("MCALL CYCLE81(10,0,2,-15,10)", "different depths");
  refused("MCALL CYCLE81(-1,0,2,-15)", "order");
  refused("MCALL CYCLE81(10,0,2,15)", "order");
  refused("MCALL CYCLE81(10,0,-2,-15)", "order");
  refused("MCALL CYCLE81(10,0,2,-15,,0,0,1,12)", "parameter 8 of CYCLE81");
  refused("MCALL CYCLE83(10,0,2,-15,,,0,0,0,0,1,1)", "first depth");
  refused("MCALL CYCLE83(10,0,2,-15,,,3,0,0,0,1,2)", "VARI");
  refused("MCALL CYCLE83(10,0,2,-15,,,3,0,0,0,1,1,1)", "another axis");
  refused("MCALL CYCLE84(10,0,2,-15,,0,3,8,,0,477,477)", "MPIT");
  refused("MCALL CYCLE84(10,0,2,-15,,0,3,,0.8,0,0,0)", "speed");
  refused("MCALL CYCLE84(10,0,2,-15,,0,0,,0.8,0,477,0)", "SDAC");
  refused("MCALL CYCLE86(10,0,2,-15,,0,0,0,0,0,0)", "SDIR");
  expect_refused("MCALL CYCLE85(10,0,2,-15,,0,0,0)", "feeds", Code::no_feed);
}

TEST(Siemens840dReader, RefusesCyclesThatAreNotText) {
  expect_refused("MCALL CYCLE81(10,0,2,R5)", "not evaluated");
  expect_refused("MCALL CYCLE81(10,0,2", "parameters");
  expect_refused("MCALL CYCLE81", "without parameters");
  expect_refused("MCALL CYCLE840(10,0,2,-15)", "not understood");
  expect_refused("MCALL SUB_1", "not understood");
  expect_refused("MCALL CYCLE81(10,0,2,-15) X5", "axis words");
  expect_refused("MCALL CYCLE81(10,0,2,-15)\nT6 M6", "modal cycle");
}

}  // namespace
}  // namespace pentapost
