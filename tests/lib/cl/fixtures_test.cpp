// One small file for each trap of real CL data.

#include "lib/cl/read_text.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace pentapost::cl {
namespace {

struct Fixture {
  const char* name;
  std::size_t points;  ///< of the path
  std::size_t errors;
  std::size_t warnings;
  Vec3 last_tip_mm;
  Code code = Code::count_;  ///< a diagnostic that must be there
};
const Fixture fixtures[] = {
    {"continuation-in-number.cl", 1, 0, 0, {10, 20, 30}},
    {"comment-behind-goto.cl", 1, 0, 0, {1, 2, 3}},
    {"comment-in-quotes.cl", 1, 0, 0, {1, 2, 3}},
    {"creo-data-comments.cl", 1, 0, 0, {1, 2, 3}},
    {"modal-axis.cl", 3, 0, 0, {2, 0, 0}},
    {"no-unit-but-feed-inch.cl", 2, 0, 0, {50.8, 0, 0}},
    {"no-unit-at-all.cl", 1, 0, 1, {1, 0, 0}, Code::unit_assumed},
    {"unit-conflict.cl", 2, 0, 1, {50.8, 0, 0}, Code::unit_conflict},
    {"arc-creo.cl", 2, 0, 0, {10, 0, 0}},
    {"arc-nx.cl", 2, 0, 0, {0, -7.5, 0}},
    {"arc-clt.cl", 2, 0, 0, {0, 10, 0}},
    {"arc-catia.cl", 2, 0, 0, {0, 10, 0}},
    {"arc-fusion.cl", 2, 0, 0, {0, 10, 0}},
    {"arc-without-rule.cl", 4, 0, 1, {-5, 10, 0}, Code::arc_sense_assumed},
    {"cycle-by-name.cl", 4, 0, 0, {9, 0, 20}},
    {"cycle-by-position.cl", 2, 0, 0, {0, 0, 0}},
    {"nx-window-text.cl", 1, 0, 0, {1, 2, 3}},
    {"junk-lines.cl", 1, 0, 3, {1, 2, 3}, Code::unknown_statement},
    {"glued-words.cl", 1, 0, 0, {1, 2, 3}},
    {"cr-only.cl", 1, 0, 0, {1, 2, 3}},
    {"crlf-bom-tabs-lower-case.cl", 1, 0, 0, {1, 2, 3}},
    {"number-forms.cl", 3, 0, 0, {150, 2, 3}},
    {"damaged-goto.cl", 1, 1, 0, {1, 2, 3}, Code::damaged_motion},
    {"damaged-feed.cl", 1, 1, 0, {1, 2, 3}, Code::damaged_statement},
    {"zero-axis.cl", 0, 1, 0, {0, 0, 0}, Code::zero_tool_axis},
    {"not-finite.cl", 0, 2, 0, {0, 0, 0}, Code::bad_number},
    {"axis-not-unit.cl", 1, 0, 1, {1, 2, 3}, Code::axis_not_unit},
    {"axis-below-horizon.cl", 2, 0, 0, {1, 2, 3}},
};

ReadResult read_fixture(const std::string& name) {
  std::ifstream file{std::filesystem::path{PENTAPOST_TESTS_DIR} / "fixtures/cl" / name,
                     std::ios::binary};
  EXPECT_TRUE(file.is_open()) << name;
  return read(std::string{std::istreambuf_iterator<char>{file}, {}});
}

class ReadFixture : public ::testing::TestWithParam<Fixture> {};

TEST_P(ReadFixture, GivesWhatTheFileMeans) {
  const Fixture& fixture = GetParam();

  const ReadResult result = read_fixture(fixture.name);

  EXPECT_EQ(result.path.size(), fixture.points);
  EXPECT_EQ(result.diagnostics.total(Severity::error), fixture.errors);
  EXPECT_EQ(result.diagnostics.total(Severity::warning), fixture.warnings);
  for (const Diagnostic& diagnostic : result.diagnostics.list()) SCOPED_TRACE(diagnostic.message);
  if (fixture.code != Code::count_) {
    EXPECT_TRUE(has(result, fixture.code));
  }
  if (result.path.size() > 0) {
    EXPECT_NEAR((result.path.tip_wp_mm.back() - fixture.last_tip_mm).norm(), 0.0, 1e-12);
  }
  for (const path::Arc& arc : events_of<path::Arc>(result.path))
    EXPECT_NEAR(arc.sweep_rad, pi / 2, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(, ReadFixture, ::testing::ValuesIn(fixtures), [](const auto& param_info) {
  std::string name = param_info.param.name;
  for (char& c : name)
    if (c == '-' || c == '.') c = '_';
  return name;
});

TEST(ReadNurbsFixture, IsDivided) {
  const auto result = read_fixture("nx-nurbs.cl");
  EXPECT_EQ(result.diagnostics.total(Severity::info), 1U);
  EXPECT_GT(result.path.size(), 10U);
  EXPECT_NEAR((result.path.tip_wp_mm.back() - Vec3{4, 0, 0}).norm(), 0.0, 1e-12);
}

TEST(ReadDemo, HasNoRemarkAtAll) {
  const std::pair<const char*, const char*> demos[] = {{"demo-five-axis.cl", "creo-ncl"},
                                                       {"demo-nx-inch.cls", "nx-clsf"},
                                                       {"demo-catia.aptsource", "catia-apt"}};
  for (const auto& [name, dialect] : demos) {
    const auto result = read_fixture(name);
    EXPECT_EQ(result.diagnostics.total(), 0U) << name;
    EXPECT_EQ(result.dialect, dialect) << name;
    EXPECT_GT(result.points, 15U) << name;
  }
}

}  // namespace
}  // namespace pentapost::cl
