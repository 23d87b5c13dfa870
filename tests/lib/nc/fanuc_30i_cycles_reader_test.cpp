#include "lib/nc/fanuc_reader_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>

namespace {

using namespace pentapost;
using sample::expect_refused;
using sample::last_motion;
using sample::motions_of;
using Kind = nc::ReadMotion::Kind;

TEST(Fanuc30iReaderCycles, DrillsAndReturnsToTheInitialLevel) {
  const auto motions = motions_of("G98 G81 X10. Y20. Z-5. R2. F80.\nX30.\nG80\nG0 X0.");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[0].kind, Kind::drill);
  EXPECT_EQ(motions[0].position, (std::array{10.0, 20.0, -5.0, 0.0, 0.0}));
  EXPECT_EQ(motions[0].clearance_z_mm, 2.0);
  EXPECT_EQ(motions[0].retract_z_mm, 100.0);
  EXPECT_EQ(motions[0].feed, 80.0);
  EXPECT_EQ(motions[0].cycle, "G81");
  EXPECT_EQ(motions[1].position, (std::array{30.0, 20.0, -5.0, 0.0, 0.0}));
  EXPECT_EQ(motions[1].stated, 0b00001);
  EXPECT_EQ(motions[2].position[2], 100.0);
}

TEST(Fanuc30iReaderCycles, G99ReturnsToTheClearanceLevelAndG98StillKnowsTheInitialOne) {
  const auto motions = motions_of("G99 G81 X10. Z-5. R2.\nX20.\nG98 X30.\nG80\nG0 X0.");
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[0].retract_z_mm, 2.0);
  EXPECT_EQ(motions[1].retract_z_mm, 2.0);
  EXPECT_EQ(motions[2].retract_z_mm, 100.0);
  EXPECT_EQ(motions[3].position[2], 100.0);
}

TEST(Fanuc30iReaderCycles, TheNextMoveAfterG99StartsAtTheClearanceLevel) {
  EXPECT_EQ(last_motion("G99 G81 X10. Z-5. R2.\nG80\nG0 X0.").position[2], 2.0);
}

/// FANUC Series 30i operator's manual, canned cycles for drilling: operation 1 positions X and Y,
/// operation 2 is the rapid traverse to point R.
TEST(Fanuc30iReaderCycles, MovesAcrossAtTheLevelWhereTheToolIs) {
  const auto motions = motions_of(
      "G99 G81 X0. Y0. Z-10. R3.\nG99 G81 X20. Z20. R33.\nG98 X30.\nX40.\nG80\nG0 Z50.\nG81 X1. "
      "Z-1. R2.");
  ASSERT_EQ(motions.size(), 6u);
  EXPECT_EQ(motions[0].travel_z_mm, 100.0);
  EXPECT_EQ(motions[1].travel_z_mm, 3.0);
  EXPECT_EQ(motions[2].travel_z_mm, 33.0);
  EXPECT_EQ(motions[3].travel_z_mm, 100.0);
  EXPECT_EQ(motions[5].travel_z_mm, 50.0);
}

TEST(Fanuc30iReaderCycles, DoesNotKnowTheLevelBehindAReferenceReturn) {
  EXPECT_EQ(last_motion("G91 G28 Z0.\nG90 G99 G81 X1. Z-1. R2.").travel_z_mm, std::nullopt);
}

/// M29 S... before G84 makes the tapping rigid (operator's manual, rigid tapping).
TEST(Fanuc30iReaderCycles, M29StatesNothingButASpeed) {
  const auto read = sample::read_after_start("S900 M3\nM29 S477\nG84 X1. Z-9. R2. F381.6");
  EXPECT_EQ(read.message(), "");
  const auto motions = read.motions();
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[2].hole, nc::ReadMotion::Hole::tap);
  EXPECT_EQ(motions[2].position, (std::array{1.0, 0.0, -9.0, 0.0, 0.0}));
  const auto spindles = read.all<nc::ReadSpindle>();
  ASSERT_EQ(spindles.size(), 2u);
  EXPECT_EQ(spindles[1].state, nc::ReadSpindle::State::clockwise);
  EXPECT_EQ(spindles[1].speed_rpm, 477.0);
}

