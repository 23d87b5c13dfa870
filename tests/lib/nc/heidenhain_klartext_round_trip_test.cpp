#include "lib/nc/read_items.hpp"
#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using sample::MotionCase;
using Kind = path::Block::Kind;

sample::ReadProgramItems written_and_read(const path::Motion& motion,
                                          const machine::Options& options = {}) {
  const std::string nc = sample::program("heidenhain", motion, options);
  return sample::read_items("heidenhain", nc, motion.letters);
}

TEST(HeidenhainKlartextRoundTrip, GivesTheWordsOfRandomBlocks) {
  std::mt19937_64 random{7};
  const auto in = [&random](std::int64_t largest) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(2 * largest + 1)) -
           largest;
  };
  for (const bool modal : {true, false}) {
    MotionCase blocks;
    for (int i = 0; i < 20'000; ++i) {
      const bool rapid = random() % 4 == 0;
      const double feed = 0.001 * static_cast<double>(1 + random() % 5'000'000);
      if (rapid)
        blocks.rapid({0, 0, 0, 0, 0});
      else
        blocks.line({0, 0, 0, 0, 0}, feed);
      path::Block& block = blocks.motion.blocks.back();
      for (std::size_t column = 0; column < 5; ++column) {
        const bool stays = i > 0 && random() % 3 == 0;
        block.word[column] =
            stays ? blocks.motion.blocks[static_cast<std::size_t>(i) - 1].word[column]
                  : in(99'999'999);
      }
    }
    blocks.act(path::ProgramEnd{});

    const auto items = written_and_read(blocks.motion, {{"modal_words", modal}});

    ASSERT_EQ(items.message(), "");
    const auto motions = items.motions();
    ASSERT_EQ(motions.size(), blocks.motion.blocks.size());
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const path::Block& block = blocks.motion.blocks[i];
      ASSERT_EQ(motions[i].kind == nc::ReadMotion::Kind::rapid, block.kind == Kind::rapid) << i;
      ASSERT_EQ(motions[i].known, 0x1F);
      for (std::size_t column = 0; column < 5; ++column)
        ASSERT_EQ(motions[i].position[column], decimal_value(block.word[column], 3)) << i;
      if (block.kind == Kind::line) {
        ASSERT_LE(motions[i].feed, block.feed + 1e-9);
        ASSERT_GT(motions[i].feed, block.feed - 0.0011);
      }
    }
  }
}

TEST(HeidenhainKlartextRoundTrip, GivesTheCentresOfRandomArcs) {
  std::mt19937_64 random{11};
  std::uniform_real_distribution<double> turn{0.1, 6.2};
  for (int i = 0; i < 2'000; ++i) {
    const double from = turn(random);
    const double to = turn(random);
    const double radius = 5.0 + 10.0 * turn(random);
    const Kind kind = i % 2 == 0 ? Kind::arc_clockwise : Kind::arc_counterclockwise;
    MotionCase arcs;
    arcs.act(path::ToolCall{.number = 1})
        .rapid({radius * std::cos(from), radius * std::sin(from), 0, 0, 0})
        .arc(kind, {radius * std::cos(to), radius * std::sin(to), 0, 0, 0},
             -radius * std::cos(from), -radius * std::sin(from), 50.0)
        .act(path::ProgramEnd{});

    const auto motions = written_and_read(arcs.motion).motions();

    ASSERT_EQ(motions.size(), 2u);
    EXPECT_EQ(motions[1].kind, nc::ReadMotion::Kind::arc);
    EXPECT_EQ(motions[1].clockwise, kind == Kind::arc_clockwise);
    EXPECT_NEAR(motions[1].centre_x_mm, 0.0, 0.0011);
    EXPECT_NEAR(motions[1].centre_y_mm, 0.0, 0.0011);
    for (std::size_t column = 0; column < 3; ++column)
      EXPECT_EQ(motions[1].position[column], decimal_value(arcs.motion.blocks[1].word[column], 3));
  }
}

