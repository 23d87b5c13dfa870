#include "pentapost/cl/cycles.hpp"

#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <string>
#include <string_view>

namespace pentapost::cl {
namespace {

constexpr std::size_t ten_mb = 10'000'000;

std::string repeated(std::string_view part, std::size_t size) {
  std::string text;
  text.reserve(size + part.size());
  while (text.size() < size) text += part;
  return text;
}

/// Whatever the text, the path is whole.
void expect_sound(const ReadResult& result) {
  EXPECT_TRUE(result.path.size() > 0 || result.diagnostics.has_errors());
  EXPECT_LE(result.diagnostics.list().size(), 3 * Diagnostics::kept_per_severity);
  for (std::size_t i = 0; i < result.path.size(); ++i) {
    ASSERT_TRUE(result.path.tip_wp_mm[i].allFinite());
    ASSERT_NEAR(result.path.axis_wp[i].norm(), 1.0, 1e-12);
  }
  std::uint32_t before = 0;
  for (const auto& event : result.path.events) {
    ASSERT_GE(event.before_point, before);
    ASSERT_LE(event.before_point, result.path.size());
    before = event.before_point;
  }
}

TEST(ReadAnything, SurvivesTenMegabytesOfOneCharacter) {
  for (const char c : {'/', '$', ' ', '\n', '\r', ',', '0', 'G', '\'', '"', '(', '.', '\0', '\xFF'})
    expect_sound(read(std::string(ten_mb, c)));
}

TEST(ReadAnything, SurvivesTenMegabytesOfOnePart) {
  for (const char* part :
       {"$\n", "GOTO/", "GOTO/1,2,$\n", "'$", "1,", "NURBS/\n", "CIRCLE/0,0,0,0,0,1,1\n",
        "CYCLE/DRILL,DEPTH,1\n", "KNOT/0,$\n", "\r\n", "$$-> CSYS /,$\n", "TOOL PATH/\n"})
    expect_sound(read(repeated(part, ten_mb)));
}

TEST(ReadAnything, SurvivesRandomBytes) {
  std::mt19937_64 random{42};
  std::string bytes(ten_mb, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  expect_sound(read(bytes));
}

TEST(ReadAnything, SurvivesRandomStatements) {
  constexpr std::array parts{"GOTO/",
                             "1.5,",
                             "0,",
                             "-3",
                             "\n",
                             "\n",
                             "$\n",
                             "CIRCLE/",
                             "CYCLE/",
                             "DRILL,",
                             "DEPTH,",
                             "OFF",
                             "TIMES,",
                             "1E9,",
                             "NURBS/\n",
                             "KNOT/0,0,1,1\n",
                             "CNTRL/",
                             "MOVARC/",
                             "ANGLE,",
                             "FROM/",
                             "GODLTA/",
                             "RAPID\n",
                             "UNITS/INCHES\n",
                             "MMPM,",
                             "FEDRAT/",
                             "TOOL PATH/A,TOOL,B\n",
                             "END-OF-PATH\n",
                             "SPINDL/",
                             "REV",
                             "DEEP,",
                             "STEP,",
                             "CLEAR,"};
  std::mt19937_64 random{42};
  for (int i = 0; i < 20'000; ++i) {
    SCOPED_TRACE(i);
    std::string text = "GOTO/0,0,0\n";
    for (int k = 0; k < 40; ++k) text += parts[random() % parts.size()];
    const auto result = read(text);
    expect_sound(result);
    if (!result.diagnostics.has_errors())
      expand_cycles(result.path, [](std::uint32_t p) { return p % 2 == 0; });
  }
}

TEST(ReadAnything, KeepsAHundredDiagnosticsAndCountsAll) {
  const auto result = read("GOTO/1,2,3\n" + repeated("JUNK/1\nGOTO/1,2\n", 160'000));
  EXPECT_EQ(result.diagnostics.total(Severity::error), 10'000U);
  EXPECT_LE(result.diagnostics.list().size(), 200U);
}

TEST(ReadAnything, RefusesHolesThatNeedTooManyMoves) {
  const auto result = read("UNITS/MM\nCYCLE/DEEP,DEPTH,100,STEP,0.1,CLEAR,1,MMPM,9\n" +
                           repeated("GOTO/1,2,3\n", 100'000));
  EXPECT_TRUE(has(result, Code::too_large));
}

TEST(ReadAnything, ReadsAnyCutOfAProgramWithoutHarm) {
  const std::string text =
      "UNITS/MM\nFEDRAT/9,MMPM\nGOTO/10,0,0,$\n0,0,1\nCIRCLE/0,0,0,0,0,1,10,$\nTIMES,2\nGOTO/"
      "0,10,0\n"
      "CYCLE/DEEP,DEPTH,3,STEP,1,CLEAR,2\nGOTO/1,2,3\nCYCLE/OFF\nNURBS/3\nKNOT/0,0,1,1\nCNTRL/"
      "0,0,0\n"
      "CNTRL/1,0,0\nINSERT 'X\n";
  for (std::size_t size = 0; size <= text.size(); ++size) expect_sound(read(text.substr(0, size)));
}

}  // namespace
}  // namespace pentapost::cl
