#include "lib/nc/writer_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace pentapost {
namespace {

using sample::MotionCase;
using Kind = path::Block::Kind;
using CycleKind = path::CycleStart::Kind;
using Lines = std::vector<std::string>;

const machine::Options bare{{"comments", false}, {"start_lines", Lines{}}};

machine::Options bare_with(const std::string& name, machine::OptionValue value) {
  machine::Options options = bare;
  options[name] = std::move(value);
  return options;
}

/// What stands between the program number and the last %.
std::string body(const path::Motion& motion, const machine::Options& options = bare) {
  const std::string nc = sample::program("fanuc-30i", motion, options);
  const auto first = nc.find('\n', 2) + 1;
  return nc.substr(first, nc.rfind('%') - first);
}

TEST(Fanuc30iWriter, WritesAWholeProgramWithTcp) {
  const auto motion = MotionCase{"XYZBC"}
                          .act(path::SafeRetract{})
                          .act(path::ToolCall{.number = 5, .name = "Ball D8"})
                          .act(path::Spindle{path::Spindle::State::clockwise, 12000.0})
                          .act(path::Coolant{path::Coolant::State::flood})
                          .rapid({0, 0, 0, 30, -45})
                          .stating(0x18)
                          .act(path::TcpOn{})
                          .rapid({50, 50, 100, 30, -45})
                          .line({50, 50, -8, 30, -45}, 2000.0)
                          .line({49, 50, -8, 30.5, -45}, 2000.0)
                          .act(path::TcpOff{})
                          .act(path::SafeRetract{})
                          .act(path::Spindle{})
                          .act(path::Coolant{})
                          .act(path::ProgramEnd{})
                          .motion;

  const std::string nc = sample::program(
      "fanuc-30i", motion, {}, sample::named("Demo (1)", "haas-umc-750@1.0.0", "0123456789ab"));

  EXPECT_EQ(nc,
            "%\n"
            "O0001 (DEMO 1)\n"
            "(PROGRAM DEMO 1)\n"
            "(MACHINE HAAS-UMC-750@1.0.0)\n"
            "(DEFINITION 0123456789AB)\n"
            "(UNITS MM)\n"
            "(OUTPUT TCP)\n"
            "G90 G94 G17 G21 G49 G40 G80\n"
            "G54\n"
            "G91 G28 Z0.\n"
            "G90\n"
            "(BALL D8)\n"
            "T5 M6\n"
            "S12000 M3\n"
            "M8\n"
            "G0 B30. C-45.\n"
            "G43.4 H5\n"
            "G0 X50. Y50. Z100. B30. C-45.\n"
            "G1 Z-8. F2000.\n"
            "X49. B30.5\n"
            "G49\n"
            "G91 G28 Z0.\n"
            "G90\n"
            "M5\n"
            "M9\n"
            "M30\n"
            "%\n");
}

TEST(Fanuc30iWriter, SwitchesTheToolLengthOnWithTheFirstZOfAxesOutput) {
  const auto motion = MotionCase{"XYZBC", Output::axes}
                          .act(path::SafeRetract{})
                          .act(path::ToolCall{.number = 5, .length_register = 25})
                          .rapid({0, 0, 0, 30, -45})
                          .stating(0x18)
                          .rapid({1, 2, 0, 30, -45})
                          .stating(0x03)
                          .rapid({1, 2, 3, 30, -45})
                          .rapid({1, 2, 4, 30, -45})
                          .act(path::SafeRetract{})
                          .rapid({1, 2, 4, 30, -45})
                          .motion;

  EXPECT_EQ(body(motion),
            "G91 G28 Z0.\n"
            "G90\n"
            "T5 M6\n"
            "G0 B30. C-45.\n"
            "X1. Y2.\n"
            "G43 Z3. H25\n"
            "Z4.\n"
            "G91 G28 Z0.\n"
            "G90\n"
            "G49\n"
            "G0 G43 X1. Y2. Z4. B30. C-45. H25\n");
}

TEST(Fanuc30iWriter, WritesNoToolLengthWhereTheWordsHoldIt) {
  MotionCase head{"XYZCA", Output::axes};
  head.motion.length_offset = false;
  head.rapid({1, 2, 3, 4, 5}).act(path::SafeRetract{});

  EXPECT_EQ(body(head.motion),
            "G0 X1. Y2. Z3. A5. C4.\n"
            "G91 G28 Z0.\n"
            "G90\n");
}

TEST(Fanuc30iWriter, TakesTheRegisterOfToolOneWhereNoToolIsCalled) {
  EXPECT_EQ(body(MotionCase{}.act(path::TcpOn{}).motion), "G43.4 H1\n");
}

// X10 without a point is 0.01 mm on this control.
TEST(Fanuc30iWriter, WritesAPointInEveryAxisWordAndFeed) {
  const auto motion = MotionCase{}
                          .line({10, -0.5, 0.05, 100, 0}, 500.0)
                          .line({-1000.25, 0.001, -10, 999999.999, -999999.999}, 88.97)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X10. Y-0.5 Z0.05 A100. C0. F500.\n"
            "X-1000.25 Y0.001 Z-10. A999999.999 C-999999.999 F88.97\n");
}

