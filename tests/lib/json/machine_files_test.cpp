#include "pentapost/json/machine_files.hpp"

#include "lib/json/demo_definition.hpp"
#include "pentapost/core/sha256.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace pentapost::json {
namespace {

namespace fs = std::filesystem;
using sample::demo_definition;
using sample::dialects;
using sample::with;

/// A folder of machines that is removed at the end of a test.
class MachineFiles : public ::testing::Test {
 protected:
  MachineFiles() {
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() /
              ("machine_files_test." + std::to_string(getpid()) + "." + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MachineFiles() override { fs::remove_all(folder_); }

  void write(const std::string& path, const std::string& bytes) const {
    fs::create_directories((folder_ / path).parent_path());
    std::ofstream{folder_ / path, std::ios::binary} << bytes;
  }
  LoadReport load() const { return load_machines(folder_, dialects); }

  /// The one bad file that there must be.
  BadFile only_bad() const {
    const auto report = load();
    if (report.bad.size() != 1) {
      for (const auto& bad : report.bad) ADD_FAILURE() << text_of(bad);
      return {};
    }
    return report.bad.front();
  }

  fs::path folder_;
};

std::string demo_of_version(const std::string& version) {
  return with(demo_definition, R"("version": "1.0.0")", R"("version": ")" + version + "\"");
}

TEST_F(MachineFiles, AreLoadedByNameAndVersion) {
  write("demo/1.0.0.json", demo_definition);

  const auto report = load();

  EXPECT_TRUE(report.bad.empty());
  EXPECT_EQ(report.library.names(), std::vector<std::string>{"demo"});
  EXPECT_NE(report.library.find("demo", "1.0.0"), nullptr);
}

TEST_F(MachineFiles, OfferTheNewestByNumber) {
  write("demo/1.9.0.json", demo_of_version("1.9.0"));
  write("demo/1.10.0.json", demo_of_version("1.10.0"));
  write("demo/1.2.0.json", demo_of_version("1.2.0"));

  const auto report = load();

  ASSERT_TRUE(report.bad.empty());
  EXPECT_EQ(report.library.find("demo")->definition.version, "1.10.0");
}

TEST_F(MachineFiles, KeepTheirBytesAndHash) {
  const std::string bytes = demo_definition + "\r\n  \n";
  write("demo/1.0.0.json", bytes);

  const auto report = load();

  ASSERT_TRUE(report.bad.empty());
  EXPECT_EQ(report.library.find("demo")->bytes, bytes);
  EXPECT_EQ(report.library.find("demo")->definition.sha256, sha256_hex(bytes));
}

TEST_F(MachineFiles, NameFilePointerAndReasonOfABadOne) {
  write("demo/1.0.0.json",
        with(demo_definition, R"("max_speed_mm_s": 250)", R"("max_speed_mm_s": "fast")"));

  const auto bad = only_bad();

  EXPECT_EQ(bad.file, folder_ / "demo/1.0.0.json");
  EXPECT_EQ(bad.problem.pointer, "/axes/X/max_speed_mm_s");
  EXPECT_EQ(text_of(bad).find((folder_ / "demo/1.0.0.json").string() +
                              " at /axes/X/max_speed_mm_s: does not fit the schema"),
            0u)
      << text_of(bad);
}

TEST_F(MachineFiles, ServeTheOthersBesideABadOne) {
  write("demo/1.0.0.json", demo_definition);
  write("demo/1.1.0.json", "{");
  write("other/1.0.0.json", "");

  const auto report = load();

  EXPECT_EQ(report.bad.size(), 2u);
  ASSERT_NE(report.library.find("demo"), nullptr);
  EXPECT_EQ(report.library.find("demo")->definition.version, "1.0.0");
  EXPECT_EQ(report.library.find("other"), nullptr);
}

TEST_F(MachineFiles, RefuseANameThatIsNotThatOfTheFolder) {
  write("mill/1.0.0.json", demo_definition);

  EXPECT_EQ(only_bad().problem.pointer, "/name");
}

TEST_F(MachineFiles, RefuseAVersionThatIsNotThatOfTheFile) {
  write("demo/1.0.1.json", demo_definition);

  EXPECT_EQ(only_bad().problem.pointer, "/version");
}

TEST_F(MachineFiles, RefuseAnUnknownDialect) {
  write("demo/1.0.0.json", with(demo_definition, "heidenhain-iso", "klartext"));

  EXPECT_EQ(only_bad().problem.code, Code::unknown_dialect);
}

TEST_F(MachineFiles, RefuseAFileThatIsTooLarge) {
  write("demo/1.0.0.json", demo_definition + std::string(2'000'000, ' '));

  EXPECT_EQ(only_bad().problem.code, Code::too_large);
}

TEST_F(MachineFiles, RefuseMisplacedFiles) {
  write("demo.json", demo_definition);
  write("demo/1.0.0.jsn", demo_definition);
  write("demo/old/1.0.0.json", demo_definition);

  EXPECT_EQ(load().bad.size(), 3u);
}

TEST_F(MachineFiles, PassOverReadmeAndHiddenEntries) {
  write("demo/1.0.0.json", demo_definition);
  write("README.md", "# Machines\n");
  write(".git/config", "");
  write("demo/.1.0.0.json.swp", "");

  EXPECT_TRUE(load().bad.empty());
}

TEST_F(MachineFiles, AreNoneInAFolderThatIsNotThere) {
  const auto report = load_machines(folder_ / "nowhere", dialects);

  EXPECT_TRUE(report.library.empty());
  ASSERT_EQ(report.bad.size(), 1u);
  EXPECT_EQ(report.bad.front().file, folder_ / "nowhere");
}

TEST_F(MachineFiles, TakeAReleasedFileThatIsUnchanged) {
  write("demo/1.0.0.json", demo_definition);
  write("RELEASED.sha256",
        "# released definitions\n\n" + sha256_hex(demo_definition) + "  demo/1.0.0.json\n");

  EXPECT_TRUE(load().bad.empty());
}

TEST_F(MachineFiles, RefuseAReleasedFileThatDiffers) {
  write("demo/1.0.0.json", demo_definition + "\n");
  write("RELEASED.sha256", sha256_hex(demo_definition) + "  demo/1.0.0.json\n");

  const auto bad = only_bad();

  EXPECT_EQ(bad.file, folder_ / "demo/1.0.0.json");
  EXPECT_NE(bad.problem.message.find("was released"), std::string::npos);
  EXPECT_TRUE(load().library.empty());
}

TEST_F(MachineFiles, RefuseAReleasedFileThatIsMissing) {
  write("RELEASED.sha256", sha256_hex(demo_definition) + "  demo/1.0.0.json\n");

  EXPECT_EQ(only_bad().file, folder_ / "demo/1.0.0.json");
}

TEST_F(MachineFiles, RefuseADamagedListOfReleases) {
  write("demo/1.0.0.json", demo_definition);
  write("RELEASED.sha256", "0123  demo/1.0.0.json\n");

  EXPECT_NE(only_bad().problem.message.find("line 1"), std::string::npos);
}

TEST_F(MachineFiles, DoNotTakePipesForFiles) {
  write("demo/1.0.0.json", demo_definition);
  ASSERT_EQ(mkfifo((folder_ / "demo/1.1.0.json").c_str(), 0600), 0);

  EXPECT_EQ(load().bad.size(), 1u);
}

}  // namespace
}  // namespace pentapost::json
