#include "server/http/media_type.hpp"

#include <gtest/gtest.h>

#include <array>

namespace pentapost::server {
namespace {

constexpr std::array<std::string_view, 2> offered{"application/json", "text/plain"};

TEST(Negotiate, FollowsQualityThenTheServersOrder) {
  EXPECT_EQ(negotiate("", offered), "application/json");
  EXPECT_EQ(negotiate("*/*", offered), "application/json");
  EXPECT_EQ(negotiate("text/plain", offered), "text/plain");
  EXPECT_EQ(negotiate("text/*", offered), "text/plain");
  EXPECT_EQ(negotiate("application/json;q=0.5, TEXT/plain", offered), "text/plain");
  EXPECT_EQ(negotiate("text/html, */*;q=0.8", offered), "application/json");
  EXPECT_EQ(negotiate("*/*, application/json;q=0", offered), "text/plain");
}

TEST(Negotiate, FindsNone) {
  EXPECT_EQ(negotiate("image/png", offered), std::nullopt);
  EXPECT_EQ(negotiate("text/plain;q=0", offered), std::nullopt);
  EXPECT_EQ(negotiate("application/json;q=nan", offered), std::nullopt);
  EXPECT_EQ(negotiate("text", offered), std::nullopt);
}

TEST(MediaType, LeavesParametersAside) {
  EXPECT_EQ(media_type_of(" Text/Plain ; charset=utf-8"), "text/plain");
  EXPECT_EQ(parameter_of("a/b; x=1; Boundary=\"a;\\\"b\"", "boundary"), "a;\"b");
  EXPECT_EQ(parameter_of("a/b; x=1", "boundary"), std::nullopt);
}

TEST(AcceptsGzip, ReadsTheList) {
  EXPECT_TRUE(accepts_gzip("br, GZIP;q=0.3"));
  EXPECT_FALSE(accepts_gzip("br"));
  EXPECT_FALSE(accepts_gzip("gzip;q=0"));
  EXPECT_FALSE(accepts_gzip(""));
}

}  // namespace
}  // namespace pentapost::server
