#include "server/json/json_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pentapost::server {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  append_json_string(out, text);
  return out;
}

TEST(JsonString, EscapesWhatJsonDemands) {
  EXPECT_EQ(escaped("a\"b\\c\n\r\t\x01\x1f\x7f"), R"("a\"b\\c\n\r\t\u0001\u001f\u007f")");
  EXPECT_EQ(escaped(std::string_view{"\0", 1}), R"("\u0000")");
}

TEST(JsonString, KeepsUtf8AndReplacesTheRest) {
  EXPECT_EQ(escaped("\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80"),
            "\"\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\"");
  // Latin-1, a lone continuation, overlong forms, a surrogate, beyond U+10FFFF, a cut sequence.
  for (const char* bad : {"\xe4", "\x80"}) EXPECT_EQ(escaped(bad), "\"\xef\xbf\xbd\"");
  for (const char* bad : {"\xc0\xaf", "\xe2\x82"})
    EXPECT_EQ(escaped(bad), "\"\xef\xbf\xbd\xef\xbf\xbd\"");
  EXPECT_EQ(escaped("\xed\xa0\x80"), "\"\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\"");
  EXPECT_EQ(escaped("\xf4\x90\x80\x80").size(), 2u + 4u * 3u);
}

TEST(JsonWriter, PutsCommasBetweenMembersOnly) {
  std::string out;
  JsonWriter writer{out};
  writer.begin_object().key("a").begin_array().number(0.1).number(-0.5).begin_object().end_object();
  writer.end_array().key("b").boolean(true).key("c").null().key("d").integer(7).end_object();

  EXPECT_EQ(out, R"({"a":[0.1,-0.5,{}],"b":true,"c":null,"d":7})");
}

TEST(JsonWriter, NumbersReadBackExactly) {
  for (const double number : {1.0 / 3.0, 1e-300, 1.7976931348623157e308, 123456789.123456789}) {
    std::string out;
    JsonWriter{out}.number(number);
    EXPECT_EQ(std::stod(out), number);
  }
}

TEST(JsonWriter, ThrowsOnNumbersThatAreNotFinite) {
  std::string out;
  JsonWriter writer{out};
  EXPECT_THROW(writer.number(std::nan("")), std::logic_error);
  EXPECT_THROW(writer.number(std::numeric_limits<double>::infinity()), std::logic_error);
}

}  // namespace
}  // namespace pentapost::server
