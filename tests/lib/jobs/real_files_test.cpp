#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <map>

namespace pentapost {
namespace {

std::filesystem::path real_files() {
  return std::filesystem::path{PENTAPOST_SOURCE_DIR} / "../shared/data/cl";
}

struct RealFile {
  const char* name;
  bool inch;  ///< the file does not say so
};
void PrintTo(const RealFile& file, std::ostream* out) { *out << file.name; }

constexpr RealFile files[] = {
    {"nx-impeller-ops-inch.cls", true},   {"nx-five-axis-inch.cls", true},
    {"catia-blade-inch.aptsource", true}, {"nx-plane-mm.cls", false},
    {"nx-block-mm.cls", false},           {"creo-drilling.ncl", false},
    {"creo-profile.ncl", false},          {"makino-plane.cldata", false},
};

/// A machine of each topology.
constexpr const char* machines[] = {
    "hermle-c600u",        "dmu-50-evolution", "dmu-70-evo",         "haas-umc-750",
    "mazak-variaxis-630",  "dmu-125p",         "dmu-80p-duoblock",   "dmu-80-monoblock",
    "huron-kx100",         "makino-mag3",      "linuxcnc-xyzac-trt", "linuxcnc-xyzbc-trt",
    "linuxcnc-bridgemill", "pocket-nc-v2",     "generic-ca-head",    "generic-3axis",
    "generic-4axis-a"};

class RealFileOnMachines : public ::testing::TestWithParam<RealFile> {};

/// Either the file posts with a passed proof, or the machine truly cannot: never another problem.
TEST_P(RealFileOnMachines, PostsWithAProofOrIsBeyondTheMachine) {
  const auto file = real_files() / GetParam().name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the real CL files are not here";
  std::map<std::string, int> posted_by_kind;
  int posted_count = 0;
  for (const char* machine : machines) {
    for (const Output output : {Output::tcp, Output::axes}) {
      for (const auto* dialect : nc::dialects()) {
        SCOPED_TRACE(std::string{machine} + (output == Output::tcp ? " tcp " : " axes ") +
                     std::string{dialect->name});
        jobs::PostJob job = sample::cl_job(machine, sample::file_text(file));
        if (GetParam().inch) std::get<jobs::ClText>(job.path).units = jobs::ClUnits::inch;
        for (int tool = 0; tool < 50; ++tool) job.gauge_length_mm[tool] = 150.0;
        job.post.output = output;
        job.post.dialect = std::string{dialect->name};
        job.post.lint = true;
        for (const char* axis : {"A", "B", "C"})
          if (!job.machine.limits[axis].max_speed) job.limits[axis].max_speed = 0.5;

        const auto posted = jobs::post(job);

        if (posted) {
          ++posted_count;
          EXPECT_TRUE(posted->verification.passed);
          EXPECT_LE(posted->verification.tip_deviation_mm, 0.01 * (1 + 1e-9));
          EXPECT_LE(posted->verification.axis_deviation_deg, 0.05 * (1 + 1e-9));
          EXPECT_EQ(posted->verification.blocks_read, posted->blocks);
          for (const auto& each : posted->lint.findings)
            ADD_FAILURE() << "line " << each.nc_line << ", " << each.rule << ": " << each.message;
        } else {
          EXPECT_TRUE(posted.error().code == Code::out_of_reach ||
                      posted.error().code == Code::rotary_range)
              << row_of(posted.error().code).name << ": " << posted.error().message;
        }
      }
    }
  }
  EXPECT_GE(posted_count, 4 * static_cast<int>(nc::dialects().size()));
  RecordProperty("posted", posted_count);
}
INSTANTIATE_TEST_SUITE_P(Files, RealFileOnMachines, ::testing::ValuesIn(files),
                         [](const auto& param_info) {
                           std::string name = param_info.param.name;
                           for (char& letter : name)
                             if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '_';
                           return name;
                         });

}  // namespace
}  // namespace pentapost
