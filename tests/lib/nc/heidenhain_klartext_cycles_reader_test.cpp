#include "lib/nc/klartext_reader_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace pentapost;
using nc::ReadMotion;
using Hole = ReadMotion::Hole;

const std::string start = "TOOL CALL 1 Z S600\nM3\nL X+0 Y+0 Z+50 A+0 C+0 R0 FMAX\n";
const std::string levels = "Q200=+2 ;SET-UP CLEARANCE ~\n Q201=-10 ~\n Q203=+1 ~\n Q204=+20 ~\n";

ReadMotion last(const std::string& blocks) { return sample::klartext::last(start + blocks); }
std::string refusal(const std::string& blocks) { return sample::klartext::refusal(start + blocks); }

/// A hole by the cycle of this number with these parameters beside its levels.
ReadMotion hole(const std::string& number, const std::string& parameters) {
  return last("CYCL DEF " + number + " NAME OF IT ~\n" + levels + parameters +
              "\nL X+5 Y+6 R0 FMAX M99\n");
}

TEST(HeidenhainKlartextHoles, HaveTheirLevels) {
  const auto drilled = hole("200", "Q206=+150 ~\nQ202=+10 ~\nQ210=+0 ~\nQ211=+0.5");

  EXPECT_EQ(drilled.kind, ReadMotion::Kind::drill);
  EXPECT_EQ(drilled.position[0], 5.0);
  EXPECT_EQ(drilled.position[1], 6.0);
  EXPECT_EQ(drilled.position[2], -9.0);
  EXPECT_EQ(drilled.stated, 0x07);
  EXPECT_EQ(drilled.travel_z_mm, 50.0);
  EXPECT_EQ(drilled.clearance_z_mm, 3.0);
  EXPECT_EQ(drilled.retract_z_mm, 21.0);
  EXPECT_EQ(drilled.feed, 150.0);
  EXPECT_EQ(drilled.dwell_s, 0.5);
  EXPECT_EQ(drilled.hole, Hole::drill);
  EXPECT_EQ(drilled.peck_mm, 0.0);
  EXPECT_EQ(drilled.cycle, "CYCL DEF 200");
}

TEST(HeidenhainKlartextHoles, LeaveTheToolAtTheHigherClearance) {
  const auto lower = last(
      "CYCL DEF 200 A ~\nQ200=2 ~\nQ201=-10 ~\nQ206=9 ~\nQ202=10 ~\nQ203=1 ~\nQ204=0\n"
      "L X+5 Y+5 FMAX M99\nL X+6 FMAX M99\n");

  EXPECT_EQ(lower.retract_z_mm, 3.0);
  EXPECT_EQ(lower.travel_z_mm, 3.0);
}

TEST(HeidenhainKlartextHoles, PeckAsTheirCycleSays) {
  const std::string feed = "Q206=150 ~\n";
  EXPECT_EQ(hole("200", feed + "Q202=3").hole, Hole::deep);
  EXPECT_EQ(hole("200", feed + "Q202=3").peck_mm, 3.0);
  EXPECT_EQ(hole("203", feed + "Q202=3 ~\nQ213=0").hole, Hole::deep);
  EXPECT_EQ(hole("203", feed + "Q202=3 ~\nQ213=3").hole, Hole::break_chip);
  EXPECT_EQ(hole("203", feed + "Q202=3 ~\nQ213=2").hole, Hole::other);
  EXPECT_EQ(hole("203", feed + "Q202=15").hole, Hole::drill);
  EXPECT_EQ(hole("205", feed + "Q202=3").hole, Hole::deep);
  EXPECT_EQ(hole("205", feed + "Q202=3").peck_mm, 3.0);
  EXPECT_EQ(hole("205", feed + "Q202=10 ~\nQ257=2").hole, Hole::break_chip);
  EXPECT_EQ(hole("205", feed + "Q202=10 ~\nQ257=2").peck_mm, 2.0);
  EXPECT_EQ(hole("205", feed + "Q202=5 ~\nQ257=2").hole, Hole::other);
}

TEST(HeidenhainKlartextHoles, AreReamedBoredAndCentred) {
  EXPECT_EQ(hole("201", "Q206=150 ~\nQ211=0 ~\nQ208=500").hole, Hole::feed_out);
  EXPECT_EQ(hole("202", "Q206=150 ~\nQ211=0 ~\nQ208=500 ~\nQ214=0 ~\nQ336=0").hole,
            Hole::spindle_stop);
  EXPECT_EQ(hole("202", "Q206=150 ~\nQ211=0 ~\nQ208=500 ~\nQ214=1 ~\nQ336=0").hole, Hole::other);
  EXPECT_EQ(hole("240", "Q343=0 ~\nQ344=-10 ~\nQ206=150 ~\nQ211=0").hole, Hole::drill);
}

TEST(HeidenhainKlartextHoles, AreTappedByPitchOrByFeed) {
  const auto right = hole("207", "Q239=+1.25");
  EXPECT_EQ(right.hole, Hole::tap);
  EXPECT_EQ(right.pitch_mm, 1.25);
  EXPECT_EQ(right.feed, 750.0);
  EXPECT_EQ(hole("207", "Q239=-1.25").hole, Hole::tap_left);
  const auto floating = hole("206", "Q206=750 ~\nQ211=0");
  EXPECT_EQ(floating.hole, Hole::tap);
  EXPECT_EQ(floating.pitch_mm, 0.0);
  EXPECT_EQ(floating.feed, 750.0);
  EXPECT_EQ(hole("209", "Q239=+1 ~\nQ257=3 ~\nQ256=0 ~\nQ336=0 ~\nQ403=1").peck_mm, 3.0);
}

