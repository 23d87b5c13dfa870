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

/// Two holes of one cycle, the second on a boss 30 mm high.
std::string boss_cl() {
  return "UNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nFEDRAT/500,MMPM\nRAPID\nGOTO/0,0,50,0,0,1\n"
         "CYCLE/DRILL,DEPTH,10,CLEAR,3\nGOTO/0,0,0\nGOTO/20,0,30\nCYCLE/OFF\nFINI\n";
}

TEST(Safety, TheToolRisesInFrontOfABossBeforeTheNextCycle) {
  jobs::PostJob job = sample::cl_job("haas-umc-750", boss_cl());
  job.post.output = Output::axes;
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_NE(posted->nc.find("G99 G81 X0. Y0. Z-10. R3."), std::string::npos) << posted->nc;
  EXPECT_NE(posted->nc.find("G80\nG0 Z33.\nG99 G81 X20. Y0. Z20. B0. C0. R33."), std::string::npos)
      << posted->nc;
}

/// Holes along Z and along Y: on the straight way between them the tool would go through the
/// corner.
TEST(Safety, HolesInSingleMovesTurnTheToolAtTheSafeEnd) {
  const auto posted = jobs::post(sample::cl_job(
      "hermle-c600u",
      "UNITS/MM\nLOADTL/1\nSPINDL/3000,CLW\nFEDRAT/500,MMPM\nRAPID\nGOTO/0,0,50,0,0,1\n"
      "CYCLE/DRILL,DEPTH,10,CLEAR,3\nGOTO/0,0,20,0,0,1\nGOTO/0,20,0,0,1,0\nCYCLE/OFF\nFINI\n"));
  ASSERT_TRUE(posted) << posted.error().message;

  const std::string& nc = posted->nc;
  const auto hole = nc.find("Z+10 "), turn = nc.find("A+90");
  ASSERT_NE(hole, std::string::npos) << nc;
  ASSERT_NE(turn, std::string::npos) << nc;
  EXPECT_LT(nc.find("M140 MB MAX", hole), turn) << nc;
  EXPECT_LT(nc.find("Y+123 ", turn), nc.find("Y+23 ", turn)) << nc;
}

/// 480 rpm and a pitch of 1.25 mm.
TEST(Safety, TapsAreRigidAndFedByTheirPitch) {
  jobs::PostJob job = sample::cl_job(
      "mazak-variaxis-630",
      "UNITS/MM\nLOADTL/1\nSPINDL/RPM,480,CLW\nFEDRAT/500,MMPM\nRAPID\nGOTO/0,0,50,0,0,1\n"
      "CYCLE/TAP,DEPTH,10,CLEAR,3,PITCH,1.25\nGOTO/0,0,0\nGOTO/20,0,0\nCYCLE/OFF\nFINI\n");
  job.post.output = Output::axes;
  const auto posted = jobs::post(job);
  ASSERT_TRUE(posted) << posted.error().message;

  EXPECT_NE(posted->nc.find("M29 S480\nG99 G84 X0. Y0. Z-10. R3. F600.\nX20. Y0.\nG80"),
            std::string::npos)
      << posted->nc;
}

TEST(Safety, TheToolRisesInFrontOfABossInSingleMoves) {
  const auto posted = jobs::post(sample::cl_job("hermle-c600u", boss_cl()));
  ASSERT_TRUE(posted) << posted.error().message;

  const auto blocks = full_blocks(posted->nc);
  const auto at = [&](double x, double z) {
    return std::find_if(blocks.begin(), blocks.end(), [=](const std::array<double, 5>& block) {
      return block[0] == x && block[2] == z;
    });
  };
  ASSERT_NE(at(0, 33), blocks.end()) << posted->nc;
  EXPECT_EQ(at(20, 33), at(0, 33) + 1) << posted->nc;
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
