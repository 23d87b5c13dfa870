#include "lib/nc/klartext_reader_case.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace pentapost;
using nc::ReadMotion;

const std::string start = "TOOL CALL 1 Z S100\nL X+10 Y+0 Z+0 A+0 C+0 F100\n";

ReadMotion last(const std::string& blocks) { return sample::klartext::last(start + blocks); }
std::string refusal(const std::string& blocks) { return sample::klartext::refusal(start + blocks); }

TEST(HeidenhainKlartextArcs, AreReadAboutThePole) {
  const auto arc = last("CC X+0 Y+0\nC X+0 Y+10 DR+ R0 F80\n");

  EXPECT_EQ(arc.kind, ReadMotion::Kind::arc);
  EXPECT_FALSE(arc.clockwise);
  EXPECT_EQ(arc.centre_x_mm, 0.0);
  EXPECT_EQ(arc.centre_y_mm, 0.0);
  EXPECT_EQ(arc.whole_turns, 0);
  EXPECT_EQ(arc.feed, 80.0);
  EXPECT_TRUE(last("CC X+0 Y+0\nC X+0 Y+10 DR-\n").clockwise);
}

TEST(HeidenhainKlartextArcs, RunAWholeTurnToWhereTheyStart) {
  const auto arc = last("CC X+0 Y+0\nC X+10 Y+0 DR-\n");

  EXPECT_EQ(arc.whole_turns, 1);
}

TEST(HeidenhainKlartextArcs, MayLeaveOutACoordinateThatStays) {
  EXPECT_EQ(last("CC X+0 Y+0\nC X-10 DR-\n").position[1], 0.0);
}

TEST(HeidenhainKlartextArcs, TakeThePoleFromWhereTheToolIs) {
  EXPECT_EQ(last("CC IX-10 IY+0\nC X+0 Y+10 DR+\n").centre_x_mm, 0.0);
  EXPECT_EQ(last("CC\nL X+20 Y+0\nC X+10 Y+10 DR+\n").centre_x_mm, 10.0);
}

TEST(HeidenhainKlartextArcs, MayRiseOnTheirWay) {
  EXPECT_EQ(last("CC X+0 Y+0\nC X+0 Y+10 Z-3 DR+\n").position[2], -3.0);
}

TEST(HeidenhainKlartextArcs, AreReadByTheirRadius) {
  const auto small = last("CR X+0 Y+10 R+10 DR+\n");
  EXPECT_NEAR(small.centre_x_mm, 0.0, 1e-12);
  EXPECT_NEAR(small.centre_y_mm, 0.0, 1e-12);
  const auto large = last("CR X+0 Y+10 R-10 DR+ R0 F50\n");
  EXPECT_NEAR(large.centre_x_mm, 10.0, 1e-12);
  EXPECT_NEAR(large.centre_y_mm, 10.0, 1e-12);
  EXPECT_NEAR(last("CR X+0 Y+10 R10 DR-\n").centre_x_mm, 10.0, 1e-12);
}

TEST(HeidenhainKlartextArcs, AreReadByPolarAngles) {
  const auto arc = last("CC X+0 Y+0\nCP PA+90 DR+\n");

  EXPECT_NEAR(arc.position[0], 0.0, 1e-12);
  EXPECT_NEAR(arc.position[1], 10.0, 1e-12);
  EXPECT_EQ(arc.whole_turns, 0);
}

TEST(HeidenhainKlartextArcs, CountTheTurnsOfAHelix) {
  const auto helix = last("CC X+0 Y+0\nCP IPA-1890 IZ+5 DR-\n");

  EXPECT_TRUE(helix.clockwise);
  EXPECT_EQ(helix.whole_turns, 5);
  EXPECT_NEAR(helix.position[0], 0.0, 1e-12);
  EXPECT_NEAR(helix.position[1], -10.0, 1e-12);
  EXPECT_EQ(helix.position[2], 5.0);
}

TEST(HeidenhainKlartextArcs, EndWholeHelixTurnsExactlyWhereTheyStart) {
  const auto helix = last("CC X+0 Y+0\nCP IPA+1080 Z-3 DR+\n");

  EXPECT_EQ(helix.whole_turns, 3);
  EXPECT_EQ(helix.position[0], 10.0);
  EXPECT_EQ(helix.position[1], 0.0);
}

TEST(HeidenhainKlartextArcs, RunStraightToPolarCoordinates) {
  const auto line = last("CC X+10 Y+10\nLP PR+20 PA+90 FMAX\n");

  EXPECT_EQ(line.kind, ReadMotion::Kind::rapid);
  EXPECT_NEAR(line.position[0], 10.0, 1e-12);
  EXPECT_NEAR(line.position[1], 30.0, 1e-12);
  EXPECT_EQ(line.stated, 0x03);
}

TEST(HeidenhainKlartextArcs, AreRefusedWhereTheyAreNotCertain) {
  for (const char* bad : {"C X+0 Y+10 DR+\n",
                          "CC X+0 Y+0\nC X+0 Y+10\n",
                          "CC X+0 Y+0\nC DR+\n",
                          "CC X+0 Y+0\nC X+0 Y+11 DR+\n",
                          "CC X+10 Y+0\nC X+0 Y+11 DR+\n",
                          "CC X+5\n",
                          "CC Z+5\n",
                          "CC X+0 Y+0\nC X+0 Y+10 A+5 DR+\n",
                          "CC X+0 Y+0\nC X+0 Y+10 DR+ FMAX\n",
                          "CR X+0 Y+10 DR+\n",
                          "CR X+0 Y+10 R+1 DR+\n",
                          "CR X+10 Y+0 R+10 DR+\n",
                          "CR X+0 Y+10 R+0 DR+\n",
                          "CC X+0 Y+0\nCP DR+\n",
                          "CC X+0 Y+0\nCP IPA+0 DR+\n",
                          "CC X+0 Y+0\nCP IPA-90 DR+\n",
                          "CC X+0 Y+0\nCP PA+400 DR+\n",
                          "CC X+0 Y+0\nCP PR+10 PA+90 DR+\n",
                          "CC X+0 Y+0\nCP X+5 PA+90 DR+\n",
                          "LP PR+5 PA+5\n",
                          "CC X+0 Y+0\nLP PR+5 IPA+5\n",
                          "CC X+0 Y+0\nLP PA+5\n",
                          "CC X+0 Y+0\nC X+0 Y+10 DR+ M91\n",
                          "CC X+0 Y+0\nC X+0 Y+10 DR\n",
                          "CC X+0 Y+0\nC X+0 Y+10 DR+ DR-\n"})
    EXPECT_NE(refusal(bad), "");
}

TEST(HeidenhainKlartextArcs, NeedToKnowWhereTheToolAxisAndTheToolAre) {
  EXPECT_EQ(sample::klartext::refusal("L X+10 Y+0 F100\nCC X+0 Y+0\nC X+0 Y+10 DR+\n"),
            "an arc before TOOL CALL with the tool axis Z");
  EXPECT_EQ(sample::klartext::refusal("TOOL CALL 1 Z\nL X+1 F5\nCC X+0 Y+0\nC X+0 Y+1 DR+\n"),
            "an arc from a position that is not known");
  EXPECT_EQ(sample::klartext::refusal("CC\n"), "CC from a position that is not known");
}

}  // namespace