TEST(Fanuc30iWriter, LeavesOutWordsThatDoNotChange) {
  const auto motion = MotionCase{"XYZ"}
                          .line({1, 2, 3}, 100.0)
                          .line({1, 2, 4}, 100.0)
                          .line({0, 2, 4}, 200.0)
                          .rapid({0, 5, 4})
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X1. Y2. Z3. F100.\n"
            "Z4.\n"
            "X0. F200.\n"
            "G0 Y5.\n");
}

TEST(Fanuc30iWriter, WritesAllWordsOnRequest) {
  const auto motion = MotionCase{"XYZ"}.line({1, 2, 3}, 100.0).line({1, 2, 4}, 100.0).motion;

  EXPECT_EQ(body(motion, bare_with("modal_words", false)),
            "G1 X1. Y2. Z3. F100.\n"
            "X1. Y2. Z4.\n");
}

TEST(Fanuc30iWriter, KeepsABlockThatMovesNothingAMotionBlock) {
  const auto motion = MotionCase{"XYZ"}.line({1, 2, 3}, 100.0).line({1, 2, 3}, 100.0).motion;

  EXPECT_EQ(body(motion),
            "G1 X1. Y2. Z3. F100.\n"
            "X1. Y2. Z3.\n");
}

TEST(Fanuc30iWriter, StatesAllWordsAgainAfterTheModeChanges) {
  const path::ActionKind changes[] = {path::TcpOn{},
                                      path::TcpOff{},
                                      path::SafeRetract{},
                                      path::Stop{},
                                      path::InsertedText{"#100=1"},
                                      path::ToolCall{.number = 2}};
  for (const auto& change : changes) {
    const auto motion =
        MotionCase{"XYZ"}.line({1, 2, 3}, 100.0).act(change).line({1, 2, 3}, 100.0).motion;
    const std::string nc = body(motion);
    EXPECT_TRUE(nc.ends_with("G1 X1. Y2. Z3. F100.\n")) << nc;
    EXPECT_TRUE(nc.starts_with("G1 X1. Y2. Z3. F100.\n")) << nc;
  }
}

TEST(Fanuc30iWriter, DoesNotTakeUnstatedWordsForKnown) {
  const auto motion = MotionCase{"XYZ"}.rapid({0, 0, 7}).stating(0x03).rapid({0, 0, 0}).motion;

  EXPECT_EQ(body(motion),
            "G0 X0. Y0.\n"
            "Z0.\n");
}

