#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pentapost::cl {
namespace {

using State = path::Spindle::State;

const std::string point = "GOTO/1,2,3\n";

TEST(ReadFeed, TakesValueAndUnitInEitherOrder) {
  for (const char* text : {"FEDRAT/MMPM,250.", "FEDRAT / 250.0, MMPM", "FEDRAT/250",
                           "FEDRAT/PERMIN,250", "fedrat/250mmpm"}) {
    const auto feeds =
        events_of<path::FeedRate>(read("UNITS/MM\n" + std::string{text} + "\n" + point).path);
    ASSERT_EQ(feeds.size(), 1U) << text;
    EXPECT_EQ(feeds[0].value, 250.0) << text;
    EXPECT_EQ(feeds[0].unit, path::FeedRate::Unit::mm_min) << text;
  }
}

TEST(ReadFeed, KeepsFeedsPerRevolution) {
  const auto path = read("UNITS/INCHES\nFEDRAT/0.01,IPR\nFEDRAT/0.02\n" + point).path;
  const auto feeds = events_of<path::FeedRate>(path);
  EXPECT_DOUBLE_EQ(feeds[0].value, 0.254);
  EXPECT_EQ(feeds[0].unit, path::FeedRate::Unit::mm_per_revolution);
  EXPECT_DOUBLE_EQ(feeds[1].value, 0.508);
  EXPECT_EQ(feeds[1].unit, path::FeedRate::Unit::mm_per_revolution);
}

/// The diagnostic that refuses `statement`, which is line 2.
Diagnostic refusal(const std::string& statement) {
  const auto result = read("UNITS/MM\n" + statement + "\nRAPID\n" + point);
  EXPECT_EQ(result.diagnostics.total(Severity::error), 1U) << statement;
  const auto error = diagnostic_of(result, Code::damaged_statement);
  EXPECT_EQ(error.severity, Severity::error) << statement;
  EXPECT_EQ(error.cl_line, 2U) << statement;
  EXPECT_NE(error.message.find(statement), std::string::npos) << error.message;
  EXPECT_TRUE(events_of<path::FeedRate>(result.path).empty()) << statement;
  EXPECT_TRUE(events_of<path::Spindle>(result.path).empty()) << statement;
  EXPECT_TRUE(events_of<path::ToolChange>(result.path).empty()) << statement;
  return error;
}

// The moves behind a damaged feed would run with the one before it.
TEST(ReadFeed, RefusesDamagedFeeds) {
  for (const char* text :
       {"FEDRAT / 5.000000. MMPM", "FEDRAT/0", "FEDRAT/-5", "FEDRAT/MMPM", "FEDRAT/1E99", "FEDRAT/",
        "FEDRAT/2O.0", "FEDRAT/1,000.0", "FEDRAT/25OMMPM", "FEDRAT/'250'", "FEDRAT/250,MMPN",
        "FEDRAT/250,MMPM,IPM", "FEDRAT/RAPID,5000", "FEDRAT/250,RANGE", "FEDRAT/250,ON",
        "FEDRAT/INVERS,20", "FEDRAT/SCALE,0.5", "FEDRAT/MAXIPM"})
    refusal(text);
}

TEST(ReadFeed, SaysWhatWasExpectedAndWhatItFound) {
  const std::pair<const char*, const char*> cases[] = {
      {"FEDRAT/2O.0", "found \"O.0\""},
      {"FEDRAT/1,000.0", "found a second number, \"000.0\""},
      {"FEDRAT/-5", "found -5"},
      {"FEDRAT/5.0.", "found \"5.0.\""},
      {"FEDRAT/250,RANGE", "found \"RANGE\" without its value"}};
  for (const auto& [text, found] : cases) {
    const std::string message = refusal(text).message;
    EXPECT_NE(message.find("expected a feed above 0 and its unit"), std::string::npos) << message;
    EXPECT_NE(message.find(found), std::string::npos) << message;
  }
}

TEST(ReadFeed, KnowsOptionsOfOtherPostprocessors) {
  for (const char* text : {"FEDRAT/250,MMPM,RANGE,LOW", "FEDRAT/RANGE,2,250", "FEDRAT/250,MMPM,",
                           "FEDRAT/250,MMPM,RAPTO,0.3", "FEDRAT/(250),PERMIN,MAXIPM,900"}) {
    const auto result = read("UNITS/MM\n" + std::string{text} + "\n" + point);
    EXPECT_EQ(result.diagnostics.total(), 0U) << text;
    EXPECT_EQ(events_of<path::FeedRate>(result.path).at(0).value, 250.0) << text;
  }
}

// MAXIPM,500 was taken for a feed of 500.
TEST(ReadFeed, DoesNotTakeSettingsForFeeds) {
  for (const char* text : {"FEDRAT/MAXIPM,500", "FEDRAT/LOCK,ON", "FEDRAT/ADJUST,OFF"}) {
    const auto result = read("UNITS/MM\n" + std::string{text} + "\nRAPID\n" + point);
    EXPECT_TRUE(has(result, Code::ignored_statement)) << text;
    EXPECT_FALSE(result.diagnostics.has_errors()) << text;
    EXPECT_TRUE(events_of<path::FeedRate>(result.path).empty()) << text;
  }
}

TEST(ReadFeed, WarnsOnceOfFeedsBelowOneMillimetreAMinute) {
  const auto result = read("UNITS/MM\nFEDRAT/1,MMPM\nFEDRAT/0.1,MMPR\nFEDRAT/0.0394,MMPM\n" +
                           point + "FEDRAT/0.5,MMPM\n" + point);
  EXPECT_EQ(result.diagnostics.total(), 1U);
  const auto warning = diagnostic_of(result, Code::unit_conflict);
  EXPECT_EQ(warning.severity, Severity::warning);
  EXPECT_EQ(warning.cl_line, 4U);
  EXPECT_NE(warning.message.find("0.0394 mm/min"), std::string::npos) << warning.message;
  EXPECT_EQ(events_of<path::FeedRate>(result.path).size(), 4U);
}

TEST(ReadSpindle, TakesWordsAndNumbersInAnyOrder) {
  const std::pair<const char*, State> cases[] = {{"SPINDL / RPM, 3000.0, CLW", State::clockwise},
                                                 {"SPINDL/3000CCLW", State::counterclockwise},
                                                 {"SPINDL/3000, RPM, CLW", State::clockwise},
                                                 {"SPINDL/CCLW,RPM,3000", State::counterclockwise},
                                                 {"SPINDL/RANGE,2,CLW,3000", State::clockwise},
                                                 {"SPINDL/3000", State::clockwise}};
  for (const auto& [text, state] : cases) {
    const auto spindles = events_of<path::Spindle>(read(text + ("\n" + point)).path);
    ASSERT_EQ(spindles.size(), 1U) << text;
    EXPECT_EQ(spindles[0].state, state) << text;
    EXPECT_EQ(spindles[0].speed_rpm, 3000.0) << text;
  }
}

TEST(ReadSpindle, KnowsGearsLimitsAndRadii) {
  for (const char* text :
       {"SPINDL/3000,CLW,RANGE,LOW", "SPINDL/RPM,3000,CLW,HIGH", "SPINDL/3000,CLW,MAXRPM,8000",
        "SPINDL/MAXRPM,8000,RPM,3000,CLW", "SPINDL/3000,AUTO", "SPINDL/3000,RADIUS,12.5,CLW"}) {
    const auto result = read("UNITS/MM\n" + std::string{text} + "\nRAPID\n" + point);
    EXPECT_EQ(result.diagnostics.total(), 0U) << text;
    EXPECT_EQ(events_of<path::Spindle>(result.path).at(0).speed_rpm, 3000.0) << text;
  }
}

TEST(ReadSpindle, RefusesDamagedSpeeds) {
  for (const char* text :
       {"SPINDL/1O00", "SPINDL/3,000", "SPINDL/3,000,CLW", "SPINDL/30.0.0,CLW", "SPINDL/-300,CLW",
        "SPINDL/1000001,CLW", "SPINDL/RPM,CLW", "SPINDL/RPM", "SPINDL/", "SPINDL/3000,CLV",
        "SPINDL/3000,CLW,CCLW", "SPINDL/3000,CLW,MAXRPM", "SPINDL/3000,RANGE,CLW", "SPINDL/OF"})
    refusal(text);
}

TEST(ReadSpindle, SaysWhichSpeedsItTakes) {
  const std::string message = refusal("SPINDL/2000000,CLW").message;
  EXPECT_NE(message.find("a speed above 0 up to 1e6 rpm"), std::string::npos) << message;
  EXPECT_NE(message.find("found 2000000."), std::string::npos) << message;
  const auto highest = read("UNITS/MM\nSPINDL/1000000,CLW\nRAPID\n" + point);
  EXPECT_EQ(highest.diagnostics.total(), 0U);
}

// A limit or a gear alone had started the spindle, and LOCK,OFF had stopped it.
TEST(ReadSpindle, IsNotMovedBySettings) {
  for (const char* text : {"SPINDL/MAXRPM,3000", "SPINDL/RANGE,2", "SPINDL/HIGH", "SPINDL/LOCK,ON",
                           "SPINDL/LOCK,OFF"}) {
    const auto result = read("UNITS/MM\n" + std::string{text} + "\nRAPID\n" + point);
    EXPECT_TRUE(has(result, Code::ignored_statement)) << text;
    EXPECT_FALSE(result.diagnostics.has_errors()) << text;
    EXPECT_TRUE(events_of<path::Spindle>(result.path).empty()) << text;
  }
}

TEST(ReadSpindle, GoesOnAtOnAsItWas) {
  const auto spindles =
      events_of<path::Spindle>(read("SPINDL/800,CCLW\nSPINDL/OFF\nSPINDL/ON\n" + point).path);
  ASSERT_EQ(spindles.size(), 3U);
  EXPECT_EQ(spindles[1].state, State::off);
  EXPECT_EQ(spindles[2].state, State::counterclockwise);
  EXPECT_EQ(spindles[2].speed_rpm, 800.0);
}

TEST(ReadSpindle, WarnsWhereWritersHaveExchangedOnAndOff) {
  for (const char* bare : {"SPINDL/ON\n", "SPINDL/OFF\n"}) {
    EXPECT_TRUE(has(read_as("fusion-apt", bare + point), Code::ignored_statement)) << bare;
    EXPECT_FALSE(has(read_as("apt", bare + point), Code::ignored_statement)) << bare;
  }
  EXPECT_FALSE(has(read_as("fusion-apt", "SPINDL/900,RPM,CLW\n" + point), Code::ignored_statement));
}

TEST(ReadSpindle, LeavesSurfaceSpeedOutWithAWarning) {
  const auto result = read("SPINDL/500.0,SFM,CLW\n" + point);
  EXPECT_TRUE(has(result, Code::ignored_statement));
  EXPECT_EQ(events_of<path::Spindle>(result.path).at(0).speed_rpm, std::nullopt);
}

TEST(ReadTool, KnowsAllWaysToChangeIt) {
  for (const char* text : {"LOADTL / 13", "LOADTL/13,1", "LOAD/TOOL,13,ADJUST,4", "TURRET/13",
                           "TOOL/13", "SELECT/TOOL,13\nLOAD/TOOL"}) {
    const auto result = read(std::string{text} + "\n" + point);
    const auto tools = events_of<path::ToolChange>(result.path);
    ASSERT_EQ(tools.size(), 1U) << text;
    EXPECT_EQ(tools[0].number, 13) << text;
    EXPECT_TRUE(result.path.has_tool_change);
  }
}

TEST(ReadTool, TakesTheLengthRegister) {
  const auto change = [](const ReadResult& result) {
    return events_of<path::ToolChange>(result.path).at(0).length_register;
  };
  EXPECT_EQ(change(read("LOAD/TOOL,1,ADJUST,7\n" + point)), 7);
  EXPECT_EQ(change(read("LOADTL/1,OSETNO,8\n" + point)), 8);
  EXPECT_EQ(change(read_as("fusion-apt", "LOADTL/1, 0, 82.5, 9\n" + point)), 9);
  EXPECT_EQ(change(read_as("fusion-apt", "LOADTL/'A', 1, 0, 82.5, 9, MILL\n" + point)), 9);
  EXPECT_EQ(change(read("LOADTL/1, 0, 82.5, 9\n" + point)), std::nullopt);
  EXPECT_EQ(change(read("LOADTL/1\n" + point)), std::nullopt);
}

TEST(ReadTool, DoesNotChangeItAtSelectOrToolno) {
  EXPECT_TRUE(
      events_of<path::ToolChange>(read("SELECT/TOOL,3\nTOOLNO/3,1\n" + point).path).empty());
}

TEST(ReadTool, RefusesWhatNamesNoTool) {
  for (const char* text : {"LOADTL/1.5",      "LOAD/TOOL",         "LOADTL/'MILL D10'",
                           "LOADTL/0",        "LOADTL/-3",         "LOADTL/",
                           "LOADTL/MILL",     "LOADTL/O5",         "LOADTL/1O",
                           "LOADTL/1.2.3",    "LOADTL/ADJUST,4",   "LOADTL/32768",
                           "LOADTL/12345678", "LOADTL/123456789",  "LOADTL/3,1.2.3",
                           "TURRET/0",        "TURRET/CENTER",     "TURRET/FACE,3",
                           "TOOL/0",          "LOAD/TOOL,0",       "LOAD/TOOL,-1",
                           "LOAD/TOOL,O5",    "LOAD/TOOL,ADJUST,4"}) {
    const std::string message = refusal(text).message;
    EXPECT_NE(message.find("expected a whole tool number from 1 to 32767"), std::string::npos)
        << message;
  }
}

// With a name at hand, 0 was put in for a number that could not be read.
TEST(ReadTool, DoesNotPutANameInPlaceOfTheNumber) {
  for (const char* text : {"LOADTL/O5", "LOADTL/MILL", "LOADTL/1O"}) {
    const auto result = read("TPRINT/MILL D10\n" + std::string{text} + "\nRAPID\n" + point);
    EXPECT_EQ(diagnostic_of(result, Code::damaged_statement).cl_line, 2U) << text;
    EXPECT_TRUE(result.diagnostics.has_errors()) << text;
    EXPECT_TRUE(events_of<path::ToolChange>(result.path).empty()) << text;
  }
}

TEST(ReadTool, TakesTheLargestNumberAndNamesBesideTheNumber) {
  for (const char* text :
       {"LOADTL/32767", "LOADTL/'MILL D10',32767", "LOADTL/TOOL,32767",
        "LOADTL/32767,ADJUST,1,SPINDL,15915.4943,MILL", "LOADTL/32767,10MM_MILL"})
    EXPECT_EQ(events_of<path::ToolChange>(read(std::string{text} + "\n" + point).path).at(0).number,
              32767)
        << text;
}

TEST(ReadTool, RefusesADamagedLengthRegister) {
  for (const char* text : {"LOADTL/3,ADJUST,1O", "LOADTL/3,ADJUST,O5", "LOAD/TOOL,3,ADJUST",
                           "LOAD/TOOL,3,OSETNO,1.5", "LOADTL/3,ADJUST,-1"})
    EXPECT_NE(refusal(text).message.find("expected a whole length register"), std::string::npos)
        << text;
}

TEST(ReadTool, DoesNotGoOnWithADamagedSelection) {
  for (const char* text : {"SELECT/TOOL,1O", "SELECT/TOOL,0", "SELECT/TOOL,SEVEN"}) {
    const auto result = read(std::string{text} + "\nLOAD/TOOL\nRAPID\n" + point);
    EXPECT_EQ(diagnostic_of(result, Code::damaged_statement).cl_line, 2U) << text;
  }
}

TEST(ReadTool, LoadsTheSelectedToolWithItsRegister) {
  const auto change =
      events_of<path::ToolChange>(read("SELECT/TOOL,7\nLOAD/TOOL,ADJUST,17\n" + point).path);
  EXPECT_EQ(change.at(0).number, 7);
  EXPECT_EQ(change.at(0).length_register, 17);
}

TEST(ReadTool, TakesTheNameFromTheToolPath) {
  const auto result = read("TOOL PATH/ROUGH CUT,TOOL,MILL D10\nLOAD/TOOL,2,ADJUST,2\n" + point);
  EXPECT_EQ(events_of<path::ToolChange>(result.path).at(0).name, "MILL D10");
  EXPECT_EQ(events_of<path::Operation>(result.path).at(0).name, "ROUGH CUT");
}

TEST(ReadTool, WarnsWhereAToolPathChangesTheToolWithoutLoad) {
  const std::string first =
      "UNITS/MM\nTOOL PATH/A,TOOL,T1\nLOAD/TOOL,1\n" + point + "END-OF-PATH\n";
  EXPECT_EQ(diagnostic_of(read(first + "TOOL PATH/B,TOOL,T2\n" + point + "END-OF-PATH\n"),
                          Code::ignored_statement)
                .cl_line,
            6U);
  EXPECT_FALSE(has(read(first + "TOOL PATH/B,TOOL,T1\n" + point + "END-OF-PATH\n"),
                   Code::ignored_statement));
}

TEST(ReadTool, ReadsItsGeometry) {
  const auto nx =
      events_of<path::ToolData>(read("UNITS/MM\nTLDATA/MILL,30.,0.5,75.,0.,0.\n" + point).path);
  EXPECT_EQ(nx.at(0).diameter_mm, 30.0);
  EXPECT_EQ(nx.at(0).corner_radius_mm, 0.5);
  EXPECT_EQ(nx.at(0).length_mm, 75.0);
  const auto drill = events_of<path::ToolData>(
      read("UNITS/MM\nTLDATA/DRILL,MILL,10.,0.,80.,118.,35.\n" + point).path);
  EXPECT_EQ(drill.at(0).length_mm, 80.0);
  const auto creo =
      events_of<path::ToolData>(read("$$-> CUTTER / 3.000000\nUNITS/MM\n" + point).path);
  EXPECT_EQ(creo.at(0).diameter_mm, 3.0);
  EXPECT_EQ(creo.at(0).corner_radius_mm, std::nullopt);
  const auto seven = events_of<path::ToolData>(
      read("UNITS/MM\nCUTTER/ 10.,2.,3.,2.,0.,$\n 0.,50.\n" + point).path);
  EXPECT_EQ(seven.at(0).corner_radius_mm, 2.0);
  EXPECT_EQ(seven.at(0).length_mm, std::nullopt);
}

TEST(ReadCoolant, KnowsItsKinds) {
  using Coolant = path::Coolant::State;
  const std::pair<const char*, Coolant> cases[] = {
      {"COOLNT/ON", Coolant::flood},  {"coolnt/flood", Coolant::flood},
      {"COOLNT/Mist", Coolant::mist}, {"COOLNT/THRU", Coolant::through},
      {"COOLNT/AIR", Coolant::air},   {"COOLNT/OFF", Coolant::off}};
  for (const auto& [text, state] : cases)
    EXPECT_EQ(events_of<path::Coolant>(read(text + ("\n" + point)).path).at(0).state, state)
        << text;
}

TEST(ReadCoolant, GoesOnAtOnAsItWas) {
  const auto all =
      events_of<path::Coolant>(read("COOLNT/MIST\nCOOLNT/OFF\nCOOLNT/ON\n" + point).path);
  EXPECT_EQ(all.at(2).state, path::Coolant::State::mist);
}

}  // namespace
}  // namespace pentapost::cl
