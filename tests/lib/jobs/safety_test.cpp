#include "lib/jobs/job_case.hpp"

#include "pentapost/kinematics/forward.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace pentapost {
namespace {

/// Values of the words X Y Z A C of every block that states them all.
std::vector<std::array<double, 5>> full_blocks(const std::string& nc) {
  std::vector<std::array<double, 5>> found;
  for (const std::string& block : sample::motion_words(nc)) {
    std::array<double, 5> words{};
    std::size_t stated = 0;
    for (const char letter : std::string{"XYZAC"}) {
      const auto place = block.find(letter);
      if (place != std::string::npos)
        words[stated++] = std::strtod(block.c_str() + place + 1, nullptr);
    }
    if (stated == 5) found.push_back(words);
  }
  return found;
}

bool has(const Diagnostics& diagnostics, Code code) {
  const auto& list = diagnostics.list();
  return std::any_of(list.begin(), list.end(),
                     [code](const Diagnostic& diagnostic) { return diagnostic.code == code; });
}

/// Joint values run evenly in a rapid: in one block from A30 to A-30 the tip, 60 mm off the axis,
/// would dive by 60 (1 - cos 30 deg) = 8 mm.
TEST(Safety, ARapidThatTurnsKeepsTheTipOnItsLine) {
  jobs::PostJob job = sample::cl_job(
      "hermle-c600u", sample::cl_program("GOTO/0,0,60,0,0.5,0.8660254\nRAPID\n"
                                         "GOTO/0,0,60,0,-0.5,0.8660254\nGOTO/0,1,60\n"));
  job.post.output = Output::axes;
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;

  const kinematics::Model model{job.machine.chain};
  const auto blocks = full_blocks(posted->nc);
  ASSERT_GT(blocks.size(), 4U);
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    for (int step = 0; step <= 20; ++step) {
      const double share = step / 20.0;
      std::array<double, 5> at{};
      for (std::size_t k = 0; k < 5; ++k)
        at[k] = blocks[i - 1][k] + share * (blocks[i][k] - blocks[i - 1][k]);
      const auto pose = kinematics::forward(model,
                                            {.linear_mm = {at[0], at[1], at[2]},
                                             .first_rad = at[4] * rad_per_deg,
                                             .second_rad = at[3] * rad_per_deg},
                                            0.0);
      EXPECT_GT(pose.tip_mm.z(), 60.0 - 1.01) << "block " << i;
    }
  }
}

TEST(Safety, TheToolComesDownToTheFirstPointAlongItsAxis) {
  const auto posted = jobs::post(sample::cl_job(
      "hermle-c600u", sample::cl_program("RAPID\nGOTO/10,20,30,0,0.6,0.8\nGOTO/11,20,30\n")));
  ASSERT_TRUE(posted) << posted.error().message;

  const auto blocks = full_blocks(posted->nc);
  ASSERT_GE(blocks.size(), 2U);
  EXPECT_NEAR(blocks[0][0], 10.0, 1e-9);
  EXPECT_NEAR(blocks[0][1] - blocks[1][1], 100.0 * 0.6, 1e-9);
  EXPECT_NEAR(blocks[0][2] - blocks[1][2], 100.0 * 0.8, 1e-9);
  EXPECT_EQ(blocks[0][3], blocks[1][3]);
  EXPECT_EQ(blocks[0][4], blocks[1][4]);
}

/// Links between operations are left to the postprocessor: the table turns at the safe end.
TEST(Safety, ARapidIntoAnOperationWithAnotherToolAxisGoesByWayOfTheSafeEnd) {
  const auto posted = jobs::post(sample::cl_job(
      "haas-umc-750",
      "$$-> FEATNO / 1\nUNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nFEDRAT/500,MMPM\nRAPID\n"
      "GOTO/0,0,50,0,0,1\nGOTO/0,0,40,0,0,1\n$$-> FEATNO / 2\nRAPID\nGOTO/60,0,50,0.6,0,0.8\n"
      "GOTO/60,0,40,0.6,0,0.8\nFINI\n"));
  ASSERT_TRUE(posted) << posted.error().message;

  const std::string& nc = posted->nc;
  const auto cut = nc.find("Z40."), second = nc.find("FEATNO 2");
  ASSERT_NE(cut, std::string::npos);
  ASSERT_NE(second, std::string::npos);
  const auto retract = nc.find("G28", cut);
  const auto tcp_on = nc.find("G43.4", retract);
  EXPECT_LT(retract, second);
  EXPECT_NE(tcp_on, std::string::npos);
  EXPECT_LT(tcp_on, nc.find("X60."));
  EXPECT_TRUE(posted->retracts.empty());
}

TEST(Safety, AnotherLengthRegisterOfTheSameToolIsCalled) {
  jobs::PostJob job = sample::cl_job(
      "haas-umc-750",
      "UNITS/MM\nLOADTL/5,ADJUST,15\nSPINDL/3000,CLW\nFEDRAT/500,MMPM\nRAPID\nGOTO/0,0,50\n"
      "GOTO/0,0,0\nRAPID\nGOTO/0,0,50\nLOADTL/5,ADJUST,25\nRAPID\nGOTO/9,0,50\nGOTO/9,0,0\nFINI\n");
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_NE(posted->nc.find("H15"), std::string::npos);
  EXPECT_NE(posted->nc.find("H25"), std::string::npos);
}

TEST(Safety, CuttingWithTheSpindleOffIsSaid) {
  const std::string cut = "RAPID\nGOTO/0,0,50\nGOTO/0,0,0\nFINI\n";
  const auto still =
      jobs::post(sample::cl_job("generic-3axis", "UNITS/MM\nFEDRAT/500,MMPM\n" + cut));
  const auto turning = jobs::post(
      sample::cl_job("generic-3axis", "UNITS/MM\nSPINDL/900,CLW\nFEDRAT/500,MMPM\n" + cut));
  ASSERT_TRUE(still) << still.error().message;
  ASSERT_TRUE(turning) << turning.error().message;

  EXPECT_TRUE(has(still->diagnostics, Code::spindle_off));
  EXPECT_FALSE(has(turning->diagnostics, Code::spindle_off));
  const std::string note = "WARNING: THE SPINDLE IS OFF";
  EXPECT_NE(still->nc.find(note), std::string::npos);
  EXPECT_EQ(turning->nc.find(note), std::string::npos);
}

}  // namespace
}  // namespace pentapost
