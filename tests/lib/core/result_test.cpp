#include "pentapost/core/result.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>

using namespace pentapost;

namespace {

Result<int> refused() { return Problem{.code = Code::bad_number, .message = "no number"}; }

}  // namespace

TEST(Result, HoldsAValue) {
  const Result<std::string> result{std::string{"M30"}};

  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(*result, "M30");
  EXPECT_EQ(result->size(), 3u);
}

TEST(Result, HoldsAProblem) {
  const auto result = refused();

  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, Code::bad_number);
  EXPECT_EQ(result.error().message, "no number");
}

TEST(Result, ThrowsWhereTheOtherIsAskedFor) {
  EXPECT_ANY_THROW((void)refused().value());
  EXPECT_ANY_THROW((void)ok().error());
}

TEST(Result, GivesAwayWhatItHolds) {
  Result<std::unique_ptr<int>> result{std::make_unique<int>(7)};

  const std::unique_ptr<int> taken = std::move(result).value();

  EXPECT_EQ(*taken, 7);
}

TEST(Result, TellsAStatusFromAProblem) {
  EXPECT_TRUE(ok().has_value());
  const Status refused_status{Problem{.code = Code::defect, .message = ""}};

  EXPECT_FALSE(refused_status.has_value());
}

TEST(Codes, HaveNamesThatDiffer) {
  for (std::size_t i = 0; i < code_rows.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(code_rows[i].name, code_rows[j].name);
}

TEST(Codes, HaveNamesInLowerSnake) {
  for (const auto& row : code_rows) {
    EXPECT_FALSE(row.title.empty()) << row.name;
    EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos)
        << row.name;
  }
}
