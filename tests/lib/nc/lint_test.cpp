#include "pentapost/nc/lint.hpp"

#include "pentapost/nc/dialect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace pentapost {
namespace {

/// "line: rule" of every finding.
std::vector<std::string> found(std::string_view dialect, std::string_view text,
                               const std::string& letters = "XYZAC") {
  std::vector<std::string> all;
  const auto report = nc::find_lint(dialect)->look(text, {.letters = letters, .options = {}});
  for (const auto& each : report.findings)
    all.push_back(std::to_string(each.nc_line) + ": " + std::string{each.rule});
  EXPECT_EQ(report.total, all.size());
  return all;
}

using Found = std::vector<std::string>;

TEST(Lints, AreThereForEveryDialect) {
  for (const auto* dialect : nc::dialects()) EXPECT_NE(nc::find_lint(dialect->name), nullptr);
  EXPECT_TRUE(
      std::ranges::is_sorted(nc::lints(), {}, [](const auto* lint) { return lint->dialect; }));
}

TEST(Lints, FindOnlyRulesThatTheyList) {
  const std::string bad =
      "G234 H1\nG43.4 H1\nM128\nM428\nTRAORI\nG53 X1\nSUPA X1\nM91 L X1\nG93 G1 X1 Q5\nG4 P1\n"
      "G2 X1 A3\nC X1 A3\nM6\nT5\nTOOL CALL 5\nG81 X1 Z2\nCYCLE832(0.1)\nG05.1 Q1\nM30\n";
  for (const auto* lint : nc::lints()) {
    const auto report = lint->look(bad, {.letters = "XYZBC", .options = {}});
    EXPECT_GT(report.total, 0U) << lint->dialect;
    for (const auto& each : report.findings)
      EXPECT_TRUE(std::ranges::any_of(lint->rules,
                                      [&](const auto& rule) { return rule.name == each.rule; }))
          << lint->dialect << " " << each.rule;
  }
}

TEST(LintFanuc, TellsMachineMovesWithTcp) {
  EXPECT_EQ(found("fanuc-30i", "G43.4 H1\nG53 G0 Z0.\nG49\nG53 G0 Z0.\n"),
            Found{"2: machine_move_with_tcp"});
  EXPECT_EQ(found("fanuc-30i", "N10 G43.5 H1\nG91 G28 Z0.\nG49\nG28 Z0.\n"), Found{});
  EXPECT_EQ(found("haas-ngc", "G0 G234 H1\nG91 G28 Z0.\nG49\nG28 Z0.\n"),
            Found{"2: machine_move_with_tcp"});
}

TEST(LintFanuc, TellsToolChangeAndEndWithTcp) {
  EXPECT_EQ(found("fanuc-30i", "G43.4 H1\nT2 M6\nG49\nT3 M6\nM30\n"),
            Found{"2: tool_change_with_tcp"});
  EXPECT_EQ(found("fanuc-30i", "G43.4 H1\nM30\n"), Found{"2: end_with_tcp"});
}

TEST(LintFanuc, TellsArcsWithRotaryWordsAlsoWhereTheCodeIsModal) {
  EXPECT_EQ(found("fanuc-30i", "G2 X1. Y0. I1. J0.\nX2. A3. I1. J0.\nG1 X2. A3.\n"),
            Found{"2: arc_with_rotary_words"});
}

TEST(LintFanuc, TellsInverseTimeWithoutFeedAndAtADwell) {
  EXPECT_EQ(found("fanuc-30i", "G93 G1 X1. F2.\nX2.\nG4 P500\nG94\nG4 P500\n"),
            (Found{"2: inverse_time_without_feed", "3: inverse_time_at_dwell"}));
  EXPECT_EQ(found("fanuc-30i", "G93\nG99 G81 X1. Y2. Z-3. R1. F100.\n"),
            Found{"2: inverse_time_at_dwell"});
}

TEST(LintFanuc, TellsNumbersWithoutPoint) {
  EXPECT_EQ(found("fanuc-30i", "G1 X10 Y2. F100.\nG4 X2\nG43 H1 Z5.\n"),
            Found{"1: number_without_point"});
}

TEST(LintFanuc, TellsSmoothingBehindTheLength) {
  EXPECT_EQ(found("fanuc-30i", "G05.1 Q1\nG43.4 H1\nG49\nG05.1 Q0\nG43 H1 Z1.\nG05.1 Q1\n"),
            Found{"6: smoothing_after_length"});
}

TEST(LintFanuc, TellsAxesThatTheMachineDoesNotHave) {
  EXPECT_EQ(found("fanuc-30i", "G1 X1. B2. F1.\n", "XYZAC"), Found{"1: unknown_axis_word"});
}

TEST(LintFanuc, LeavesCommentsAlone) {
  EXPECT_EQ(found("fanuc-30i", "G43.4 H1\n(G53 X1 M6 M30)\nG49\n"), Found{});
}

TEST(LintHaas, WantsG234WhereG0IsActive) {
  EXPECT_EQ(found("haas-ngc", "G1 X1. F1.\nG234 H1\nG49\nG0 G234 H1\nG49\n", "XYZBC"),
            Found{"2: tcp_without_rapid"});
}

TEST(LintLinuxcnc, TellsTcpByItsMCodesAndLongLines) {
  EXPECT_EQ(found("linuxcnc", "M428\nG53 G0 Z0\nM429\nG53 G0 Z0\n"),
            Found{"2: machine_move_with_tcp"});
  EXPECT_EQ(found("linuxcnc", "G1 X1 F1\n(" + std::string(300, 'A') + ")\n"),
            Found{"2: long_line"});
}

TEST(LintHeidenhainIso, TellsSignsAndMachineMoves) {
  EXPECT_EQ(found("heidenhain-iso",
                  "%A G71 *\nN10 T5 G17 S100 *\nN20 M128 *\nN30 G01 X5 Y+1 *\nN40 G00 Z+0 M91 *\n"
                  "N50 M129 *\nN60 M30 *\n"),
            (Found{"4: number_without_sign", "5: machine_move_with_tcp"}));
}

TEST(LintHeidenhain, FollowsTcpmAndArcs) {
  EXPECT_EQ(found("heidenhain",
                  "0 BEGIN PGM A MM\n1 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n"
                  "2 L Z+0 R0 FMAX M91\n3 FUNCTION RESET TCPM\n4 L Z+0 R0 FMAX M91\n"
                  "5 CC X+0 Y+0\n6 C X+1 Y+0 DR+\n7 M128\n8 TOOL CALL 5 Z S100\n9 M129\n"
                  "10 END PGM A MM\n"),
            (Found{"3: machine_move_with_tcp", "9: tool_change_with_tcp"}));
  EXPECT_EQ(found("heidenhain", "1 C X+1 Y+0 A+3 DR+\n2 L X5 FMAX\n"),
            (Found{"1: arc_with_rotary_words", "2: number_without_sign"}));
}

TEST(LintSiemens, TellsMachineMovesCyclesAndSmoothing) {
  EXPECT_EQ(found("siemens-840d", "TRAORI\nG0 SUPA Z0 D0\nTRAFOOF\nG0 SUPA Z0 D0\nM30\n"),
            Found{"2: machine_move_with_tcp"});
  EXPECT_EQ(found("siemens-840d",
                  "CYCLE832(0.01)\nCYCLE832(0.01,_ORI_FINISH,0.5)\n"
                  "G93 G1 X1 F1\nMCALL CYCLE81(50,0,2,-10)\nX1 Y1\nMCALL\nG94\n"),
            (Found{"1: smoothing_without_orientation", "5: inverse_time_at_dwell"}));
}

TEST(LintSiemens, ReadsAssignedWords) {
  EXPECT_EQ(found("siemens-840d", "G2 X=1 A=DC(30) I1 J0\nG1 A3=0.5 B3=0 C3=1 F1\n"),
            Found{"1: arc_with_rotary_words"});
  EXPECT_EQ(found("siemens-840d", "MSG(\"G53 M6 B=5\")\nG1 X1 F1 ; B5\n"), Found{});
}

/// Lines that are passed over quickly: the same faults must be found among them.
TEST(Lints, FindTheOneBadLineAmongManyGoodOnes) {
  const auto many = [](const std::string& line) {
    std::string text;
    for (int i = 0; i < 50; ++i) text += line;
    return text;
  };
  EXPECT_EQ(found("fanuc-30i", "G1 X0. F1.\n" + many("X1. Y2. Z3. A4. C5.\n") + "X1. Y2 Z3. A4.\n"),
            Found{"52: number_without_point"});
  EXPECT_EQ(found("fanuc-30i", "G93 G1 X0. F1.\n" + many("X1. Y2. F3.\n") + "X1. Y2.\n"),
            Found{"52: inverse_time_without_feed"});
  EXPECT_EQ(
      found("heidenhain-iso", "N1 G01 X+0 F9 *\n" + many("N2 X+1 Y-2 A+4 *\n") + "N3 X+1 Y2 *\n"),
      Found{"52: number_without_sign"});
  EXPECT_EQ(found("heidenhain", many("5 L X+1 Y-2 A+4 F100\n") + "6 L X+1 B+2 F100\n"),
            Found{"51: unknown_axis_word"});
  EXPECT_EQ(found("siemens-840d", "G1 X0 F1\n" + many("X1 Y2 C5\n") + "X1 B2\n"),
            Found{"52: unknown_axis_word"});
  EXPECT_EQ(found("linuxcnc", "M428\nG1 X0 F1\n" + many("X1 Y2 C5\n") + "G53 X1\n"),
            Found{"53: machine_move_with_tcp"});
}

TEST(Lints, KeepTheFirstHundredAndCountAll) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "G1 X1 F1.\n";
  const auto report = nc::find_lint("fanuc-30i")->look(text, {.letters = "XYZAC", .options = {}});
  EXPECT_EQ(report.findings.size(), 100U);
  EXPECT_EQ(report.total, 1000U);
  EXPECT_EQ(report.findings.back().nc_line, 100U);
}

TEST(Lints, SurviveAnyText) {
  std::mt19937_64 random{7};
  const std::string alphabet = "GMXYZACTLC0123456789.+-()\"=;, \n\r%_\xff";
  for (int i = 0; i < 3000; ++i) {
    std::string text;
    for (auto length = random() % 200; length > 0; --length)
      text += alphabet[random() % alphabet.size()];
    for (const auto* lint : nc::lints())
      EXPECT_LE(lint->look(text, {.letters = "XYZAC", .options = {}}).findings.size(), 100U);
  }
}

}  // namespace
}  // namespace pentapost
