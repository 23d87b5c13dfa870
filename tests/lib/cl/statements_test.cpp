#include "pentapost/cl/statements.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace pentapost::cl {
namespace {

using Lines = std::vector<std::pair<std::string, std::uint32_t>>;

Lines lines_of(std::string_view text) {
  Statements statements{text};
  Statement statement;
  Lines found;
  while (statements.next(statement))
    if (statement.kind == Statement::Kind::statement)
      found.emplace_back(std::string{statement.text}, statement.line);
  return found;
}

TEST(Statements, JoinsANumberThatIsCutAtColumn72WithoutABlank) {
  EXPECT_EQ(lines_of("GOTO/1,2,3,0,0$\n.5,0\nEND\n"),
            (Lines{{"GOTO/1,2,3,0,0.5,0", 1}, {"END", 3}}));
}

TEST(Statements, TakesBlanksBehindTheContinuationMark) {
  EXPECT_EQ(lines_of("GOTO/1,  $  \n   2,3\n"), (Lines{{"GOTO/1,     2,3", 1}}));
}

TEST(Statements, EndsTheStatementAtAComment) {
  EXPECT_EQ(lines_of("GOTO/1,2,3 $$ 4,5,6\n$$ all comment $\nEND"),
            (Lines{{"GOTO/1,2,3", 1}, {"END", 3}}));
}

TEST(Statements, KeepsDollarsWithinQuotes) {
  EXPECT_EQ(lines_of("UNKNWN/'$$*TLAXIS',1\nEND"),
            (Lines{{"UNKNWN/'$$*TLAXIS',1", 1}, {"END", 2}}));
}

TEST(Statements, TakesAnApostropheForNoQuote) {
  EXPECT_EQ(lines_of("TLDATA/JOHN'S,1,$\n2\nEND"), (Lines{{"TLDATA/JOHN'S,1,2", 1}, {"END", 3}}));
}

TEST(Statements, NeverContinuesFreeText) {
  EXPECT_EQ(lines_of("PARTNO COST 5$\nGOTO/1,2,3\n"),
            (Lines{{"PARTNO COST 5$", 1}, {"GOTO/1,2,3", 2}}));
}

TEST(Statements, KnowsAllLineEnds) {
  const Lines expected{{"A", 1}, {"B", 2}, {"C", 3}};
  EXPECT_EQ(lines_of("A\nB\nC"), expected);
  EXPECT_EQ(lines_of("A\r\nB\r\nC\r\n"), expected);
  EXPECT_EQ(lines_of("A\rB\rC\r"), expected);
  EXPECT_EQ(lines_of("A\r\nB\rC\n"), expected);
}

TEST(Statements, CountsEmptyLines) { EXPECT_EQ(lines_of("\n\n  \n\tA\n"), (Lines{{"A", 4}})); }

TEST(Statements, SkipsAByteOrderMark) {
  EXPECT_EQ(lines_of("\xEF\xBB\xBF"
                     "A"),
            (Lines{{"A", 1}}));
}

TEST(Statements, EndsAContinuationAtTheEndOfTheText) {
  EXPECT_EQ(lines_of("A,$"), (Lines{{"A,", 1}}));
}

TEST(Statements, ContinuesCreosDataComments) {
  Statements statements{"$$-> CSYS / 1, $\n 2\nEND\n"};
  Statement statement;
  ASSERT_TRUE(statements.next(statement));
  EXPECT_EQ(statement.kind, Statement::Kind::data_comment);
  EXPECT_EQ(statement.text, "CSYS / 1,  2");
  ASSERT_TRUE(statements.next(statement));
  EXPECT_EQ(statement.text, "END");
}

}  // namespace
}  // namespace pentapost::cl
