#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost::cl {
namespace {

const std::string point = "GOTO/1,2,3\n";

TEST(ReadText, TakesThePartNameWithOrWithoutASlash) {
  EXPECT_EQ(read("PARTNO / MFG0004\n" + point).path.program_name, "MFG0004");
  EXPECT_EQ(read("PARTNO PART, TO BE $ MACHINED\n" + point).path.program_name,
            "PART, TO BE $ MACHINED");
  EXPECT_EQ(read("PARTNO/'RIM'\n" + point).path.program_name, "RIM");
}

TEST(ReadText, TakesPprintAndRemarkAsComments) {
  const auto comments = events_of<path::Comment>(
      read("PPRINT (FIRST)\nREMARK SECOND\nPPRINT/'THIRD'\n" + point).path);
  ASSERT_EQ(comments.size(), 3U);
  EXPECT_EQ(comments[0].text, "(FIRST)");
  EXPECT_EQ(comments[1].text, "SECOND");
  EXPECT_EQ(comments[2].text, "THIRD");
}

TEST(ReadText, KeepsMakinosPprintOutOfTheComments) {
  EXPECT_TRUE(events_of<path::Comment>(
                  read("PPRINT/APTCL-SPEC,MAKINO-FF,1\nPPRINT/MOTION,CUT\n" + point).path)
                  .empty());
}

TEST(ReadText, KeepsInsertedTextAsItStands) {
  const auto texts =
      events_of<path::InsertedText>(read("INSERT M08 (on), G4\nINSERT / M9$\n" + point).path);
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[0].text, "M08 (on), G4");
  EXPECT_EQ(texts[1].text, "M9");
}

TEST(ReadText, SkipsTheWindowTextOfNxBeforeAndBehind) {
  const auto result = read(
      "Information listing created by\tme\nDate\t1-Jan\nFrom here on: a/b\n\nUNITS/MM\nTOOL "
      "PATH/A,TOOL,B\n" +
      point + "END-OF-PATH\nTool Path Listing has 81 lines.\nEnd of listing\n");
  EXPECT_EQ(result.diagnostics.total(Severity::warning), 1U) << "no feed";
  EXPECT_EQ(result.path.size(), 1U);
}

TEST(ReadText, WarnsOfEachJunkLine) {
  const auto result = read("UNITS/MM\nFEDRAT/9\nsfsdfsdf\nAICC/ON,10\nLOOP/START,15\n" + point);
  EXPECT_EQ(result.diagnostics.total(Severity::warning), 3U);
  EXPECT_EQ(diagnostic_of(result, Code::unknown_statement).cl_line, 3U);
  EXPECT_FALSE(result.diagnostics.has_errors());
}

TEST(ReadText, IsSilentAboutWhatConcernsOthers) {
  const auto result = read(
      "UNITS/MM\nPAINT/PATH\nSETUP/1\nTRNTYP/WORLD\nCSYS/1,0,0,0,0,1,0,0,0,0,1,0\nSEQNO/10\nMACHIN/"
      "X,1\n"
      "MSYS/0,0,0,1,0,0,0,1,0\nCUTCOM/OFF\nINTOL/0.01\nOUTTOL/0.01\nFEDRAT/9\n" +
      point + "END\nFINI\n");
  EXPECT_EQ(result.diagnostics.total(), 0U);
}

TEST(ReadText, WarnsOfWhatWouldChangeThePath) {
  for (const char* text : {"CUTCOM/LEFT", "ROTABL/0.", "ORIGIN/0,0,0", "TRACUT/NOMORE",
                           "TRACUT/1,0,0,0,0,1,0,0,0,0,1,0", "PPFUN 3"})
    EXPECT_TRUE(has(read(std::string{text} + "\n" + point), Code::ignored_statement)) << text;
}

TEST(ReadText, RefusesWhatMovesTheFrameOfThePoints) {
  for (const char* text :
       {"ROTABL/1.5707963", "ROTABL/45,CLW", "ROTHED/30", "ORIGIN/1,2,3", "TRANS/1,2,3",
        "TRACUT/MX1", "MCS/0,0,1,0", "MCSYS/NUM,1", "TRACUT/1,0,0,5,0,1,0,0,0,0,1,0"}) {
    const auto result = read("UNITS/MM\n" + std::string{text} + "\n" + point);
    EXPECT_TRUE(has(result, Code::damaged_motion)) << text;
    EXPECT_EQ(diagnostic_of(result, Code::damaged_motion).cl_line, 2U) << text;
  }
}

