#pragma once

#include "machines/bundled.hpp"
#include "sample/chains.hpp"

#include "pentapost/jobs/post.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

/// Random jobs that look for trouble: paths over the whole sphere, through and beside the poles,
/// along the edges of reach and range, with all that a CL file holds between the points.
namespace pentapost::sample {

class RandomJob {
 public:
  RandomJob(std::uint64_t seed, const std::vector<BundledMachine>& machines)
      : random_{seed}, job_{.machine = machines.front().definition, .path = jobs::ClText{}} {
    choose_machine(machines);
    const kinematics::Model model{job_.machine.chain};
    choose_settings();
    write_path(model);
    // Last, so that the paths of the seeds stay what they are.
    if (!job_.post.flank && chance(0.4))
      job_.post.pole_axis_deg = one_of(std::array<double, 5>{0.02, 0.2, 1.0, 3.0, 5.0});
    job_.path = jobs::ClText{.text = text_, .dialect = "creo-ncl"};
  }
  jobs::PostJob job() const { return job_; }
  const std::string& cl_text() const { return text_; }

 private:
  double real(double lower, double upper) {
    return std::uniform_real_distribution<double>{lower, upper}(random_);
  }
  int whole(int lower, int upper) {
    return std::uniform_int_distribution<int>{lower, upper}(random_);
  }
  bool chance(double share) { return real(0.0, 1.0) < share; }
  template <class T, std::size_t n>
  T one_of(const std::array<T, n>& values) {
    return values[static_cast<std::size_t>(whole(0, static_cast<int>(n) - 1))];
  }

  void choose_machine(const std::vector<BundledMachine>& machines) {
    const auto last = static_cast<int>(machines.size()) - 1;
    job_.machine = machines[static_cast<std::size_t>(whole(0, last))].definition;
    if (chance(0.15)) job_.machine.chain = random_chain(random_, chance(0.9) ? 2 : 1, whole(0, 3));
    if (chance(0.5)) narrow_ranges();
  }

  /// Awkward ranges: exactly one turn, a little more, one-sided, without zero.
  void narrow_ranges() {
    constexpr std::array<Range<double>, 9> first_deg{{{-180, 180},
                                                      {0, 360},
                                                      {-190, 190},
                                                      {-400, 400},
                                                      {-360, 360},
                                                      {30, 350},
                                                      {-30, 60},
                                                      {-720, 0},
                                                      {-1080, 1080}}};
    constexpr std::array<Range<double>, 8> second_deg{
        {{-5, 110}, {0, 102}, {-110, 5}, {-180, 180}, {20, 90}, {-95, 95}, {0, 180}, {-100, 400}}};
    const kinematics::Model model{job_.machine.chain};
    const auto narrowed = [&](std::span<const machine::Joint> joints) {
      std::vector<machine::Joint> changed{joints.begin(), joints.end()};
      for (machine::Joint& joint : changed) {
        auto* rotary = std::get_if<machine::RotaryJoint>(&joint.kind);
        if (rotary == nullptr || chance(0.25)) continue;
        const bool is_first = joint.name == model.rotary_names[0];
        const Range<double> range = is_first ? one_of(first_deg) : one_of(second_deg);
        rotary->range = Range<Angle>{Angle::degrees(range.lower), Angle::degrees(range.upper)};
      }
      return changed;
    };
    const machine::Chain& chain = job_.machine.chain;
    job_.machine.chain =
        machine::Chain::make(narrowed(chain.table()), narrowed(chain.head()), chain.tool_axis())
            .value();
  }

