// Names and text that a definition or a job puts into the program, and feeds beyond the control's.

#include "lib/jobs/job_case.hpp"
#include "pentapost/jobs/unproven.hpp"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pentapost {
namespace {

using Lines = std::vector<std::string>;

/// Coolant, a tilt with TCP and a move back.
const std::string tilting_path =
    "COOLNT/FLOOD\nGOTO/0,0,50,0,0,1\nGOTO/10,0,50,0,0,1\nGOTO/20,0,50,0,0.6,0.8\n";

Result<jobs::PostReport> post_with(const std::string& machine, const machine::Options& options,
                                   const std::string& path = tilting_path) {
  auto job = sample::cl_job(machine, sample::cl_program(path));
  job.machine.controller.options = options;
  return jobs::post(job);
}

void expect_refused(const Result<jobs::PostReport>& posted, Code code, const std::string& pointer,
                    const std::string& found) {
  ASSERT_FALSE(posted);
  EXPECT_EQ(row_of(posted.error().code).name, row_of(code).name) << posted.error().message;
  EXPECT_EQ(posted.error().pointer, pointer);
  EXPECT_NE(posted.error().message.find(found), std::string::npos) << posted.error().message;
}

TEST(OptionText, ThatCannotBeProvenIsTheCallers) {
  for (const std::string machine : {"hermle-c600u", "huron-kx100"}) {
    SCOPED_TRACE(machine);
    const std::string options = "/machine/controller/options";
    for (const std::string line : {"G91", "G90 G20 G17", "G91 G0 Z-100"})
      expect_refused(post_with(machine, {{"start_lines", Lines{line}}}), Code::not_in_dialect,
                     options + "/start_lines", "start_lines");
    expect_refused(post_with(machine, {{"tcp_on", Lines{"M8"}}}), Code::not_in_dialect,
                   options + "/tcp_on", "TCP");
    expect_refused(post_with(machine, {{"coolant_flood", std::string{"M8 G91"}}}),
                   Code::not_in_dialect, options + "/coolant_flood", "G91");
  }
}

/// The dialect has no code of its own for it, which is not what keeps the program from its proof.
TEST(OptionText, OfACoolantWithoutADefaultIsTheCallersToo) {
  expect_refused(post_with("hermle-c600u", {{"coolant_through", std::string{"G91"}}},
                           "COOLNT/THRU\nGOTO/0,0,50,0,0,1\nGOTO/20,0,50,0,0.6,0.8\n"),
                 Code::not_in_dialect, "/machine/controller/options/coolant_through", "G91");
}

TEST(OptionText, OfSeveralOptionsIsRefusedAtAllOfThem) {
  expect_refused(post_with("hermle-c600u",
                           {{"start_lines", Lines{"G90", "G17"}}, {"smoothing_on", Lines{"G91"}}}),
                 Code::not_in_dialect, "/machine/controller/options", "start_lines, smoothing_on");
}

TEST(OptionText, ThatChangesNoMotionIsProven) {
  const auto posted = post_with("hermle-c600u", {{"start_lines", Lines{"G90", "G17"}},
                                                 {"tcp_on", Lines{"M128"}},
                                                 {"coolant_flood", std::string{"M88"}}});
  ASSERT_TRUE(posted) << posted.error().message;
  EXPECT_NE(posted->nc.find("M88"), std::string::npos);
}

TEST(OptionText, HasThePlaceholdersOfItsOptionOnly) {
  for (const auto& [name, line, unknown] :
       std::vector<std::array<std::string, 3>>{{"tcp_on", "G43.4 H{foo}", "{foo}"},
                                               {"tool_change", "T{tool} H{register}", "{register}"},
                                               {"start_lines", "G90 {tool}", "{tool}"},
                                               {"safe_retract", "{}", "{}"}})
    for (const std::string machine : {"hermle-c600u", "huron-kx100"}) {
      SCOPED_TRACE(machine + ": " + name + " " + line);
      expect_refused(post_with(machine, {{name, Lines{line}}}), Code::bad_option,
                     "/machine/controller/options/" + name, unknown);
    }
}

TEST(OptionText, IsCheckedWithoutAJob) {
  auto definition = sample::bundled_machine("huron-kx100");
  EXPECT_TRUE(jobs::check_options(definition));
  definition.controller.options = {{"tcp_on", Lines{"G43.4 H{foo}"}}};
  const auto status = jobs::check_options(definition);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, Code::bad_option);
  EXPECT_EQ(status.error().pointer, "/controller/options/tcp_on");
}

