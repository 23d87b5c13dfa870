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

TEST(ReadFeed, LeavesDamagedFeedsOutWithAWarning) {
  for (const char* text :
       {"FEDRAT / 5.000000. MMPM", "FEDRAT/0", "FEDRAT/-5", "FEDRAT/MMPM", "FEDRAT/1E99"}) {
    const auto result = read("UNITS/MM\n" + std::string{text} + "\nRAPID\n" + point);
    EXPECT_EQ(diagnostic_of(result, Code::damaged_statement).cl_line, 2U) << text;
    EXPECT_FALSE(result.diagnostics.has_errors());
    EXPECT_TRUE(events_of<path::FeedRate>(result.path).empty()) << text;
  }
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
  EXPECT_EQ(change(read("LOADTL/1\n" + point)), std::nullopt);
}

TEST(ReadTool, DoesNotChangeItAtSelectOrToolno) {
  EXPECT_TRUE(
      events_of<path::ToolChange>(read("SELECT/TOOL,3\nTOOLNO/3,1\n" + point).path).empty());
}

TEST(ReadTool, RefusesANumberThatIsNotWhole) {
  EXPECT_TRUE(read("LOADTL/1.5\n" + point).diagnostics.has_errors());
  EXPECT_TRUE(read("LOAD/TOOL\n" + point).diagnostics.has_errors());
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