  void choose_settings() {
    constexpr std::array<double, 5> tip_mm{0.1, 0.05, 0.01, 0.002, 0.01};
    constexpr std::array<double, 5> axis_deg{0.5, 0.1, 0.05, 0.02, 0.01};
    job_.tolerances = {one_of(tip_mm), one_of(axis_deg)};
    job_.post.output = chance(0.5) ? Output::tcp : Output::axes;
    const bool iso = chance(0.5);
    if ((job_.machine.controller.dialect == "heidenhain-iso") != iso)
      job_.machine.controller = {iso ? "heidenhain-iso" : "fanuc-30i", Output::tcp, {}};
    if (chance(0.2)) {
      job_.machine.controller.options["decimals_mm"] = static_cast<double>(whole(3, 5));
      job_.machine.controller.options["decimals_deg"] = static_cast<double>(whole(2, 6));
    }
    if (chance(0.2)) job_.post.prefer = machine::Preferences{};
    if (chance(0.3)) {
      using Tilt = machine::Preferences::Tilt;
      const double lower_deg = real(-400.0, 200.0);
      job_.post.prefer = machine::Preferences{
          .tilt = chance(0.5) ? Tilt::positive : Tilt::negative,
          .first_turn = Range<Angle>{Angle::degrees(lower_deg), Angle::degrees(lower_deg + 360.0)}};
    }
    if (chance(0.8)) job_.gauge_length_mm = {{1, real(0.0, 200.0)}, {2, real(0.0, 200.0)}};
    if (chance(0.5)) job_.setup.origin_mm = Vec3{real(-50, 50), real(-50, 50), real(0, 250)};
    if (chance(0.3)) {
      job_.setup.theta_x_deg = real(-90.0, 90.0);
      job_.setup.theta_z_deg = real(-180.0, 180.0);
    }
    job_.post.flank = chance(0.1);
    if (chance(0.9))
      for (const char* name : {"A", "B", "C"}) {
        const kinematics::Model model{job_.machine.chain};
        if (name == model.rotary_names[0] || name == model.rotary_names[1])
          job_.limits[name].max_speed = real(0.2, 3.0);
      }
  }

  Vec3 axis_at_joints(const kinematics::Model& model, double first_rad, double second_rad) {
    return kinematics::forward_axis(model, first_rad, second_rad);
  }

  void add_goto(const Vec3& tip_mm, const Vec3& axis) {
    char line[256];
    std::snprintf(line, sizeof line, "GOTO / %.*f, %.*f, %.*f, $\n %.*f, %.*f, %.*f\n", tip_digits_,
                  tip_mm.x(), tip_digits_, tip_mm.y(), tip_digits_, tip_mm.z(), axis_digits_,
                  axis.x(), axis_digits_, axis.y(), axis_digits_, axis.z());
    text_ += line;
    tip_mm_ = tip_mm;
  }

  void write_path(const kinematics::Model& model) {
    tip_digits_ = whole(3, 6);
    axis_digits_ = one_of(std::array<int, 4>{5, 7, 9, 14});
    text_ = "$$-> MFGNO / RANDOM\nPARTNO / RANDOM\nUNITS / MM\nLOADTL / 1\n";
    text_ += "SPINDL / RPM, 8000, CLW\n";
    if (chance(0.98)) text_ += "FEDRAT / " + std::to_string(whole(50, 4000)) + ", MMPM\n";
    if (chance(0.3)) text_ += "RAPID\n";
    tip_mm_ = {real(-100, 100), real(-100, 100), real(-50, 50)};
    const int stretches = whole(1, 3);
    first_rad_ = real(-pi, pi);
    second_rad_ = real(-pi, pi);
    axis_ = turned_home(axis_at_joints(model, first_rad_, second_rad_));
    for (int i = 0; i < stretches; ++i) {
      switch (whole(0, 8)) {
        case 0:
          walk_on_sphere();
          break;
        case 1:
          pass_pole(model);
          break;
        case 2:
          follow_edge(model);
          break;
        case 3:
          wind(model);
          break;
        case 4:
          jump(model);
          break;
        case 5:
          walk_in_joints(model);
          break;
        case 6:
          work_in_plane();
          break;
        case 7:
          rest_at_pole(model);
          break;
        case 8:
          drill_holes();
          break;
      }
      between();
    }
    add_goto(tip_mm_ + Vec3{1, 2, 3}, axis_);
    text_ += "FINI\n";
  }

  /// From the orientation on the table back to the CL data's.
  Vec3 turned_home(const Vec3& axis) const {
    const double x_rad = job_.setup.theta_x_deg * rad_per_deg;
    const double z_rad = job_.setup.theta_z_deg * rad_per_deg;
    return Eigen::AngleAxisd{z_rad, Vec3::UnitZ()} *
           (Eigen::AngleAxisd{x_rad, Vec3::UnitX()} * axis);
  }

