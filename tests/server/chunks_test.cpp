#include "server/http/chunks.hpp"

#include <gtest/gtest.h>

namespace pentapost::server {
namespace {

TEST(ChunkDecoder, DecodesWhereverTheBytesAreCut) {
  const std::string wire = "4\r\nWiki\r\nA;name=\"v\"\r\n0123456789\r\n0\r\nTrailer: x\r\n\r\nNEXT";
  for (std::size_t cut = 0; cut <= wire.size(); ++cut) {
    SCOPED_TRACE(cut);
    ChunkDecoder decoder{100};
    std::string body;
    const auto first = decoder.feed(std::string_view{wire}.substr(0, cut), body);
    ASSERT_TRUE(first);
    const auto second = decoder.feed(std::string_view{wire}.substr(cut), body);
    ASSERT_TRUE(second);

    EXPECT_TRUE(decoder.finished());
    EXPECT_EQ(body, "Wiki0123456789");
    EXPECT_EQ(*first + *second, wire.size() - 4);
  }
}

TEST(ChunkDecoder, RefusesDamage) {
  for (const char* wire :
       {"x\r\n", "\r\n", "-1\r\n", "+1\r\na\r\n", "0x1\r\na\r\n", "1\na\r\n", "1\r\nab\r\n",
        "1\r\na\n", "1\r\r\n", "fffffffffffffffff\r\n", " 1\r\na\r\n"}) {
    SCOPED_TRACE(wire);
    ChunkDecoder decoder{100};
    std::string body;
    const auto used = decoder.feed(wire, body);
    ASSERT_FALSE(used);
    EXPECT_EQ(used.error().code, Code::bad_request);
  }
}

TEST(ChunkDecoder, RefusesByTheAnnouncedSizeBeforeTheBytesCome) {
  ChunkDecoder decoder{10};
  std::string body;
  ASSERT_TRUE(decoder.feed("6\r\n123456\r\n", body));
  const auto used = decoder.feed("5\r\n", body);

  ASSERT_FALSE(used);
  EXPECT_EQ(used.error().code, Code::body_too_large);
  EXPECT_EQ(body, "123456");
}

TEST(ChunkDecoder, BoundsExtensionsAndTrailers) {
  std::string body;
  ChunkDecoder extension{10};
  EXPECT_FALSE(extension.feed("1;" + std::string(5'000, 'x'), body));
  ChunkDecoder trailer{10};
  std::string wire = "0\r\n";
  for (int i = 0; i < 100; ++i) wire += "X: " + std::string(500, 'x') + "\r\n";
  EXPECT_FALSE(trailer.feed(wire, body));
}

}  // namespace
}  // namespace pentapost::server
