// Holds the source files against the table "who may include whom" of .github/CONTRIBUTING.md, and
// against the rules of style that can be seen in a line.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

using Names = std::set<std::string, std::less<>>;

struct SourceFile {
  std::string path;  ///< from the root of the repository, "lib/pentapost/core/units.hpp"
  std::vector<std::string> lines;

  bool is_header() const { return path.ends_with(".hpp"); }
};

SourceFile read_source(const std::filesystem::path& root, const std::filesystem::path& file) {
  SourceFile source{.path = std::filesystem::relative(file, root).generic_string(), .lines = {}};
  std::ifstream stream{file};
  for (std::string line; std::getline(stream, line);) source.lines.push_back(line);
  return source;
}

const std::vector<SourceFile>& sources() {
  static const std::vector<SourceFile> found = [] {
    const std::filesystem::path root{PENTAPOST_SOURCE_DIR};
    std::vector<SourceFile> files;
    for (const char* folder : {"lib", "server"}) {
      for (const auto& entry : std::filesystem::recursive_directory_iterator{root / folder}) {
        const auto extension = entry.path().extension();
        if (extension == ".hpp" || extension == ".cpp")
          files.push_back(read_source(root, entry.path()));
      }
    }
    return files;
  }();
  return found;
}

/// What an #include line names, with its quotes or brackets; empty: no such line.
std::string included(std::string_view line) {
  constexpr std::string_view directive = "#include ";
  if (!line.starts_with(directive)) return {};
  line.remove_prefix(directive.size());
  const auto end = line.find_last_of("\">");
  return std::string{line.substr(0, end == std::string_view::npos ? line.size() : end + 1)};
}

/// The first `count` folders of a path.
std::string folders(std::string_view path, int count) {
  std::size_t end = 0;
  for (int i = 0; i < count && end != std::string_view::npos; ++i)
    end = path.find('/', end == 0 ? 0 : end + 1);
  return std::string{path.substr(0, end)};
}

// Folder of lib -> folders of lib that it may include, itself aside.
const std::map<std::string, Names, std::less<>> lib_layers{
    {"core", {}},
    {"path", {"core"}},
    {"machine", {"core"}},
    {"json", {"core", "machine"}},
    {"cl", {"core", "path"}},
    {"clearance", {"core", "path", "machine"}},
    {"kinematics", {"core", "path", "machine"}},
    {"plan", {"core", "path", "machine", "kinematics"}},
    {"nc", {"core", "path", "machine"}},
    {"verify", {"core", "path", "machine", "kinematics", "nc"}},
    {"analysis", {"core", "path", "machine", "kinematics", "plan"}},
    {"reorient", {"core", "path", "kinematics", "plan", "analysis"}},
    {"jobs",
     {"core", "path", "machine", "clearance", "cl", "kinematics", "plan", "analysis", "reorient",
      "nc", "verify"}},
};

// Third-party header -> the places that may include it; "/" at the end: a folder, .cpp only.
const std::map<std::string, std::vector<std::string>, std::less<>> third_party{
    {"<httplib.h>", {"server/http/transport.cpp"}},
    {"<nlohmann/", {"lib/pentapost/json/", "server/json/"}},
    {"<valijson/", {"lib/pentapost/json/", "server/json/"}},
    {"<spdlog/", {"server/log.cpp"}},
    {"<CLI/", {"server/options.cpp"}},
    {"<fast_float/", {"lib/pentapost/core/"}},
    {"<openssl/", {"lib/pentapost/core/"}},
    {"<ccd/", {"lib/pentapost/clearance/"}},
};

bool in_place(std::string_view file, const std::string& place) {
  if (!place.ends_with('/')) return file == place;
  return file.starts_with(place) && file.ends_with(".cpp");
}

