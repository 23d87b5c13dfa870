#include "pentapost/jobs/compare_rows.hpp"

#include "lib/jobs/job_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace pentapost {
namespace {

using jobs::CompareFigures;
using jobs::LimitsKnown;
using Names = std::vector<std::string>;

/// What is said of the machine of each name.
using Sayings = std::map<std::string, Result<CompareFigures>>;

jobs::CompareJob job_of(const Names& names) {
  jobs::CompareJob job{.job = sample::cl_job("generic-3axis", ""), .machines = {}};
  for (const auto& name : names) {
    job.machines.push_back(job.job.machine);
    job.machines.back().name = name;
  }
  return job;
}

jobs::AxisDemandReport peak(double ratio) { return {.name = "C", .peak_ratio = ratio}; }

Names order_of(const Sayings& sayings, const Names& given) {
  const auto rows = jobs::compare_rows(
      job_of(given),
      {.figures = [&](const machine::Definition& machine) { return sayings.at(machine.name); }});
  Names names;
  for (const auto& row : rows) names.push_back(row.name);
  return names;
}

/// Each row is worse than the one before by one word of the order, and better by all that come
/// after it.
TEST(CompareRows, AreInTheOrderThatIsDocumented) {
  const auto figures = [](LimitsKnown known, bool within, double time_s, std::uint64_t retracts,
                          double ratio) {
    return CompareFigures{.limits_known = known,
                          .within_limits = within,
                          .predicted_time_s = time_s,
                          .retracts = retracts,
                          .peak = peak(ratio)};
  };
  auto without_ratio = figures(LimitsKnown::none, true, 0.1, 0, 0.0);
  without_ratio.peak.reset();
  auto without_ratio_slow = without_ratio;
  without_ratio_slow.predicted_time_s = 0.2;
  const Sayings sayings{
      {"n", figures(LimitsKnown::all, true, 9.0, 5, 0.5)},
      {"m", figures(LimitsKnown::all, true, 9.0, 5, 0.6)},
      {"l", figures(LimitsKnown::all, true, 9.0, 6, 0.4)},
      {"k", figures(LimitsKnown::all, true, 9.1, 4, 0.3)},
      {"i", figures(LimitsKnown::some, true, 8.0, 3, 0.2)},
      {"h", figures(LimitsKnown::all, false, 0.9, 0, 2.0)},
      {"g", figures(LimitsKnown::some, false, 0.8, 0, 2.0)},
      {"f", without_ratio},
      {"e", without_ratio_slow},
      {"d", Problem{.code = Code::out_of_reach, .message = "no"}},
      {"o", Problem{.code = Code::bad_option, .message = "no"}},
  };
  Names expected{"n", "m", "l", "k", "i", "h", "g", "f", "e", "d", "o"};
  std::mt19937_64 random{42};
  for (int i = 0; i < 20; ++i) {
    Names given = expected;
    std::shuffle(given.begin(), given.end(), random);
    ASSERT_EQ(order_of(sayings, given), expected);
  }
}

/// 1.5 s as two machines sum it up.
TEST(CompareRows, TakeTheLastDigitsOfATimeForEqual) {
  const Sayings sayings{{"b", CompareFigures{.limits_known = LimitsKnown::all,
                                             .predicted_time_s = 1.4999999999999998,
                                             .peak = peak(0.9)}},
                        {"a", CompareFigures{.limits_known = LimitsKnown::all,
                                             .predicted_time_s = 1.5000000000000022,
                                             .peak = peak(0.1)}}};
  EXPECT_EQ(order_of(sayings, {"b", "a"}), (Names{"a", "b"}));
}

TEST(CompareRows, OfOneNameStayInTheOrderOfTheJob) {
  const Sayings sayings{{"a", CompareFigures{}}};
  const auto rows =
      jobs::compare_rows(job_of({"a", "a", "a"}),
                         {.figures = [&](const machine::Definition&) { return sayings.at("a"); }});
  ASSERT_EQ(rows.size(), 3U);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].index, i);
}

TEST(CompareRows, HoldADefectForItsMachineAlone) {
  const auto rows = jobs::compare_rows(
      job_of({"a", "b", "c"}),
      {.figures = [](const machine::Definition& machine) -> Result<CompareFigures> {
        if (machine.name == "b") throw std::logic_error{"an index is off"};
        return CompareFigures{};
      }});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].name, "a");
  EXPECT_EQ(rows[1].name, "c");
  EXPECT_EQ(rows[2].figures.error().code, Code::defect);
  EXPECT_EQ(rows[2].figures.error().message, "an index is off");
}

TEST(CompareRows, HoldADefectOfTheReorientationApart) {
  const auto rows = jobs::compare_rows(
      job_of({"a"}),
      {.figures = [](const machine::Definition&) { return CompareFigures{}; },
       .reorientation = [](const machine::Definition&) -> Result<jobs::CompareReorientation> {
         throw std::out_of_range{"vector::at"};
       }});
  EXPECT_TRUE(rows.at(0).figures);
  ASSERT_TRUE(rows[0].reorientation);
  EXPECT_EQ(rows[0].reorientation->error().code, Code::defect);
}

/// What another setup cannot mend is not reoriented.
TEST(CompareRows, AreReorientedWhereASetupCanHelp) {
  const Sayings sayings{{"a", CompareFigures{}},
                        {"b", Problem{.code = Code::rotary_range, .message = "A"}},
                        {"c", Problem{.code = Code::bad_option, .message = "no"}},
                        {"d", Problem{.code = Code::out_of_reach, .message = "no"}},
                        {"e", Problem{.code = Code::defect, .message = "no"}}};
  Names asked;
  const auto rows = jobs::compare_rows(
      job_of({"a", "b", "c", "d", "e"}),
      {.figures = [&](const machine::Definition& machine) { return sayings.at(machine.name); },
       .reorientation =
           [&](const machine::Definition& machine) -> Result<jobs::CompareReorientation> {
         asked.push_back(machine.name);
         return jobs::CompareReorientation{};
       }});
  EXPECT_EQ(asked, (Names{"a", "b", "d"}));
  for (const auto& row : rows)
    EXPECT_EQ(row.reorientation.has_value(), row.name != "c" && row.name != "e") << row.name;
}

TEST(CompareRows, AreNotReorientedUnasked) {
  const auto rows = jobs::compare_rows(
      job_of({"a"}), {.figures = [](const machine::Definition&) { return CompareFigures{}; }});
  EXPECT_FALSE(rows.at(0).reorientation);
}

}  // namespace
}  // namespace pentapost
