// What a CAM file or a client writes into names and comments never becomes a word of the program.

#include "pentapost/jobs/post.hpp"
#include "sample_server.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::server {
namespace {

/// Texts that end a comment, a block, a line or a program on some control, and start a motion.
const std::vector<std::string>& hostile_texts() {
  static const std::vector<std::string> texts{"A\rG1 X99",
                                              "A\nG1 X99",
                                              "A\r\nN9 G01 X+99 *",
                                              "A\vG1 X99",
                                              "A\fG1 X99",
                                              "A\xc2\x85G1 X99",
                                              "A\xe2\x80\xa8G1",
                                              ") G1 X99 (",
                                              ")",
                                              "(",
                                              "* N9 G01 X+99 *",
                                              "*\nN9 G01 X+99",
                                              "%",
                                              "%X G71 *",
                                              "; G01 X+99",
                                              "/G1 X99",
                                              "M30",
                                              "O1234",
                                              "#1=99",
                                              "\\",
                                              "{tool} {speed}",
                                              "\x1a",
                                              "\x7f",
                                              "\xff\xfe)G1",
                                              "\xef\xbc\x89G1",
                                              std::string(59, 'b') + " G01 X+99",
                                              std::string(60, 'b') + "G01 X+99 *",
                                              std::string(500, '-'),
                                              std::string{"A\0G1 X99", 8}};
  return texts;
}

/// The lines of a program without comments, block numbers and name: all that a control executes.
std::vector<std::string> executed_lines(const std::string& nc, bool heidenhain) {
  std::vector<std::string> lines;
  std::size_t start = 0;
  while (start < nc.size()) {
    const auto end = nc.find('\n', start);
    std::string line = nc.substr(start, end - start);
    start = end == std::string::npos ? nc.size() : end + 1;
    if (heidenhain) {
      if (line.starts_with('N')) line.erase(0, line.find(' ') + 1);
      if (line.starts_with('%') && line.ends_with(" G71 *")) line = "%NAME G71 *";
      const bool comment = line.starts_with("; ") && line.find('*') == line.size() - 1;
      if (comment) continue;
    } else {
      const auto open = line.find('(');
      if (open != std::string::npos && line.find(')') == line.size() - 1) line.erase(open);
      line.erase(line.find_last_not_of(' ') + 1);
      // A name that is a number is the number of the program, in its own line.
      if (lines.size() == 1 && line == "O1234") line = "O0001";
      if (line.empty()) continue;
    }
    lines.push_back(line);
  }
  return lines;
}

/// The program of a job whose texts are `text`; the CL data carry it where a line can hold it.
Result<jobs::PostReport> post_with(const std::string& dialect, const std::string& text) {
  std::string line = text;
  std::erase_if(line, [](char c) { return c == '\r' || c == '\n'; });
  const auto machines = sample::library();
  jobs::PostJob job{.machine = machines.find("demo")->definition, .path = {}};
  job.path = jobs::ClText{.text = "PARTNO " + line + "\nUNITS/MM\nTOOL PATH/" + line + ",TOOL," +
                                  line + "\nLOADTL/5\nFEDRAT/2000,MMPM\nGOTO/0,0,9,0,0,1\nPPRINT " +
                                  line + "\nREMARK " + line + "\nGOTO/1,2,3,0,0,1\nFINI\n"};
  job.post.dialect = dialect;
  job.post.program_name = text;
  return jobs::post(job);
}

TEST(ForeignText, NeverBecomesAWordOfTheProgram) {
  for (const std::string dialect : {"heidenhain-iso", "fanuc-30i"}) {
    const bool heidenhain = dialect == "heidenhain-iso";
    const auto plain = post_with(dialect, "PLAIN");
    ASSERT_TRUE(plain) << plain.error().message;
    const auto expected = executed_lines(plain->nc, heidenhain);
    ASSERT_GT(expected.size(), 5u);
    for (const auto& text : hostile_texts()) {
      SCOPED_TRACE(dialect + ": " + ::testing::PrintToString(text));
      const auto report = post_with(dialect, text);
      ASSERT_TRUE(report) << report.error().message;
      EXPECT_EQ(executed_lines(report->nc, heidenhain), expected);
      EXPECT_TRUE(std::ranges::all_of(report->nc,
                                      [](char c) { return (c >= ' ' && c < 0x7f) || c == '\n'; }));
    }
  }
}

TEST(ForeignText, OfAnInsertThatMovesAnAxisIsRefused) {
  const auto machines = sample::library();
  for (const std::string inserted :
       {"G1 X99", "G91", "G10 L2 P1 X0 Y0 Z10", "G92 X0", "G68 X0 Y0 R90", "M98 P1", "G65 P9000",
        "M30", "#1=5", "G53 Z0", "G28 Z0", "%"}) {
    SCOPED_TRACE(inserted);
    jobs::PostJob job{.machine = machines.find("demo")->definition, .path = {}};
    job.path =
        jobs::ClText{.text = "UNITS/MM\nLOADTL/5\nFEDRAT/2000,MMPM\nGOTO/0,0,9,0,0,1\nINSERT " +
                             inserted + "\nGOTO/1,2,3,0,0,1\nFINI\n"};

    const auto report = jobs::post(job);

    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().code, Code::not_in_dialect);
    EXPECT_EQ(report.error().cl_line, 5);
  }
}

}  // namespace
}  // namespace pentapost::server