TEST(Fanuc30iWriter, StatesInverseTimeOnEveryBlock) {
  const auto motion = MotionCase{"XYZC", Output::tcp}
                          .line({0, 0, 0, 0}, 100.0)
                          .inverse({1, 0, 0, 10}, 12.5)
                          .inverse({2, 0, 0, 20}, 12.5)
                          .inverse({3, 0, 0, 30}, 0.00001)
                          .inverse({4, 0, 0, 40}, 1e9)
                          .line({5, 0, 0, 40}, 100.0)
                          .line({6, 0, 0, 40}, 100.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X0. Y0. Z0. C0. F100.\n"
            "G93 X1. C10. F12.5\n"
            "X2. C20. F12.5\n"
            "X3. C30. F0.001\n"
            "X4. C40. F9999.999\n"
            "G94 X5. F100.\n"
            "X6.\n");
}

TEST(Fanuc30iWriter, RoundsInverseTimeDown) {
  const auto motion = MotionCase{"XYZC"}.inverse({1, 0, 0, 10}, 12.34599).motion;

  EXPECT_EQ(body(motion), "G93 G1 X1. Y0. Z0. C10. F12.345\n");
  EXPECT_EQ(body(motion, bare_with("inverse_time_decimals", 1.0)),
            "G93 G1 X1. Y0. Z0. C10. F12.3\n");
  EXPECT_EQ(body(motion, bare_with("largest_inverse_time", 10.0)),
            "G93 G1 X1. Y0. Z0. C10. F10.\n");
}

TEST(Fanuc30iWriter, LeavesInverseTimeForARapid) {
  const auto motion = MotionCase{"XYZC"}
                          .inverse({1, 0, 0, 10}, 5.0)
                          .rapid({0, 0, 0, 0})
                          .inverse({1, 0, 0, 1}, 5.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G93 G1 X1. Y0. Z0. C10. F5.\n"
            "G94 G0 X0. C0.\n"
            "G93 G1 X1. C1. F5.\n");
}

TEST(Fanuc30iWriter, LeavesInverseTimeBeforeWhateverIsNoCuttingBlock) {
  const path::ActionKind others[] = {path::Dwell{1.0},
                                     path::TcpOn{},
                                     path::TcpOff{},
                                     path::SafeRetract{},
                                     path::Stop{},
                                     path::InsertedText{"M100"},
                                     path::ToolCall{.number = 1},
                                     path::ProgramEnd{}};
  for (const auto& other : others) {
    const auto motion = MotionCase{"XYZC"}.inverse({1, 0, 0, 10}, 5.0).act(other).motion;
    const std::string nc = body(motion);
    EXPECT_EQ(nc.find("\nG94\n"), nc.find('\n')) << nc;
  }
}

TEST(Fanuc30iWriter, StatesTheFeedModeAgainAfterTextOfTheCaller) {
  const auto motion = MotionCase{"XYZ"}
                          .line({1, 0, 0}, 100.0)
                          .act(path::InsertedText{"G93"})
                          .line({2, 0, 0}, 100.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X1. Y0. Z0. F100.\n"
            "G93\n"
            "G94 G1 X2. Y0. Z0. F100.\n");
}

TEST(Fanuc30iWriter, WritesArcsWithIncrementalCentres) {
  const auto motion = MotionCase{}
                          .line({45, 25, -5, 0, 0}, 200.0)
                          .arc(Kind::arc_counterclockwise, {25, 45, -5, 0, 0}, -20, 0, 200.0)
                          .arc(Kind::arc_clockwise, {45, 25, -6, 0, 0}, 0, -20, 150.0)
                          .line({45, 0, -6, 0, 0}, 150.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X45. Y25. Z-5. A0. C0. F200.\n"
            "G3 X25. Y45. I-20. J0.\n"
            "G2 X45. Y25. Z-6. I0. J-20. F150.\n"
            "G1 Y0.\n");
}

TEST(Fanuc30iWriter, WritesEndAndCentreOfAFullCircle) {
  const auto motion = MotionCase{"XYZ"}
                          .line({10, 0, 0}, 200.0)
                          .arc(Kind::arc_clockwise, {10, 0, 0}, -10, 0, 200.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X10. Y0. Z0. F200.\n"
            "G2 X10. Y0. I-10. J0.\n");
}

