// Facts about single machines that their sources print, against their definitions.

#include "machines/bundled.hpp"
#include "pentapost/core/units.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string_view>
#include <vector>

namespace pentapost {
namespace {

constexpr int trials = 1000;

/// A machine with the rotary letters that its model has found, nearest the workpiece first.
struct Subject {
  explicit Subject(std::string_view name)
      : definition{sample::bundled_machine(name)}, model{definition.chain} {}
  kinematics::Pose forward(const Vec3& linear_mm, double first_rad, double second_rad,
                           double gauge_length_mm = 0.0) const {
    return kinematics::forward(
        model, {.linear_mm = linear_mm, .first_rad = first_rad, .second_rad = second_rad},
        gauge_length_mm);
  }
  machine::Definition definition;
  kinematics::Model model;
};

/// Random joint values, the same in every run.
class Random {
 public:
  double angle_rad() { return angle_(engine_); }
  Vec3 point_mm() { return {length_(engine_), length_(engine_), length_(engine_)}; }

 private:
  std::mt19937_64 engine_{42};
  std::uniform_real_distribution<double> angle_{-pi, pi};
  std::uniform_real_distribution<double> length_{-400.0, 400.0};
};

// Cripps et al. 2017 eq. (1): the table turns the part right-handed by C about z, then by A about
// x.
TEST(HermleC600u, PlacesTheTipAsCrippsEquation1) {
  const Subject hermle{"hermle-c600u"};
  ASSERT_EQ(hermle.model.rotary_names[0], "C");
  Random random;
  for (int i = 0; i < trials; ++i) {
    const double a = random.angle_rad(), c = random.angle_rad();
    const Vec3 tip = random.point_mm();
    const double turned_y = std::sin(c) * tip.x() + std::cos(c) * tip.y();
    const Vec3 linear{std::cos(c) * tip.x() - std::sin(c) * tip.y(),
                      std::cos(a) * turned_y - std::sin(a) * tip.z(),
                      std::sin(a) * turned_y + std::cos(a) * tip.z()};

    const auto pose = hermle.forward(linear, c, a);

    ASSERT_LT((pose.tip_mm - tip).norm(), 1e-11);
    ASSERT_LT((pose.axis - Vec3{std::sin(a) * std::sin(c), std::sin(a) * std::cos(c), std::cos(a)})
                  .norm(),
              1e-14);
  }
}

// Appendices of the paper, blocks N80, as printed to 0.001 deg.
TEST(HermleC600u, ReachesTheAxesOfTheAppendicesAtTheirPrintedAngles) {
  const Subject hermle{"hermle-c600u"};
  struct Block {
    Vec3 axis;
    double a_deg, c_deg;
  };
  const std::vector<Block> blocks{
      {{0.1736481777, -0.1879101780, 0.9667140608}, 14.825, 137.259},
      {{-0.1736481777, 0.3529235351, 0.9193972421}, 23.162, 333.802 - 360.0}};
  for (const auto& block : blocks) {
    const auto found = kinematics::inverse_rotary(hermle.model, block.axis.normalized());
    ASSERT_EQ(found.count, 2);
    const auto& up = found.branch[found.branch[0].second_rad > 0.0 ? 0 : 1];

    EXPECT_NEAR(up.second_rad * deg_per_rad, block.a_deg, 5.1e-4);
    EXPECT_NEAR(wrapped_rad(up.first_rad) * deg_per_rad, block.c_deg, 5.1e-4);
  }
}

// NX postprocessor of the machine and its NC programs.
TEST(HaasUmc750, HasTheToolAxisOfItsPrograms) {
  const Subject haas{"haas-umc-750"};
  Random random;
  for (int i = 0; i < trials; ++i) {
    const double b = random.angle_rad(), c = random.angle_rad();
    const Vec3 axis{std::sin(b) * std::cos(c), std::sin(b) * std::sin(c), std::cos(b)};

    ASSERT_LT((kinematics::forward_axis(haas.model, c, b) - axis).norm(), 1e-14);
  }
}

// Eq. (5) of the paper on the DMU 50 eVolution: B = arccos(2 K - 1), K the z component.
TEST(Nutating45, ObeysBIsArccosOf2KMinus1) {
  for (const auto* name : {"dmu-50-evolution", "dmu-70-evo", "dmu-125p", "dmu-80p-duoblock"}) {
    SCOPED_TRACE(name);
    const Subject nutating{name};
    ASSERT_EQ(nutating.model.rotary_names[1], "B");
    for (int i = 1; i < 100; ++i) {
      const double k = i / 100.0, horizontal = std::sqrt(1.0 - k * k);
      const Vec3 axis{0.6 * horizontal, -0.8 * horizontal, k};

      const auto found = kinematics::inverse_rotary(nutating.model, axis);

      ASSERT_EQ(found.count, 2);
      for (const auto& branch : found.branch)
        ASSERT_NEAR(std::abs(branch.second_rad), std::acos(2.0 * k - 1.0), 1e-12);
    }
  }
}

TEST(Nutating45, LaysTheToolDownAt180) {
  EXPECT_NEAR(kinematics::forward_axis(Subject{"dmu-50-evolution"}.model, 0.7, pi).z(), 0.0, 1e-15);
  EXPECT_LT((kinematics::forward_axis(Subject{"dmu-125p"}.model, 0.0, pi) - Vec3::UnitY()).norm(),
            1e-15);
}

TEST(Nutating45, CannotReachBelowTheHorizon) {
  for (const auto* name : {"dmu-50-evolution", "dmu-70-evo", "dmu-125p", "dmu-80p-duoblock"}) {
    const Subject nutating{name};
    const Vec3 below{std::cos(-1e-6), 0.0, std::sin(-1e-6)};

    EXPECT_EQ(kinematics::inverse_rotary(nutating.model, below).count, 0) << name;
  }
}

// LinuxCNC's documentation of five-axis kinematics, xyzac-trt: the tool point Q in machine
// coordinates seen from the workpiece, with the offsets Dy = 20 and Dz = 10 of its settings.
TEST(LinuxcncXyzacTrt, PlacesTheTipAsItsModule) {
  const Subject trunnion{"linuxcnc-xyzac-trt"};
  const double dy = 20.0, dz = 10.0;
  Random random;
  for (int i = 0; i < trials; ++i) {
    const double a = random.angle_rad(), c = random.angle_rad();
    const Vec3 q = random.point_mm();
    const double sa = std::sin(a), ca = std::cos(a), sc = std::sin(c), cc = std::cos(c);
    const Vec3 tip{cc * q.x() + sc * ca * (q.y() - dy) + sc * sa * (q.z() - dz) + sc * dy,
                   -sc * q.x() + cc * ca * (q.y() - dy) + cc * sa * (q.z() - dz) + cc * dy,
                   -sa * (q.y() - dy) + ca * (q.z() - dz) + dz};

    ASSERT_LT((trunnion.forward(q, c, a).tip_mm - tip).norm(), 1e-11);
  }
}

// The same for xyzbc-trt with Dx = -20 and Dz = -15.
TEST(LinuxcncXyzbcTrt, PlacesTheTipAsItsModule) {
  const Subject trunnion{"linuxcnc-xyzbc-trt"};
  const double dx = -20.0, dz = -15.0;
  Random random;
  for (int i = 0; i < trials; ++i) {
    const double b = random.angle_rad(), c = random.angle_rad();
    const Vec3 q = random.point_mm();
    const double sb = std::sin(b), cb = std::cos(b), sc = std::sin(c), cc = std::cos(c);
    const Vec3 tip{cc * cb * (q.x() - dx) + sc * q.y() - cc * sb * (q.z() - dz) + cc * dx,
                   -sc * cb * (q.x() - dx) + cc * q.y() + sc * sb * (q.z() - dz) - sc * dx,
                   sb * (q.x() - dx) + cb * (q.z() - dz) + dz};

    ASSERT_LT((trunnion.forward(q, c, b).tip_mm - tip).norm(), 1e-11);
  }
}

// LinuxCNC's five-axis bridge mill: the tip hangs on a pivot of 250 mm, by spherical coordinates.
TEST(LinuxcncBridgemill, PlacesTheTipAsItsModule) {
  const Subject bridge{"linuxcnc-bridgemill"};
  const double pivot_mm = 250.0;
  Random random;
  for (int i = 0; i < trials; ++i) {
    const double b = random.angle_rad(), c = random.angle_rad();
    const Vec3 xyz = random.point_mm();
    const Vec3 tip{xyz.x() + pivot_mm * std::cos(c) * std::sin(b),
                   xyz.y() + pivot_mm * std::sin(c) * std::sin(b),
                   xyz.z() + pivot_mm - pivot_mm * std::cos(b)};

    ASSERT_LT((bridge.forward(xyz, c, b).tip_mm - tip).norm(), 1e-11);
  }
}

// ISO 841: a fork head that turns right-handed about +z and +y lays the tool along +y.
TEST(HuronKx100, LaysTheToolAlongY) {
  const Subject huron{"huron-kx100"};

  EXPECT_LT((kinematics::forward_axis(huron.model, pi / 2, pi / 2) - Vec3::UnitY()).norm(), 1e-15);
}

// The tip swings about the head axis 360 mm above the gauge line; a tool adds its gauge length.
TEST(HuronKx100, SwingsTheTipAboutItsHeadAxis) {
  const Subject huron{"huron-kx100"};

  const auto pose = huron.forward({0, 0, 0}, 0.0, pi / 2, 140.0);

  EXPECT_LT((pose.tip_mm - Vec3{-500, 0, 360}).norm(), 1e-10);
}

// At B = -90 deg the swivel head is horizontal, and the spindle points from -x towards the part.
TEST(Dmu80Monoblock, IsHorizontalAtMinus90) {
  const Subject dmu{"dmu-80-monoblock"};

  EXPECT_LT((kinematics::forward_axis(dmu.model, 0.0, -pi / 2) + Vec3::UnitX()).norm(), 1e-15);
}

// B turns about (100, *, 195): at B = -90 deg the gauge line lies 195 mm beside it and 100 below.
TEST(Dmu80Monoblock, SwingsTheTipAboutItsHeadAxis) {
  const Subject dmu{"dmu-80-monoblock"};

  const auto pose = dmu.forward({0, 0, 0}, 0.0, -pi / 2);

  EXPECT_LT((pose.tip_mm - Vec3{295, 0, 95}).norm(), 1e-10);
}

// The pole of a B table on an A trunnion is the Y axis, not Z.
TEST(PocketNcV2, IsFreeAlongY) {
  const Subject pocket{"pocket-nc-v2"};

  EXPECT_TRUE(kinematics::inverse_rotary(pocket.model, Vec3::UnitY()).first_is_free);
  EXPECT_FALSE(kinematics::inverse_rotary(pocket.model, Vec3::UnitZ()).first_is_free);
}

}  // namespace
}  // namespace pentapost