TEST(HeidenhainKlartextHoles, AreCalledWithoutAWay) {
  const std::string definition =
      "CYCL DEF 200 A ~\n" + levels + "Q206=150 ~\nQ202=10\nL X+5 Y+6 Z+40 FMAX\n";

  for (const char* call : {"CYCL CALL\n", "CYCL CALL M8\n", "M99\n"}) {
    const auto drilled = last(definition + call);
    EXPECT_EQ(drilled.kind, ReadMotion::Kind::drill) << call;
    EXPECT_EQ(drilled.stated, 0x04);
    EXPECT_EQ(drilled.position[0], 5.0);
    EXPECT_EQ(drilled.travel_z_mm, 40.0);
  }
}

TEST(HeidenhainKlartextHoles, FollowTheMotionOfTheirBlock) {
  const auto all = sample::klartext::motions(start + "CYCL DEF 200 A ~\n" + levels +
                                             "Q206=150 ~\nQ202=10\nL X+5 Y+6 Z+40 FMAX M99\n");

  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[1].kind, ReadMotion::Kind::rapid);
  EXPECT_EQ(all[2].kind, ReadMotion::Kind::drill);
  EXPECT_EQ(all[2].travel_z_mm, 40.0);
}

TEST(HeidenhainKlartextHoles, LeaveTheSpindleStoppedBehindARigidTap) {
  const std::string taps =
      start + "CYCL DEF 207 A ~\n" + levels + "Q239=1\nL X+5 Y+6 FMAX M99\nL X+9 FMAX M99\n";

  EXPECT_EQ(sample::klartext::read(taps).all<nc::ReadSpindle>().size(), 1u);
  const auto stopped = sample::klartext::read(taps + "L X+1 FMAX\n").all<nc::ReadSpindle>();
  ASSERT_EQ(stopped.size(), 2u);
  EXPECT_EQ(stopped[1].state, nc::ReadSpindle::State::off);
  const auto started = sample::klartext::read(taps + "M3\nL X+1 FMAX\n").all<nc::ReadSpindle>();
  ASSERT_EQ(started.size(), 2u);
  EXPECT_EQ(started[1].state, nc::ReadSpindle::State::clockwise);
}

TEST(HeidenhainKlartextHoles, TakeTheNewerParametersAndWordsForFeeds) {
  EXPECT_EQ(hole("200", "Q206=150 ~\nQ202=10 ~\nQ395=+0 ;DEPTH REFERENCE").hole, Hole::drill);
  EXPECT_EQ(hole("203", "Q206=150 ~\nQ202=10 ~\nQ208=MAX ;RETRACTION").hole, Hole::drill);
}

TEST(HeidenhainKlartextHoles, AreRefusedWhereTheyAreNotCertain) {
  const std::string feed = levels + "Q206=150 ~\n";
  for (const std::string& bad : {
           std::string{"L X+1 FMAX M99\n"},
           "CYCL DEF 200 A ~\n" + levels + "Q202=10\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=0\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=10 ~\nQ395=1\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=10 ~\nQ202=9\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=10 ~\nQ999=9\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=10 ~\nX+5\n",
           "CYCL DEF 200 A ~\n" + levels + "Q206=MAX ~\nQ202=10\n",
           "CYCL DEF 200 A ~\n" + levels + "Q206=0 ~\nQ202=10\n",
           "CYCL DEF 203 A ~\n" + feed + "Q202=3 ~\nQ212=1\n",
           "CYCL DEF 205 A ~\n" + feed + "Q202=3 ~\nQ379=1\n",
           "CYCL DEF 207 A ~\n" + levels + "Q239=0\n",
           "CYCL DEF 207 A ~\n" + levels + "Q239=100\n",
           "CYCL DEF 240 A ~\n" + feed + "Q343=1\n",
           std::string{
               "CYCL DEF 200 A ~\nQ200=2 ~\nQ201=10 ~\nQ203=0 ~\nQ204=2 ~\nQ206=9 ~\nQ202=9\n"},
           std::string{
               "CYCL DEF 200 A ~\nQ200=-2 ~\nQ201=-9 ~\nQ203=0 ~\nQ204=2 ~\nQ206=9 ~\nQ202=9\n"},
           "CYCL DEF 200 A ~\n" + feed + "Q202=9\nM128\nL X+1 FMAX M99\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=9\nM136\nL X+1 FMAX M99\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=9\nL X+1 FMAX M91 M99\n",
           "CYCL DEF 200 A ~\n" + feed + "Q202=9\nM140 MB MAX M99\n",
       })
    EXPECT_NE(refusal(bad), "");
  EXPECT_EQ(sample::klartext::refusal("CYCL DEF 207 A ~\n" + levels +
                                      "Q239=1\nTOOL CALL 1 Z\nL X+1 FMAX M99\n"),
            "a tap without a spindle speed");
  EXPECT_EQ(sample::klartext::refusal("CYCL DEF 207 A ~\n" + levels + "Q239=1\nL X+1 FMAX M99\n"),
            "a cycle before TOOL CALL with the tool axis Z");
}

}  // namespace