TEST(Fanuc30iWriter, RefusesAnArcThatTurnsARotaryAxis) {
  const auto motion = MotionCase{"XYZC"}
                          .line({10, 0, 0, 0}, 200.0)
                          .arc(Kind::arc_clockwise, {-10, 0, 0, 5}, -10, 0, 200.0)
                          .motion;

  EXPECT_EQ(sample::refused("fanuc-30i", motion).code, Code::not_in_dialect);
}

TEST(Fanuc30iWriter, LeavesRotaryWordsOutOfAnArcAfterAStop) {
  const auto motion = MotionCase{"XYZC"}
                          .line({10, 0, 0, 5}, 200.0)
                          .act(path::Stop{})
                          .arc(Kind::arc_clockwise, {-10, 0, 0, 5}, -10, 0, 200.0)
                          .line({-20, 0, 0, 5}, 200.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G1 X10. Y0. Z0. C5. F200.\n"
            "M0\n"
            "G2 X-10. Y0. I-10. J0. F200.\n"
            "G1 X-20. Z0. C5.\n");
}

path::NativeCycle cycle(CycleKind kind) {
  return {.kind = kind, .clearance_z = 2000, .bottom_z = -10500, .feed_mm_min = 120.0};
}

std::string one_hole(const path::NativeCycle& what) {
  const auto motion =
      MotionCase{"XYZ"}.act(what).hole({1, 2, -10.5}).act(path::NativeCycleEnd{}).motion;
  const std::string nc = body(motion);
  return nc.substr(0, nc.find('\n'));
}