TEST(HeidenhainKlartextRoundTrip, KeepsRoundedAnglesOfAHelixFromAddingUp) {
  constexpr double radius = 20.0;
  constexpr double step_rad = 0.777;
  for (const double sense : {1.0, -1.0}) {
    MotionCase helix;
    helix.act(path::ToolCall{.number = 1}).line({radius, 0, 0, 0, 0}, 100.0);
    std::int64_t x = 20'000, y = 0;
    for (int i = 1; i <= 3'000; ++i) {
      const double angle = sense * step_rad * i;
      helix.arc(sense > 0.0 ? Kind::arc_counterclockwise : Kind::arc_clockwise,
                {radius * std::cos(angle), radius * std::sin(angle), -0.01 * i, 0, 0},
                -0.001 * static_cast<double>(x), -0.001 * static_cast<double>(y), 100.0);
      x = helix.motion.blocks.back().word[0];
      y = helix.motion.blocks.back().word[1];
    }
    helix.act(path::ProgramEnd{});

    const auto items = written_and_read(helix.motion);

    ASSERT_EQ(items.message(), "");
    const auto motions = items.motions();
    ASSERT_EQ(motions.size(), 3'001u);
    for (std::size_t i = 1; i < motions.size(); ++i) {
      const path::Block& block = helix.motion.blocks[i];
      // Half of the last digit of the angle, and the radii that differ by the digits of the ends.
      const double angle_deg =
          std::atan2(motions[i].position[1], motions[i].position[0]) * deg_per_rad;
      const double asked_deg =
          std::atan2(static_cast<double>(block.word[1]), static_cast<double>(block.word[0])) *
          deg_per_rad;
      ASSERT_NEAR(std::remainder(angle_deg - asked_deg, 360.0), 0.0, 0.000'051) << i;
      ASSERT_EQ(motions[i].position[2], decimal_value(block.word[2], 3));
      ASSERT_EQ(motions[i].whole_turns, 0);
    }
  }
}

TEST(HeidenhainKlartextRoundTrip, GivesTheHolesOfEveryCycle) {
  using Cycle = path::CycleStart::Kind;
  using Hole = nc::ReadMotion::Hole;
  struct Case {
    Cycle kind;
    std::int64_t peck;
    Hole hole;
  };
  for (const Case& one :
       {Case{Cycle::drill, 0, Hole::drill}, Case{Cycle::face, 0, Hole::drill},
        Case{Cycle::deep, 3'000, Hole::deep}, Case{Cycle::deep, 0, Hole::drill},
        Case{Cycle::deep, 90'000, Hole::deep}, Case{Cycle::break_chip, 3'000, Hole::break_chip},
        Case{Cycle::break_chip, 12'000, Hole::break_chip},
        Case{Cycle::break_chip, 90'000, Hole::break_chip},
        Case{Cycle::break_chip, 1, Hole::break_chip}, Case{Cycle::tap, 0, Hole::tap},
        Case{Cycle::tap_left, 0, Hole::tap_left}, Case{Cycle::ream, 0, Hole::feed_out},
        Case{Cycle::bore, 0, Hole::feed_out}, Case{Cycle::bore_drag, 0, Hole::spindle_stop}}) {
    path::NativeCycle native;
    native.kind = one.kind;
    native.clearance_z = 3'500;
    native.clearance = 2'250;
    native.bottom_z = -10'750;
    native.peck = one.peck;
    native.dwell_s = one.kind == Cycle::face ? 0.75 : 0.0;
    native.feed_mm_min = 480.0;
    MotionCase holes{"XYZAC", Output::axes};
    holes.act(path::ToolCall{.number = 2, .speed_rpm = 400.0})
        .act(path::Spindle{path::Spindle::State::clockwise, 400.0})
        .rapid({0, 0, 50, 0, 0})
        .act(native)
        .hole({1, 2, -10.75, 0, 0})
        .act(path::NativeCycleEnd{})
        .act(path::ProgramEnd{});

    for (const bool depth_reference : {false, true}) {
      const auto items =
          written_and_read(holes.motion, {{"cycle_depth_reference", depth_reference}});
      ASSERT_EQ(items.message(), "");
      const nc::ReadMotion hole = items.motions().back();
      EXPECT_EQ(hole.hole, one.hole);
      EXPECT_EQ(hole.position[2], -10.75);
      EXPECT_EQ(hole.clearance_z_mm, 3.5);
      EXPECT_EQ(hole.retract_z_mm, 3.5);
      EXPECT_EQ(hole.peck_mm, static_cast<double>(one.peck) / 1000.0);
      EXPECT_EQ(hole.dwell_s, native.dwell_s);
      EXPECT_NEAR(hole.feed, 480.0, 1e-9);
      EXPECT_EQ(hole.travel_z_mm, 50.0);
    }
  }
}

TEST(HeidenhainKlartextRoundTrip, SurvivesDamagedPrograms) {
  MotionCase motion;
  motion.act(path::ToolCall{.number = 1, .speed_rpm = 500.0})
      .act(path::SafeRetract{})
      .act(path::Spindle{path::Spindle::State::clockwise, 500.0})
      .line({10, 0, 0, 0, 0}, 100.0)
      .arc(Kind::arc_counterclockwise, {0, 10, -1, 0, 0}, -10, 0, 100.0)
      .arc(Kind::arc_counterclockwise, {-10, 0, -1, 0, 0}, 0, -10, 100.0)
      .act(path::Dwell{1.0})
      .act(path::ProgramEnd{});
  const std::string nc = sample::program("heidenhain", motion.motion);
  const std::string pieces[] = {
      "~",   "\n",    ";", "CYCL DEF 200 ~\nQ200=", "IPA", "CC ", "R", "M9", "Q", "CP PA+9", "\r",
      "DR+", "F MAX", "\0"};
  std::mt19937_64 random{3};
  for (int i = 0; i < 20'000; ++i) {
    std::string damaged = nc;
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = 20 + random() % (damaged.size() - 20);
      if (random() % 2 == 0)
        damaged.erase(at, random() % 8);
      else
        damaged.insert(at, pieces[random() % std::size(pieces)]);
    }
    for (const auto& read : sample::read_items("heidenhain", damaged).motions())
      for (const double position : read.position) ASSERT_TRUE(std::isfinite(position)) << damaged;
  }
}

TEST(HeidenhainKlartextRoundTrip, ReadsAMillionJoinedLines) {
  std::string text = "BEGIN PGM A MM\nBLK FORM ~\n";
  for (int i = 0; i < 1'000'000; ++i) text += "~\n";
  text += "X\nM30\n";

  EXPECT_EQ(sample::read_items("heidenhain", text).message(), "");
}

}  // namespace
}  // namespace pentapost