/// lib header (without quotes, from "pentapost/") included by a file of lib.
bool lib_may(std::string_view file, const std::string& header) {
  const std::string from = folders(file.substr(std::string_view{"lib/pentapost/"}.size()), 1);
  const std::string to = folders(std::string_view{header}.substr(10), 1);
  if (const bool reads = file.starts_with("lib/pentapost/nc/readers"); reads || from == "verify") {
    if (to == "nc")
      return header == "pentapost/nc/reader.hpp" ||
             (reads && header.starts_with("pentapost/nc/readers/"));
  }
  if (file.starts_with("lib/pentapost/nc/lint_rules") && to == "nc")
    return header == "pentapost/nc/lint.hpp" || header.starts_with("pentapost/nc/lint_rules/");
  if (file.starts_with("lib/pentapost/nc/dialects") && header.starts_with("pentapost/nc/reader"))
    return false;
  const auto layer = lib_layers.find(from);
  return layer != lib_layers.end() && (from == to || layer->second.contains(to));
}

/// Header of lib or server included by a file of server.
bool server_may(std::string_view file, const std::string& header) {
  const bool is_codec = file.starts_with("server/json/");
  const bool is_endpoint = file.starts_with("server/endpoints") || file.starts_with("server/app.");
  const auto starts = [&](std::initializer_list<std::string_view> allowed) {
    return std::any_of(allowed.begin(), allowed.end(),
                       [&](std::string_view place) { return header.starts_with(place); });
  };
  if (is_codec)
    return starts({"pentapost/core/", "pentapost/path/", "pentapost/machine/", "pentapost/json/",
                   "pentapost/jobs/", "pentapost/nc/dialect.hpp", "server/json/",
                   "server/http/message.hpp"});
  if (is_endpoint)
    return starts({"pentapost/core/", "pentapost/jobs/", "pentapost/machine/",
                   "pentapost/nc/dialect.hpp", "pentapost/nc/lint.hpp", "server/"}) &&
           header != "server/http/transport.hpp";
  return true;
}

/// Whether the file may have the #include; `what` as included() gives it.
bool may_include(std::string_view file, const std::string& what) {
  const bool is_lib = file.starts_with("lib/");
  const std::string name = what.substr(1, what.size() - 2);
  if (what.front() == '"') {
    if (name.starts_with("pentapost/"))
      return is_lib ? lib_may(file, name) : server_may(file, name);
    return !is_lib && name.starts_with("server/") && server_may(file, name);
  }
  for (const auto& [header, places] : third_party) {
    if (what.starts_with(header))
      return std::any_of(places.begin(), places.end(),
                         [&](const std::string& place) { return in_place(file, place); });
  }
  if (!is_lib) return true;
  const bool is_standard = name.find_first_of("./") == std::string::npos;
  return is_standard || name.starts_with("Eigen/");
}

/// What lib must not use: it doesn't print, log, read files or the environment, start threads.
const Names not_in_lib{"<iostream>", "<fstream>", "<cstdio>", "<filesystem>",
                       "<thread>",   "<future>",  "<locale>", "<iomanip>"};

}  // namespace

TEST(Layers, FindTheSources) { EXPECT_GT(sources().size(), 20u); }

TEST(Layers, AreKeptByEveryInclude) {
  for (const auto& source : sources()) {
    for (const auto& line : source.lines) {
      const std::string what = included(line);
      if (what.empty()) continue;
      EXPECT_TRUE(may_include(source.path, what)) << source.path << ": " << what;
    }
  }
}

TEST(Layers, KeepInputAndOutputOutOfTheLibrary) {
  for (const auto& source : sources()) {
    if (!source.path.starts_with("lib/") ||
        source.path.starts_with("lib/pentapost/json/machine_files."))
      continue;
    for (const auto& line : source.lines)
      EXPECT_FALSE(not_in_lib.contains(included(line))) << source.path << ": " << line;
  }
}