  Vec3 next_tip() {
    if (chance(0.05)) return tip_mm_;
    const double size = std::pow(10.0, real(-3.0, 1.3));
    return tip_mm_ + size * random_axis(random_);
  }

  void step_to(const Vec3& axis) {
    if (chance(0.04)) text_ += "RAPID\n";
    axis_ = axis.normalized();
    add_goto(next_tip(), axis_);
    if (chance(0.05)) add_goto(tip_mm_, axis_);
    if (chance(0.01)) between();
  }

  void between() {
    switch (whole(0, 12)) {
      case 0:
        text_ += "LOADTL / " + std::to_string(whole(1, 2)) + "\n";
        break;
      case 1:
        text_ += "GOHOME\n";
        break;
      case 2:
        text_ += "DELAY / 1.5\n";
        break;
      case 3:
        text_ += "COOLNT / ON\n";
        break;
      case 4:
        text_ += "SPINDL / OFF\n";
        break;
      case 5:
        text_ += "SPINDL / RPM, 6000, CLW\n";
        break;
      case 6:
        text_ += "RAPID\n";
        break;
      case 7:
        text_ += "FEDRAT / 333.3, MMPM\n";
        break;
      case 8:
        text_ += "STOP\n";
        break;
      default:
        break;
    }
  }

  void walk_on_sphere() {
    const double step_rad = rad_per_deg * std::pow(10.0, real(-1.0, 1.3));
    Vec3 heading = random_axis(random_);
    const int count = whole(3, 60);
    for (int i = 0; i < count; ++i) {
      heading = (heading + 0.3 * random_axis(random_)).normalized();
      const Vec3 turn = axis_.cross(heading);
      if (turn.norm() < 1e-6) continue;
      step_to(Eigen::AngleAxisd{step_rad, turn.normalized()} * axis_);
    }
  }

  Vec3 pole(const kinematics::Model& model) {
    return turned_home(chance(0.7) == (model.a.dot(Vec3::UnitZ()) >= 0.0) ? model.a
                                                                          : Vec3{-model.a});
  }

  void pass_pole(const kinematics::Model& model) {
    const Vec3 centre = pole(model);
    const Vec3 along = random_axis_at(random_, centre, pi / 2.0);
    const Vec3 across = centre.cross(along);
    const double miss_rad =
        one_of(std::array<double, 7>{0.0, 1e-10, 1e-7, 1e-5, 2e-4, 2e-3, 0.05}) * real(0.5, 1.5);
    const double step_rad = rad_per_deg * std::pow(10.0, real(-1.5, 1.4));
    const int count = whole(1, 12);
    const double shift = chance(0.3) ? 0.0 : chance(0.5) ? 0.5 : real(0.0, 1.0);
    for (int i = -count; i <= count; ++i)
      step_to(centre + std::tan(std::clamp((i + shift) * step_rad, -1.5, 1.5)) * along +
              std::tan(miss_rad) * across);
  }

  void rest_at_pole(const kinematics::Model& model) {
    const Vec3 centre = pole(model);
    step_to(centre + 0.1 * random_axis(random_));
    const double noise = one_of(std::array<double, 4>{0.0, 1e-9, 1e-7, 1e-4});
    const int count = whole(1, 6);
    for (int i = 0; i < count; ++i) step_to(centre + noise * random_axis(random_));
    step_to(centre + 0.1 * random_axis(random_));
  }

  void follow_edge(const kinematics::Model& model) {
    const bool outer = chance(0.5);
    const double edge_rad =
        outer ? model.lambda_rad + model.mu_rad : std::abs(model.lambda_rad - model.mu_rad);
    const double inside_rad =
        one_of(std::array<double, 6>{0.0, 1e-9, 1e-6, 1e-4, 1e-2, 0.1}) * (outer ? -1.0 : 1.0);
    const Vec3 centre = turned_home(model.a_flipped ? Vec3{-model.a} : model.a);
    const Vec3 along = random_axis_at(random_, centre, pi / 2.0);
    const double step_rad = rad_per_deg * std::pow(10.0, real(-1.0, 1.3));
    const int count = whole(2, 20);
    for (int i = 0; i < count; ++i) {
      const Vec3 beside = Eigen::AngleAxisd{i * step_rad, centre} * along;
      const double gamma_rad = edge_rad + inside_rad * (chance(0.5) ? 1.0 : real(0.0, 3.0));
      step_to(std::cos(gamma_rad) * centre + std::sin(gamma_rad) * beside);
    }
  }

