#include "server/http/form.hpp"

#include <gtest/gtest.h>

namespace pentapost::server {
namespace {

constexpr const char* type = "multipart/form-data; boundary=\"b d\"";

TEST(Form, ReadsFieldsWithAnyBytes) {
  const std::string body =
      "preamble\r\n--b d\r\nContent-Disposition: form-data; name=\"machine\"\r\n\r\ndemo\r\n"
      "--b d\r\ncontent-disposition: form-data; name=\"cl\"; filename=\"a.cls\"\r\n"
      "Content-Type: text/plain\r\n\r\nGOTO/1\r\n--b\n\r\n--b d\r\n"
      "Content-Disposition: form-data; name=job\r\n\r\n\r\n--b d--\r\nepilogue";
  const auto fields = read_form(type, body);
  ASSERT_TRUE(fields);

  ASSERT_EQ(fields->size(), 3u);
  EXPECT_EQ((*fields)[0].name, "machine");
  EXPECT_EQ((*fields)[0].content, "demo");
  EXPECT_EQ((*fields)[1].name, "cl");
  EXPECT_EQ((*fields)[1].content, "GOTO/1\r\n--b\n");
  EXPECT_EQ((*fields)[1].file_name, "a.cls");
  EXPECT_EQ((*fields)[0].file_name, "");
  EXPECT_EQ((*fields)[2].name, "job");
  EXPECT_EQ((*fields)[2].content, "");
}

TEST(Form, RefusesDamage) {
  const std::string disposition = "Content-Disposition: form-data; name=\"cl\"";
  for (const std::string& body : {
           std::string{},
           std::string{"--b d"},
           std::string{"--b d\r\n"},
           std::string{"nothing"},
           "--b d\r\n" + disposition,
           "--b d\r\n" + disposition + "\r\n\r\nopen",
           "--b d\r\n" + disposition + "\r\n--b d--",
           "--b dx\r\n" + disposition + "\r\n\r\n\r\n--b d--",
           std::string{"--b d\r\n\r\nno header\r\n--b d--"},
           std::string{"--b d\r\nContent-Disposition: form-data\r\n\r\nno name\r\n--b d--"},
           std::string{"--b d\r\nContent-Disposition: attachment; name=\"cl\"\r\n\r\n\r\n--b d--"},
       }) {
    SCOPED_TRACE(body);
    const auto fields = read_form(type, body);
    ASSERT_FALSE(fields);
    EXPECT_EQ(fields.error().code, Code::bad_form);
  }
}

TEST(Form, NeedsABoundary) {
  EXPECT_FALSE(read_form("multipart/form-data", "--\r\n"));
  EXPECT_FALSE(read_form("multipart/form-data; boundary=", "--\r\n"));
  EXPECT_FALSE(read_form("multipart/form-data; boundary=" + std::string(71, 'b'), "--\r\n"));
}

TEST(Form, BoundsTheFields) {
  std::string body;
  for (int i = 0; i < 17; ++i)
    body += "--b\r\nContent-Disposition: form-data; name=\"cl\"\r\n\r\n\r\n";
  EXPECT_FALSE(read_form("multipart/form-data; boundary=b", body + "--b--"));
}

}  // namespace
}  // namespace pentapost::server
