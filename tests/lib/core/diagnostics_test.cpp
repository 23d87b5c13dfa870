#include "pentapost/core/diagnostics.hpp"

#include <gtest/gtest.h>

#include <string>

using namespace pentapost;

namespace {

Diagnostic remark(Severity severity, std::uint32_t cl_line) {
  return {severity, Code::unknown_statement, cl_line, "a remark"};
}

Diagnostics many(Severity severity, std::size_t count, std::uint32_t first_line) {
  Diagnostics diagnostics;
  for (std::size_t i = 0; i < count; ++i)
    diagnostics.add(remark(severity, first_line + static_cast<std::uint32_t>(i)));
  return diagnostics;
}

}  // namespace

TEST(Diagnostics, StartEmpty) {
  const Diagnostics diagnostics;

  EXPECT_EQ(diagnostics.total(), 0u);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_TRUE(diagnostics.list().empty());
}

TEST(Diagnostics, KeepTheFirstHundredOfASeverityAndCountAll) {
  const Diagnostics diagnostics = many(Severity::warning, 1000, 1);

  ASSERT_EQ(diagnostics.list().size(), 100u);
  EXPECT_EQ(diagnostics.list().back().cl_line, 100u);
  EXPECT_EQ(diagnostics.total(Severity::warning), 1000u);
  EXPECT_FALSE(diagnostics.keeps(Severity::warning));
}

TEST(Diagnostics, KeepErrorsBehindManyWarnings) {
  Diagnostics diagnostics = many(Severity::warning, 1000, 1);

  diagnostics.add(remark(Severity::error, 2000));

  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_EQ(diagnostics.list().back().cl_line, 2000u);
  EXPECT_EQ(diagnostics.total(), 1001u);
}

TEST(Diagnostics, CountWithoutKeeping) {
  Diagnostics diagnostics;

  diagnostics.count(Severity::error);

  EXPECT_TRUE(diagnostics.has_errors());
  EXPECT_TRUE(diagnostics.list().empty());
}

TEST(Diagnostics, AppendStaysWithinTheBound) {
  Diagnostics diagnostics = many(Severity::error, 99, 1);

  diagnostics.append(many(Severity::error, 150, 1000));

  ASSERT_EQ(diagnostics.list().size(), 100u);
  EXPECT_EQ(diagnostics.list().back().cl_line, 1000u);
  EXPECT_EQ(diagnostics.total(Severity::error), 249u);
}

TEST(Diagnostics, AppendKeepsTheOrder) {
  Diagnostics diagnostics = many(Severity::info, 2, 1);

  diagnostics.append(many(Severity::warning, 2, 10));

  ASSERT_EQ(diagnostics.list().size(), 4u);
  EXPECT_EQ(diagnostics.list()[1].cl_line, 2u);
  EXPECT_EQ(diagnostics.list()[2].cl_line, 10u);
  EXPECT_EQ(diagnostics.total(Severity::info), 2u);
  EXPECT_EQ(diagnostics.total(Severity::warning), 2u);
}