TEST(Fanuc30iReaderCycles, CycleLevelsInG91CountFromTheInitialAndTheClearanceLevel) {
  const auto motions = motions_of("G91 G98 G81 X10. Z-15. R-95.\nX10.");
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0].clearance_z_mm, 5.0);
  EXPECT_EQ(motions[0].position[2], -10.0);
  EXPECT_EQ(motions[1].position[0], 20.0);
  EXPECT_EQ(motions[1].position[2], -10.0);
}

TEST(Fanuc30iReaderCycles, PecksAndDwellsAreModal) {
  const auto motions =
      motions_of("G83 X10. Z-9. R2. Q1.5\nX20.\nG82 X30. P250\nX40.\nG73 X50. Q2000");
  ASSERT_EQ(motions.size(), 5u);
  EXPECT_EQ(motions[1].peck_mm, 1.5);
  EXPECT_EQ(motions[2].peck_mm, 0.0);
  EXPECT_EQ(motions[3].dwell_s, 0.25);
  EXPECT_EQ(motions[4].peck_mm, 2.0);
  EXPECT_EQ(motions[4].dwell_s, 0.0);
  EXPECT_EQ(motions[4].clearance_z_mm, 2.0);
}

TEST(Fanuc30iReaderCycles, ACycleBlockWithoutAPositionDrillsNothing) {
  EXPECT_EQ(motions_of("G81 X1. Z-1. R2.\nF50.\nM8\nX2.").size(), 2u);
}

TEST(Fanuc30iReaderCycles, AMotionCodeEndsTheCycle) {
  const auto motions = motions_of("G81 X1. Z-1. R2.\nG0 X2.\nX3.");
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[1].kind, Kind::rapid);
  EXPECT_EQ(motions[2].kind, Kind::rapid);
}

TEST(Fanuc30iReaderCycles, G80ForgetsTheLevels) {
  expect_refused("G81 X1. Z-1. R2.\nG80\nG81 X2. Z-1.", "R and Z", Code::bad_cycle);
}

TEST(Fanuc30iReaderCycles, AHoleMayTurnTheTable) {
  EXPECT_EQ(last_motion("G81 X1. Z-1. R2.\nC90.").position[4], 90.0);
}

/// FANUC Series 30i operator's manual, canned cycles for drilling, table of their operations; the
/// same in every milling control of the make.
TEST(Fanuc30iReaderCycles, TellsWhatEachCycleDoes) {
  using Hole = nc::ReadMotion::Hole;
  for (const auto& [word, hole] : {std::pair{"G81", Hole::drill},
                                   {"G82", Hole::drill},
                                   {"G83", Hole::deep},
                                   {"G73", Hole::break_chip},
                                   {"G84", Hole::tap},
                                   {"G74", Hole::tap_left},
                                   {"G85", Hole::feed_out},
                                   {"G89", Hole::feed_out},
                                   {"G86", Hole::spindle_stop},
                                   {"G88", Hole::other}}) {
    const auto motion = sample::last_motion(std::string{word} + " X1. Y2. Z-3. R2. Q1.");
    EXPECT_EQ(motion.hole, hole) << word;
  }
}

TEST(Fanuc30iReaderCycles, RefusesCyclesThatItCannotFollow) {
  expect_refused("G81 X1. Z-1.", "R and Z", Code::bad_cycle);
  expect_refused("G83 X1. Z-1. R2.", "Q", Code::bad_cycle);
  expect_refused("G81 X1. Z-1. R2. K3", "repeats", Code::bad_cycle);
  expect_refused("G91 G81 X1. Z-1. R2. L2", "repeats", Code::bad_cycle);
  expect_refused("G18 G81 X1. Z-1. R2.", "G17", Code::bad_cycle);
  expect_refused("G93 G81 X1. Z-1. R2. F5.", "G93", Code::bad_cycle);
  expect_refused("G91 G28 Z0.\nG90 G98 G81 X1. Z-1. R2.", "G98", Code::bad_cycle);
  expect_refused("G81 X1. Z-1. R2.\nG53 Z0.", "within a canned cycle");
  expect_refused("G81 X1. Z-1. R2.\nG4 P1", "within a canned cycle");
  expect_refused("G81 X1. Z-1. R2.\nG55 X1.", "within a canned cycle");
  expect_refused("G81 X1. Z-1. R2.\nP500", "P500");
  expect_refused("G82 X1. Z-1. R2. P0.5", "P0.5", Code::bad_number);
}

}  // namespace
