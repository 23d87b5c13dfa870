#include "server/log.hpp"

#include "pentapost/json/strict_reader.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pentapost::server {
namespace {

TEST(Log, WritesOneJsonObjectALine) {
  std::vector<std::string> lines;
  Log log{[&lines](const std::string& line) { lines.push_back(line); }};
  log.access({.id = "i",
              .method = "GET",
              .path = "/a\"\n\xff{}%v",
              .status = 200,
              .bytes = 12,
              .duration_ms = 1.5,
              .cl = ClTrace{.sha256 = "ab", .bytes = 34}});
  log.info("listening", {{"host", "::1"}, {"port", std::int64_t{8080}}});
  ASSERT_EQ(lines.size(), 2u);

  const auto access = json::Document::parse(lines[0]);
  ASSERT_TRUE(access) << lines[0];
  EXPECT_EQ(access->object().string("event"), "request");
  EXPECT_EQ(access->object().string("path"), "/a\"\n\xef\xbf\xbd{}%v");
  EXPECT_EQ(access->object().integer("cl_bytes", 0, 100), 34);
  EXPECT_EQ(access->object().string("cl_sha256"), "ab");
  EXPECT_EQ(lines[0].find('\n'), lines[0].size() - 1);
  const auto listening = json::Document::parse(lines[1]);
  ASSERT_TRUE(listening);
  EXPECT_EQ(listening->object().integer("port", 0, 65'535), 8080);
}

}  // namespace
}  // namespace pentapost::server