/// What no trial with other text mends is the service's own fault.
TEST(Unproven, IsADefectWhereTheDialectsOwnTextFailsToo) {
  const auto& dialect = *nc::find_dialect("fanuc-30i");
  const Problem failed{.code = Code::proof_failed, .message = "off"};
  const machine::Options changed{{"start_lines", Lines{"G90"}}};
  const auto never = [](const machine::Options&) { return false; };
  const auto always = [](const machine::Options&) { return true; };

  EXPECT_EQ(jobs::unproven(failed, dialect, changed, {}, never).code, Code::proof_failed);
  EXPECT_EQ(jobs::unproven(failed, dialect, {}, {}, always).code, Code::proof_failed);
  EXPECT_EQ(jobs::unproven(failed, dialect, {{"decimals_mm", 2.0}}, {}, always).code,
            Code::proof_failed);
  EXPECT_EQ(jobs::unproven(failed, dialect, changed, {}, always).code, Code::not_in_dialect);
}

TEST(Feed, IsHeldToWhatTheControlTakes) {
  for (const auto output : {Output::tcp, Output::axes}) {
    auto job = sample::cl_job(
        "hermle-c600u",
        "UNITS/MM\nLOADTL/1\nSPINDL/RPM,8000,CLW\nFEDRAT/100000,MMPM\n" + tilting_path + "FINI\n");
    job.post.output = output;
    const auto posted = jobs::post(job);
    ASSERT_TRUE(posted) << posted.error().message;
    EXPECT_NE(posted->nc.find(" F99999.999 "), std::string::npos);
  }
}

TEST(Feed, OfOptionsIsHeldToItToo) {
  const auto posted =
      post_with("hermle-c600u", {{"rapid_as_line", true}, {"rapid_feed_mm_min", 1e6}},
                "RAPID\nGOTO/0,0,60,0,0,1\n" + tilting_path);
  ASSERT_TRUE(posted) << posted.error().message;
  EXPECT_NE(posted->nc.find(" F99999.999 "), std::string::npos);
}

TEST(CoolantRefusal, SaysWhereTheOptionStands) {
  expect_refused(
      post_with("hermle-c600u", {}, "COOLNT/THRU\nGOTO/0,0,50,0,0,1\nGOTO/9,0,50,0,0,1\n"),
      Code::not_in_dialect, "", "coolant_through in controller.options of its definition");
}

TEST(ProgramName, IsTheGivenOneThenPartnoThenTheDefault) {
  const auto name_of = [](const std::string& partno, std::optional<std::string> given) {
    auto job = sample::cl_job("hermle-c600u", partno + sample::cl_program(tilting_path));
    job.post.program_name = std::move(given);
    job.post.default_program_name = "FLANGE";
    const auto posted = jobs::post(job);
    return posted ? posted->nc.substr(0, posted->nc.find(' ')) : posted.error().message;
  };
  EXPECT_EQ(name_of("PARTNO/PART\n", "GIVEN"), "%GIVEN");
  EXPECT_EQ(name_of("PARTNO/PART\n", std::nullopt), "%PART");
  EXPECT_EQ(name_of("", std::nullopt), "%FLANGE");
  EXPECT_EQ(name_of("", "GIVEN"), "%GIVEN");
}

}  // namespace
}  // namespace pentapost
