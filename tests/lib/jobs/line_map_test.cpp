#include "pentapost/jobs/line_map.hpp"

#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using Kind = jobs::LineMap::Kind;
using Reason = jobs::InsertedStretch::Reason;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in{text};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

jobs::PostReport posted(jobs::PostJob job) {
  job.post.line_map = true;
  auto report = jobs::post(job);
  EXPECT_TRUE(report) << report.error().message;
  return report ? *std::move(report) : jobs::PostReport{};
}

/// With TCP the X word of a block that ends at a CL point is that of the CL line.
TEST(LineMap, LeadsFromEveryBlockToTheClLineWithItsWords) {
  for (const char* machine : {"hermle-c600u", "haas-umc-750", "dmu-125p"}) {
    auto job = sample::cl_job(machine, sample::cl_program("GOTO/1.5,0,10,0,0,1\n"
                                                          "GOTO/2.5,0,0,0,0.6,0.8\n"
                                                          "GOTO/13.5,0,0,0.6,0,0.8\n"
                                                          "GOTO/24.5,0,0,0.6,0,0.8\n"));
    job.post.output = Output::tcp;
    auto& controller = job.machine.controller;
    if (controller.dialect == "fanuc-30i") controller.options["modal_words"] = false;
    job.gauge_length_mm = {{1, 100.0}};
    const auto report = posted(job);
    const auto nc = lines_of(report.nc);
    const auto cl = lines_of(std::get<jobs::ClText>(job.path).text);
    ASSERT_TRUE(report.line_map) << machine;
    const auto& map = *report.line_map;
    ASSERT_EQ(map.nc_line.size(), report.blocks);
    ASSERT_EQ(map.cl_line.size(), report.blocks);
    int ends = 0;
    for (std::size_t i = 0; i < map.nc_line.size(); ++i) {
      ASSERT_LE(map.nc_line[i], nc.size());
      if (map.kind[i] == Kind::off_path || map.fraction[i] != 1.0) continue;
      const std::string& goto_line = cl[map.cl_line[i] - 1];
      const std::string x = goto_line.substr(5, goto_line.find(',') - 5);
      const std::string& block = nc[map.nc_line[i] - 1];
      EXPECT_TRUE(block.find("X" + x) != std::string::npos ||
                  block.find("X+" + x) != std::string::npos)
          << machine << ": " << block << " is not of " << goto_line;
      ++ends;
    }
    EXPECT_GE(ends, 4) << machine;
  }
}

TEST(LineMap, CountsTheInsertedPointsOfEveryClMove) {
  const auto report =
      posted(sample::cl_job("hermle-c600u", sample::papers_text("cripps-2017-original.cl")));
  std::uint64_t inside = 0;
  for (const double fraction : report.line_map->fraction) inside += fraction != 1.0 ? 1U : 0U;
  std::uint64_t told = 0;
  for (const auto& each : report.insertions) told += each.points;
  EXPECT_EQ(inside, report.inserted_points);
  EXPECT_EQ(told, report.inserted_points);
  EXPECT_GT(told, 0U);
}

TEST(LineMap, TellsTurningFromArcs) {
  auto job = sample::cl_job("hermle-c600u", sample::cl_program("GOTO/0,0,0,0,0,1\n"
                                                               "GOTO/10,0,0,0,0,1\n"
                                                               "GOTO/30,0,0,0,0.6,0.8\n"
                                                               "GOTO/50,0,0,0.6,0,0.8\n"));
  job.post.output = Output::axes;
  const auto report = posted(job);
  ASSERT_FALSE(report.insertions.empty());
  for (const auto& each : report.insertions) EXPECT_EQ(each.reason, Reason::turning);
  EXPECT_EQ(report.insertions.front().from_cl_line, 7U);
  EXPECT_EQ(report.insertions.back().to_cl_line, 8U);
}

TEST(LineMap, IsLeftOutWhereNobodyAsks) {
  const auto report =
      jobs::post(sample::cl_job("hermle-c600u", sample::papers_text("cripps-2017-original.cl")));
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->line_map);
}

}  // namespace
}  // namespace pentapost
