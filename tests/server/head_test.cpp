#include "server/http/head.hpp"

#include <gtest/gtest.h>

namespace pentapost::server {
namespace {

Result<Head> parsed(const std::string& fields, const std::string& line = "POST /post HTTP/1.1") {
  return parse_head(line + "\r\nHost: a" + fields, {});
}

TEST(Head, ReadsLineFieldsAndLength) {
  const auto head = parsed("\r\nContent-Length: 12\r\nX-Two:  b c \t");
  ASSERT_TRUE(head);

  EXPECT_EQ(head->method, "POST");
  EXPECT_EQ(head->target, "/post");
  EXPECT_EQ(head->content_length, 12u);
  EXPECT_EQ(*find_field(head->headers, "x-two"), "b c");
  EXPECT_TRUE(head->keep_alive);
}

TEST(Head, RefusesWhatTwoReadersCouldTakeDifferently) {
  for (const char* fields : {
           "\r\nContent-Length: 5\r\nContent-Length: 6",
           "\r\nContent-Length: 5\r\nContent-Length: 5",
           "\r\nContent-Length: 5\r\nTransfer-Encoding: chunked",
           "\r\nTransfer-Encoding: chunked\r\nTransfer-Encoding: chunked",
           "\r\nTransfer-Encoding: gzip, chunked",
           "\r\nTransfer-Encoding: identity",
           "\r\nTransfer-Encoding: xchunked",
           "\r\nContent-Length: abc",
           "\r\nContent-Length: 5 5",
           "\r\nContent-Length: +5",
           "\r\nContent-Length: -1",
           "\r\nContent-Length: 0x5",
           "\r\nContent-Length: ",
           "\r\nContent-Length: 5,5",
           "\r\nContent-Length: 99999999999999999999999",
           "\r\nContent-Length : 5",
           "\r\n Content-Length: 5",
           "\r\nX-A: b\r\n folded",
           "\r\nX-A: b\nContent-Length: 5",
           "\r\nX-A: b\rContent-Length: 5",
           "\r\nX-A\x01: b",
           "\r\nNoColon",
           "\r\n: empty",
           "\r\nHost: b",
           "\r\nExpect: 200-ok",
       }) {
    SCOPED_TRACE(fields);
    const auto head = parsed(fields);
    ASSERT_FALSE(head);
    EXPECT_EQ(head.error().code, Code::bad_request);
  }
}

TEST(Head, RefusesDamagedRequestLines) {
  for (const char* line :
       {"", "GET", "GET /", "GET / HTTP/2.0", "GET / HTTP/1.1 ", "GET  / HTTP/1.1",
        " GET / HTTP/1.1", "GET post HTTP/1.1", "G\tT / HTTP/1.1", "GET /\x7f HTTP/1.1",
        "GET /\xc3\xa4 HTTP/1.1", "PRI * HTTP/2.0", "CONNECT a:80 HTTP/1.1", "GET / http/1.1"}) {
    SCOPED_TRACE(line);
    EXPECT_FALSE(parsed("", line));
  }
}

TEST(Head, NeedsAHostFromHttp11) {
  EXPECT_FALSE(parse_head("GET / HTTP/1.1", {}));
  EXPECT_TRUE(parse_head("GET / HTTP/1.0", {}));
}

TEST(Head, TakesTheFormThatProxiesSend) {
  EXPECT_EQ(parsed("", "GET http://host:80/a?b=c HTTP/1.1")->target, "/a?b=c");
  EXPECT_EQ(parsed("", "GET HTTP://host HTTP/1.1")->target, "/");
  EXPECT_EQ(parsed("", "GET http://host?b HTTP/1.1")->target, "/?b");
}

TEST(Head, ClosesWhenAskedToAndForHttp10) {
  EXPECT_FALSE(parsed("\r\nConnection: foo, Close")->keep_alive);
  EXPECT_FALSE(parsed("", "GET / HTTP/1.0")->keep_alive);
}

TEST(Head, BoundsSizeFieldsAndTarget) {
  EXPECT_EQ(parsed("\r\nX-A: " + std::string(20'000, 'a')).error().code, Code::head_too_large);
  EXPECT_EQ(parsed("", "GET /" + std::string(8'000, 'a') + " HTTP/1.1").error().code,
            Code::head_too_large);
  std::string many;
  for (int i = 0; i < 101; ++i) many += "\r\nX-A: b";
  EXPECT_EQ(parsed(many).error().code, Code::head_too_large);
}

}  // namespace
}  // namespace pentapost::server