// The checks above would pass over everything if may_include() said yes to everything.
TEST(Layers, RefuseWhatTheTableForbids) {
  const std::array<std::pair<const char*, const char*>, 14> forbidden{{
      {"lib/pentapost/core/units.hpp", "\"pentapost/path/arc.hpp\""},
      {"lib/pentapost/verify/prove.cpp", "\"pentapost/plan/branches.hpp\""},
      {"lib/pentapost/verify/prove.cpp", "\"pentapost/nc/dialect.hpp\""},
      {"lib/pentapost/nc/readers/fanuc_30i.cpp", "\"pentapost/nc/dialects/words.hpp\""},
      {"lib/pentapost/nc/readers/fanuc_30i.cpp", "\"pentapost/nc/dialect.hpp\""},
      {"lib/pentapost/nc/dialects/fanuc_30i.cpp", "\"pentapost/nc/readers/words.hpp\""},
      {"lib/pentapost/jobs/post.cpp", "\"pentapost/json/machine_files.hpp\""},
      {"lib/pentapost/jobs/post.cpp", "<nlohmann/json.hpp>"},
      {"lib/pentapost/json/strict_reader.hpp", "<nlohmann/json.hpp>"},
      {"lib/pentapost/jobs/post.cpp", "\"server/app.hpp\""},
      {"lib/pentapost/jobs/post.cpp", "\"sample/chains.hpp\""},
      {"server/app.cpp", "<httplib.h>"},
      {"server/endpoints/post.cpp", "\"pentapost/plan/branches.hpp\""},
      {"server/main.cpp", "\"tests/sample/chains.hpp\""},
  }};
  for (const auto& [file, what] : forbidden)
    EXPECT_FALSE(may_include(file, what)) << file << ": " << what;
}

TEST(Layers, AllowWhatTheTableAllows) {
  const std::array<std::pair<const char*, const char*>, 6> allowed{{
      {"lib/pentapost/plan/branches.cpp", "\"pentapost/kinematics/inverse.hpp\""},
      {"lib/pentapost/core/units.hpp", "<Eigen/Dense>"},
      {"lib/pentapost/core/units.hpp", "<vector>"},
      {"lib/pentapost/json/definition_json.cpp", "<nlohmann/json.hpp>"},
      {"lib/pentapost/nc/readers/fanuc_30i.cpp", "\"pentapost/nc/reader.hpp\""},
      {"server/http/transport.cpp", "<httplib.h>"},
  }};
  for (const auto& [file, what] : allowed)
    EXPECT_TRUE(may_include(file, what)) << file << ": " << what;
}

TEST(Style, HeadersStartWithPragmaOnce) {
  for (const auto& source : sources()) {
    if (!source.is_header()) continue;
    ASSERT_FALSE(source.lines.empty()) << source.path;
    EXPECT_EQ(source.lines.front(), "#pragma once") << source.path;
  }
}

TEST(Style, HeadersHaveNoUsingNamespace) {
  for (const auto& source : sources()) {
    if (!source.is_header()) continue;
    for (const auto& line : source.lines)
      EXPECT_EQ(line.find("using namespace"), std::string::npos) << source.path << ": " << line;
  }
}

TEST(Style, FilesStayBelowFiveHundredLines) {
  for (const auto& source : sources()) EXPECT_LE(source.lines.size(), 500u) << source.path;
}

TEST(Style, CodeIsAscii) {
  for (const auto& source : sources()) {
    for (const auto& line : source.lines) {
      const bool is_ascii = std::all_of(line.begin(), line.end(),
                                        [](char letter) { return letter >= ' ' && letter <= '~'; });
      EXPECT_TRUE(is_ascii) << source.path << ": " << line;
    }
  }
}

// acos and asin of a dot product lose half their digits where it matters.
TEST(Style, AnglesBetweenVectorsComeFromAtan2) {
  for (const auto& source : sources()) {
    for (const auto& line : source.lines) {
      const bool is_sine_of_product =
          line.find("asin(") != std::string::npos && line.find(".dot(") != std::string::npos;
      EXPECT_FALSE(is_sine_of_product) << source.path << ": " << line;
      EXPECT_EQ(line.find("std::acos("), std::string::npos) << source.path << ": " << line;
    }
  }
}

TEST(Style, NothingIsLeftToDo) {
  for (const auto& source : sources()) {
    for (const auto& line : source.lines) {
      for (const char* mark : {"TODO", "FIXME", "XXX", "HACK"})
        EXPECT_EQ(line.find(mark), std::string::npos) << source.path << ": " << line;
    }
  }
}