TEST(Fanuc30iWriter, WritesEachCycleByItsWord) {
  const auto with = [](CycleKind kind, std::int64_t peck, double dwell_s) {
    auto what = cycle(kind);
    what.peck = peck;
    what.dwell_s = dwell_s;
    return one_hole(what);
  };
  EXPECT_EQ(with(CycleKind::drill, 0, 0), "G99 G81 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::drill, 0, 0.5), "G99 G82 X1. Y2. Z-10.5 R2. P500 F120.");
  EXPECT_EQ(with(CycleKind::face, 0, 0.25), "G99 G82 X1. Y2. Z-10.5 R2. P250 F120.");
  EXPECT_EQ(with(CycleKind::deep, 3000, 0), "G99 G83 X1. Y2. Z-10.5 R2. Q3. F120.");
  EXPECT_EQ(with(CycleKind::deep, 0, 0), "G99 G81 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::break_chip, 1500, 0), "G99 G73 X1. Y2. Z-10.5 R2. Q1.5 F120.");
  EXPECT_EQ(with(CycleKind::tap, 0, 0), "G99 G84 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::tap_left, 0, 0), "G99 G74 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::bore, 0, 0), "G99 G85 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::bore, 0, 1), "G99 G89 X1. Y2. Z-10.5 R2. P1000 F120.");
  EXPECT_EQ(with(CycleKind::ream, 0, 0), "G99 G85 X1. Y2. Z-10.5 R2. F120.");
  EXPECT_EQ(with(CycleKind::bore_drag, 0, 0), "G99 G86 X1. Y2. Z-10.5 R2. F120.");
}

TEST(Fanuc30iWriter, RetractsToTheLevelBeforeTheCycleWithG98) {
  auto what = cycle(CycleKind::drill);
  what.retract_to_clearance = false;

  EXPECT_EQ(one_hole(what), "G98 G81 X1. Y2. Z-10.5 R2. F120.");
}

// 381.6 mm/min at 477 rpm is the pitch of M5; rounded down it would be another thread.
TEST(Fanuc30iWriter, DoesNotRoundTheFeedOfATapDown) {
  auto what = cycle(CycleKind::tap);
  what.feed_mm_min = 381.6;
  EXPECT_EQ(one_hole(what), "G99 G84 X1. Y2. Z-10.5 R2. F381.6");
  what.feed_mm_min = 333.3333;
  EXPECT_EQ(one_hole(what), "G99 G84 X1. Y2. Z-10.5 R2. F333.333");
}

TEST(Fanuc30iWriter, WritesThePlaceOfEveryHoleAndEndsTheCycle) {
  const auto motion = MotionCase{"XYZ"}
                          .rapid({1, 2, 20})
                          .act(cycle(CycleKind::drill))
                          .hole({1, 2, -10.5})
                          .hole({1, 2, -10.5})
                          .hole({5, 2, -10.5})
                          .hole({5, 2, -12})
                          .act(path::NativeCycleEnd{})
                          .line({5, 2, 30}, 120.0)
                          .motion;

  EXPECT_EQ(body(motion),
            "G0 X1. Y2. Z20.\n"
            "G99 G81 X1. Y2. Z-10.5 R2. F120.\n"
            "X1. Y2.\n"
            "X5. Y2.\n"
            "X5. Y2. Z-12.\n"
            "G80\n"
            "G1 X5. Y2. Z30. F120.\n");
}

TEST(Fanuc30iWriter, EndsACycleBeforeAnyOtherMove) {
  const auto motion =
      MotionCase{"XYZ"}.act(cycle(CycleKind::drill)).hole({1, 2, -10.5}).rapid({1, 2, 30}).motion;

  EXPECT_EQ(body(motion),
            "G99 G81 X1. Y2. Z-10.5 R2. F120.\n"
            "G80\n"
            "G0 X1. Y2. Z30.\n");
}

TEST(Fanuc30iWriter, StartsTheNextCycleAfresh) {
  const auto motion = MotionCase{"XYZ"}
                          .act(cycle(CycleKind::drill))
                          .hole({1, 2, -10.5})
                          .act(cycle(CycleKind::tap))
                          .hole({1, 2, -10.5})
                          .act(path::NativeCycleEnd{})
                          .motion;

  EXPECT_EQ(body(motion),
            "G99 G81 X1. Y2. Z-10.5 R2. F120.\n"
            "G80\n"
            "G99 G84 X1. Y2. Z-10.5 R2. F120.\n"
            "G80\n");
}

TEST(Fanuc30iWriter, WritesNoCycleThatDrillsNothing) {
  const auto motion =
      MotionCase{"XYZ"}.act(cycle(CycleKind::drill)).act(path::NativeCycleEnd{}).motion;

  EXPECT_EQ(body(motion), "");
}

TEST(Fanuc30iWriter, SwitchesTheToolLengthOnInTheFirstHoleIfNothingDidBefore) {
  const auto motion =
      MotionCase{"XYZ", Output::axes}.act(cycle(CycleKind::drill)).hole({1, 2, -10.5}).motion;

  EXPECT_EQ(body(motion), "G43 G99 G81 X1. Y2. Z-10.5 H1 R2. F120.\n");
}

TEST(Fanuc30iWriter, TakesAHoleWithoutCycleForADefect) {
  EXPECT_THROW(body(MotionCase{"XYZ"}.hole({1, 2, 3}).motion), std::logic_error);
}

TEST(Fanuc30iWriter, WritesSpindleStopsAndDwells) {
  using State = path::Spindle::State;
  const auto motion = MotionCase{"XYZ"}
                          .act(path::Spindle{State::clockwise, 12000.4})
                          .act(path::Spindle{State::counterclockwise, {}})
                          .act(path::Spindle{})
                          .act(path::Stop{false})
                          .act(path::Stop{true})
                          .act(path::Dwell{1.5})
                          .act(path::Dwell{0.0001})
                          .motion;

  EXPECT_EQ(body(motion),
            "S12000 M3\n"
            "M4\n"
            "M5\n"
            "M0\n"
            "M1\n"
            "G4 P1500\n"
            "G4 P1\n");
  EXPECT_TRUE(
      body(motion, bare_with("dwell_word", std::string{"X"})).ends_with("G4 X1.5\nG4 X0.001\n"));
}

TEST(Fanuc30iWriter, RefusesAnotherDwellWord) {
  EXPECT_FALSE(
      nc::find_dialect("fanuc-30i")->abilities({{"dwell_word", std::string{"U"}}}).has_value());
}

TEST(Fanuc30iWriter, RefusesSpeedsAndDwellsWithoutEnd) {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto spindle =
      MotionCase{}.act(path::Spindle{path::Spindle::State::clockwise, infinity}).motion;
  EXPECT_EQ(sample::refused("fanuc-30i", spindle).code, Code::out_of_domain);
  EXPECT_EQ(sample::refused("fanuc-30i", MotionCase{}.act(path::Dwell{1e9}).motion).code,
            Code::out_of_domain);
}

TEST(Fanuc30iWriter, KeepsBracketsAndPercentOutOfComments) {
  const auto motion = MotionCase{}
                          .act(path::Comment{"50% (Fl\xC3\xA4"
                                             "che) \xE2\x82\xAC"})
                          .act(path::Comment{" () "})
                          .motion;

  EXPECT_EQ(body(motion, {{"start_lines", Lines{}}}),
            "(UNITS MM)\n"
            "(OUTPUT TCP)\n"
            "(50 FLAECHE ?)\n");
}

TEST(Fanuc30iWriter, NumbersTheProgramWithFourDigits) {
  const auto second_line = [](double number, const std::string& name) {
    const auto nc = sample::program("fanuc-30i", MotionCase{"XYZ"}.motion,
                                    {{"program_number", number}}, sample::named(name));
    return nc.substr(2, nc.find('\n', 2) - 2);
  };
  EXPECT_EQ(second_line(1, "Demo"), "O0001 (DEMO)");
  EXPECT_EQ(second_line(1001, ""), "O1001");
  EXPECT_EQ(second_line(42, "a)\n%\nO2(b"), "O0042 (A  O2B)");
}

TEST(Fanuc30iWriter, RefusesProgramNumbersThatTheControlHasNot) {
  for (const double bad : {0.0, 10000.0, 1.5, -1.0})
    EXPECT_FALSE(nc::find_dialect("fanuc-30i")->abilities({{"program_number", bad}}).has_value());
}

TEST(Fanuc30iWriter, NumbersBlocksOnRequest) {
  machine::Options options = bare_with("block_numbers", true);
  options["block_number_step"] = 1.0;
  options["comments"] = true;
  const auto motion = MotionCase{"XYZ"}
                          .rapid({1, 0, 0})
                          .act(path::Comment{"here"})
                          .rapid({2, 0, 0})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(body(motion, options),
            "(UNITS MM)\n"
            "(OUTPUT TCP)\n"
            "N10 G0 X1. Y0. Z0.\n"
            "(HERE)\n"
            "N11 X2.\n"
            "N12 M30\n");
}

TEST(Fanuc30iWriter, StartsBlockNumbersAgainAfterFiveDigits) {
  machine::Options options = bare_with("block_numbers", true);
  options["block_number_start"] = 9999.0;
  options["block_number_step"] = 1000.0;
  MotionCase many{"XYZ"};
  for (int i = 0; i < 100; ++i) many.rapid({double(i), 0, 0});

  const std::string nc = body(many.motion, options);

  EXPECT_NE(nc.find("\nN99999 X90.\nN9999 X91.\n"), std::string::npos) << nc;
}

TEST(Fanuc30iWriter, SmoothsOutsideTheToolLength) {
  machine::Options options = bare_with("smoothing_on", Lines{"G05.1 Q1"});
  options["smoothing_off"] = Lines{"G05.1 Q0"};
  const auto with_tcp = MotionCase{"XYZ"}
                            .act(path::TcpOn{})
                            .line({1, 0, 0}, 10.0)
                            .act(path::TcpOff{})
                            .act(path::SafeRetract{})
                            .motion;
  EXPECT_EQ(body(with_tcp, options),
            "G05.1 Q1\nG43.4 H1\nG1 X1. Y0. Z0. F10.\nG49\nG05.1 Q0\nG91 G28 Z0.\nG90\n");

  const auto with_axes = MotionCase{"XYZ", Output::axes}
                             .rapid({1, 0, 5})
                             .line({1, 0, 0}, 10.0)
                             .act(path::SafeRetract{})
                             .act(path::ProgramEnd{})
                             .motion;
  EXPECT_EQ(body(with_axes, options),
            "G05.1 Q1\nG0 G43 X1. Y0. Z5. H1\nG1 Z0. F10.\n"
            "G91 G28 Z0.\nG90\nG49\nG05.1 Q0\nM30\n");
}

TEST(Fanuc30iWriter, TakesTheShopsLines) {
  machine::Options options;
  options["comments"] = false;
  options["start_lines"] = Lines{"G90 G94 G17 G21", "G54"};
  options["end_lines"] = Lines{"G91 G28 X0. Y0.", "G90", "M30"};
  options["safe_retract"] = Lines{"G53 G0 Z0."};
  options["tool_change"] = Lines{"T{tool}", "M6", "(S IS {speed})"};
  options["tcp_on"] = Lines{"G43.4 H{register} P1"};
  options["tcp_off"] = Lines{"G49", "M100"};
  const auto motion = MotionCase{"XYZ"}
                          .act(path::SafeRetract{})
                          .act(path::ToolCall{.number = 12, .speed_rpm = 500.0})
                          .act(path::TcpOn{})
                          .act(path::TcpOff{})
                          .act(path::ProgramEnd{})
                          .motion;

  EXPECT_EQ(sample::program("fanuc-30i", motion, options),
            "%\nO0001\nG90 G94 G17 G21\nG54\nG53 G0 Z0.\nT12\nM6\n(S IS S500)\n"
            "G43.4 H12 P1\nG49\nM100\nG91 G28 X0. Y0.\nG90\nM30\n%\n");
}

TEST(Fanuc30iWriter, WritesRapidsAsLinesOnRequest) {
  machine::Options options = bare_with("rapid_as_line", true);
  options["rapid_feed_mm_min"] = 15000.0;
  const auto motion =
      MotionCase{"XYZC"}.rapid({1, 0, 0, 0}).inverse({2, 0, 0, 5}, 7.0).rapid({3, 0, 0, 0}).motion;

  EXPECT_EQ(body(motion, options),
            "G1 X1. Y0. Z0. C0. F15000.\n"
            "G93 X2. C5. F7.\n"
            "G94 X3. C0. F15000.\n");
}

TEST(Fanuc30iWriter, SaysWhatItCan) {
  const auto abilities = nc::find_dialect("fanuc-30i")->abilities({});

  ASSERT_TRUE(abilities.has_value());
  EXPECT_TRUE(abilities->inverse_time);
  EXPECT_EQ(abilities->largest_inverse_time, 9999.999);  // B-62764EN, inverse time feed
  EXPECT_TRUE(abilities->native_cycles);
  EXPECT_TRUE(abilities->arcs);
  EXPECT_TRUE(abilities->helices);
  EXPECT_FALSE(abilities->arcs_with_tcp);
}

TEST(Fanuc30iWriter, LeavesCyclesToTheShop) {
  const auto abilities =
      nc::find_dialect("fanuc-30i")->abilities({{"native_cycles", false}, {"arcs_with_tcp", true}});

  ASSERT_TRUE(abilities.has_value());
  EXPECT_FALSE(abilities->native_cycles);
  EXPECT_TRUE(abilities->arcs_with_tcp);
}

TEST(Fanuc30iWriter, NumbersTensOfThousandsOfBlocksWithoutLosingOne) {
  MotionCase many;
  for (int i = 0; i < 100'000; ++i) many.line({i * 0.001, 0, -8, 11, 360}, 2000.0);

  const std::string nc = body(many.motion);

  EXPECT_EQ(std::ranges::count(nc, '\n'), 100'000);
  EXPECT_TRUE(nc.ends_with("\nX99.999\n"));
}

}  // namespace
}  // namespace pentapost