TEST(ReadText, NamesOperations) {
  const auto catia = read("$$ OPERATION NAME : Sweep.1\n" + point);
  EXPECT_EQ(events_of<path::Operation>(catia.path).at(0).name, "Sweep.1");
  EXPECT_EQ(events_of<path::Operation>(read("$$-> FEATNO / 32\n" + point).path).at(0).name,
            "FEATNO 32");
}

TEST(ReadText, SetsTheAxisUprightAtEachFeatureOfCreo) {
  const auto path = read("$$-> FEATNO / 1\nGOTO/0,0,0,1,0,0\n$$-> FEATNO / 2\n" + point).path;
  EXPECT_EQ(path.axis_wp[1], Vec3(0, 0, 1));
}

TEST(ReadText, ReadsDwellsAndStops) {
  const auto path = read("DELAY/1.5\nSPINDL/600,CLW\nDWELL/5,REV\nSTOP\nOPSTOP\n" + point).path;
  EXPECT_EQ(events_of<path::Dwell>(path).at(0).time_s, 1.5);
  EXPECT_DOUBLE_EQ(events_of<path::Dwell>(path).at(1).time_s, 0.5);
  EXPECT_FALSE(events_of<path::Stop>(path).at(0).optional);
  EXPECT_TRUE(events_of<path::Stop>(path).at(1).optional);
}

TEST(ReadText, WarnsOfDwellsThatAreNone) {
  for (const char* text : {"DELAY/0", "DELAY/-1", "DELAY/1E9", "DELAY/", "DELAY/5,REV"})
    EXPECT_TRUE(has(read(std::string{text} + "\n" + point), Code::damaged_statement)) << text;
}

TEST(ReadText, WritesAuxiliaryFunctionsAsWords) {
  EXPECT_EQ(events_of<path::InsertedText>(read("AUXFUN/8\n" + point).path).at(0).text, "M8");
  EXPECT_TRUE(has(read("AUXFUN/8.5\n" + point), Code::damaged_statement));
}

TEST(ReadText, ReadsLowerCaseTabsAndAByteOrderMark) {
  const auto result =
      read("\xEF\xBB\xBFunits/inches\r\n\tfedrat/ipm,\t1.\r\n\tgoto/1.,\t2.,3.\r\n");
  EXPECT_EQ(result.units, Units::inch);
  EXPECT_EQ(result.path.size(), 1U);
  EXPECT_EQ(result.diagnostics.total(), 0U);
}

TEST(ReadText, TakesTheDialectThatIsAskedFor) {
  EXPECT_EQ(read_as("creo-ncl", "TOOL PATH/A,TOOL,B\n" + point).dialect, "creo-ncl");
  EXPECT_TRUE(has(read_as("creo", point), Code::unknown_dialect));
}

TEST(ReadText, TakesTheAxisRoundingFromTheDigits) {
  EXPECT_EQ(read("GOTO/1.0000,2,3,0.6000000,0.8000000,0\n").path.axis_rounding_rad, 2e-7);
  EXPECT_EQ(read("GOTO/1,2,3,0.0000001,0,1\n").path.axis_rounding_rad, 2e-7);
  EXPECT_EQ(read("GOTO/1,2,3,0.707,0.707,0\n").path.axis_rounding_rad, 2e-3);
}

TEST(ReadText, HasNoAxisRoundingWhereFewDigitsAreExact) {
  EXPECT_EQ(read("GOTO/1,2,3,0,0.6,0.8\n").path.axis_rounding_rad, 0.0);
}

TEST(ReadText, HasNoAxisRoundingWithoutAxes) {
  EXPECT_EQ(read("GOTO/1.0000,2.0000,3.0000\n").path.axis_rounding_rad, 0.0);
  EXPECT_EQ(read("GOTO/1.0000,2,3,0,0,1\n").path.axis_rounding_rad, 0.0);
  EXPECT_EQ(read("GOTO/1,2,3,0.6,0.8000000000,0\n").path.axis_rounding_rad, 2e-10);
}

}  // namespace
}  // namespace pentapost::cl
