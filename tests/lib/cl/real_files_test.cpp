// Files of CAM systems that are not part of the repository: read where they are.

#include "lib/cl/read_text.hpp"

#include "pentapost/cl/arcs.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace pentapost::cl {
namespace {

struct RealFile {
  const char* name;
  const char* dialect;
  Units units;
  std::uint64_t points;  ///< GOTO, as counted by grep
};
constexpr RealFile files[] = {
    {"nx-impeller-ops-inch.cls", "nx-clsf", Units::inch, 10585},
    {"nx-five-axis-inch.cls", "nx-clsf", Units::inch, 325},
    {"nx-plane-mm.cls", "nx-clsf", Units::mm, 35},
    {"nx-block-mm.cls", "nx-clsf", Units::mm, 104},
    {"catia-blade-inch.aptsource", "catia-apt", Units::mm, 163},
    {"creo-drilling.ncl", "creo-ncl", Units::mm, 4},
    {"creo-profile.ncl", "creo-ncl", Units::mm, 52},
    {"makino-plane.cldata", "makino-aptcl", Units::mm, 205},
};

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

class ReadRealFile : public ::testing::TestWithParam<RealFile> {
 protected:
  void SetUp() override {
    const auto path =
        std::filesystem::path{PENTAPOST_SOURCE_DIR} / "../shared/data/cl" / GetParam().name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
    text = text_of(path);
    result = read(text);
  }
  std::string text;
  ReadResult result;
};

TEST_P(ReadRealFile, HasNoError) {
  EXPECT_EQ(result.diagnostics.total(Severity::error), 0U);
  EXPECT_EQ(result.dialect, GetParam().dialect);
  EXPECT_EQ(result.units, GetParam().units);
  EXPECT_EQ(result.points, GetParam().points);
  EXPECT_EQ(result.path.size(), GetParam().points);
}

// The wrong sense turns a 90 deg lead-in into 270 deg.
TEST_P(ReadRealFile, HasArcsThatAreTangentToTheMovesNextToThem) {
  const path::ToolPath& path = result.path;
  std::size_t known = 0, tangent = 0;
  for (const path::Event& event : path.events) {
    const auto* arc = std::get_if<path::Arc>(&event.what);
    const std::size_t point = event.before_point;
    if (arc == nullptr || point < 2 || point + 1 >= path.size()) continue;
    const auto agreement = [&](const Vec3& from_mm, const Vec3& to_mm, const Vec3& at_mm) {
      const Vec3 along = to_mm - from_mm;
      return along.norm() > 0.0 ? along.normalized().dot(arc_tangent(*arc, at_mm)) : 0.0;
    };
    const auto& tips = path.tip_wp_mm;
    ++known;
    if (agreement(tips[point - 2], tips[point - 1], tips[point - 1]) +
            agreement(tips[point], tips[point + 1], tips[point]) >
        0.0)
      ++tangent;
  }
  EXPECT_EQ(tangent, known);
}

TEST_P(ReadRealFile, ReadsTheSameWithAnyLineEnd) {
  std::string other;
  for (const char c : text)
    if (c == '\n')
      other += '\r';
    else if (c != '\r')
      other += c;
  const auto again = read(other);
  EXPECT_EQ(again.path.tip_wp_mm, result.path.tip_wp_mm);
  EXPECT_EQ(again.path.cl_line, result.path.cl_line);
}

INSTANTIATE_TEST_SUITE_P(, ReadRealFile, ::testing::ValuesIn(files), [](const auto& param_info) {
  std::string name = param_info.param.name;
  for (char& c : name)
    if (c == '-' || c == '.') c = '_';
  return name;
});

TEST(ReadCatiaBlade, IsInInchWhereTheRequestSaysSo) {
  const auto path =
      std::filesystem::path{PENTAPOST_SOURCE_DIR} / "../shared/data/cl/catia-blade-inch.aptsource";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const auto result = read(text_of(path), {.units = Units::inch});
  // Last GOTO: -12.119767, -12.619148, -9.432889, 0.559762, -0.709863, -0$ .427506
  EXPECT_NEAR(result.path.tip_wp_mm.back().x(), -12.119767 * 25.4, 1e-9);
  EXPECT_NEAR(result.path.axis_wp.back().z(), -0.427506, 1e-6);
}

TEST(ReadCatiaBlade, WarnsOfAFeedThatWasDividedBy25) {
  const auto path =
      std::filesystem::path{PENTAPOST_SOURCE_DIR} / "../shared/data/cl/catia-blade-inch.aptsource";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  // Line 65: FEDRAT/    0.0394,MMPM
  EXPECT_EQ(diagnostic_of(read(text_of(path)), Code::unit_conflict).cl_line, 65U);
}

}  // namespace
}  // namespace pentapost::cl