  void wind(const kinematics::Model& model) {
    const Vec3 centre = pole(model);
    const Vec3 start = random_axis_at(random_, centre, real(0.02, 1.2));
    const double step_rad = rad_per_deg * real(2.0, 60.0) * (chance(0.5) ? 1.0 : -1.0);
    const int count = whole(10, 80);
    for (int i = 0; i < count; ++i) step_to(Eigen::AngleAxisd{i * step_rad, centre} * start);
  }

  void jump(const kinematics::Model& model) {
    const int count = whole(1, 6);
    for (int i = 0; i < count; ++i) {
      const Vec3 next = chance(0.5)
                            ? random_axis(random_)
                            : turned_home(axis_at_joints(model, real(-pi, pi), real(-pi, pi)));
      step_to(next);
    }
  }

  void walk_in_joints(const kinematics::Model& model) {
    const double first_step = real(-0.2, 0.2), second_step = real(-0.1, 0.1);
    const int count = whole(5, 80);
    for (int i = 0; i < count; ++i) {
      first_rad_ += first_step;
      second_rad_ += second_step;
      step_to(turned_home(axis_at_joints(model, first_rad_, second_rad_)));
    }
  }

  /// Lines and arcs with a fixed tool axis, in the plane across it.
  void work_in_plane() {
    const Vec3 along = random_axis_at(random_, axis_, pi / 2.0);
    const Vec3 across = axis_.cross(along);
    add_goto(next_tip(), axis_);
    const int count = whole(1, 6);
    for (int i = 0; i < count; ++i) {
      if (chance(0.3)) add_goto(next_tip(), axis_);
      const double radius_mm = std::pow(10.0, real(-2.0, 2.0));
      const double sense = chance(0.5) ? 1.0 : -1.0;
      const double angle_rad = chance(0.2) ? 2.0 * pi : real(0.01, 2.0 * pi);
      const Vec3 centre = tip_mm_ - radius_mm * along;
      Vec3 end =
          centre + radius_mm * (std::cos(angle_rad) * along + sense * std::sin(angle_rad) * across);
      if (chance(0.2)) end += real(-3.0, 3.0) * axis_;
      if (chance(0.2)) end += 5e-4 * random_axis(random_);
      const Vec3 normal = sense * axis_;
      char line[256];
      std::snprintf(line, sizeof line, "CIRCLE / %.6f, %.6f, %.6f, $\n %.9f, %.9f, %.9f, %.6f\n",
                    centre.x(), centre.y(), centre.z(), normal.x(), normal.y(), normal.z(),
                    radius_mm);
      text_ += line;
      Vec3 end_axis = axis_;
      if (chance(0.1)) end_axis = (axis_ + 0.1 * random_axis(random_)).normalized();
      add_goto(end, end_axis);
      axis_ = end_axis;
      if (chance(0.1)) return;
    }
  }

  void drill_holes() {
    add_goto(next_tip(), axis_);
    const std::string kind = one_of(std::array<const char*, 3>{"DRILL", "DEEP", "BORE"});
    text_ += "CYCLE / " + kind + ", DEPTH, 8.0, " + (kind == "DEEP" ? "STEP, 2.0, " : "") +
             "MMPM, 150.0, CLEAR, 2.0\n";
    const int count = whole(1, 4);
    for (int i = 0; i < count; ++i) {
      if (chance(0.3)) axis_ = (axis_ + 0.2 * random_axis(random_)).normalized();
      const Vec3 beside = axis_.cross(random_axis(random_));
      add_goto(tip_mm_ + 10.0 * beside, axis_);
    }
    text_ += "CYCLE / OFF\n";
  }

  std::mt19937_64 random_;
  jobs::PostJob job_;
  std::string text_;
  int tip_digits_ = 4, axis_digits_ = 7;
  Vec3 tip_mm_ = Vec3::Zero(), axis_ = Vec3::UnitZ();
  double first_rad_ = 0.0, second_rad_ = 0.0;
};

}  // namespace pentapost::sample
