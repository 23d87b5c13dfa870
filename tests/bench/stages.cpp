#include "stages.hpp"

#include "pentapost/analysis/cl_analysis.hpp"
#include "pentapost/cl/reader.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/nc/dialect.hpp"
#include "pentapost/nc/reader.hpp"
#include "pentapost/plan/plain_choice.hpp"
#include "pentapost/plan/program.hpp"
#include "pentapost/plan/sequences.hpp"
#include "pentapost/verify/proof.hpp"

#include <stdexcept>
#include <utility>

namespace pentapost::bench {
namespace {

constexpr double gauge_length_mm = 120.0;

machine::Joint linear(const char* name, const Vec3& direction) {
  return {name, machine::LinearJoint{UnitVector::normalised(direction), {}}};
}

machine::Joint rotary(const char* name, const Vec3& direction,
                      std::optional<Range<Angle>> range = {}) {
  return {name, machine::RotaryJoint{UnitVector::normalised(direction), Vec3::Zero(), range}};
}

template <class T>
T taken(Result<T> result) {
  if (!result) throw std::logic_error{result.error().message};
  return std::move(result).value();
}

path::ToolPath read_path(const std::string& cl) {
  cl::ReadResult result = cl::read(cl);
  if (result.diagnostics.has_errors()) throw std::logic_error{"the bench's CL text is damaged"};
  return std::move(result.path);
}

plan::Settings settings_of(const machine::Definition& machine, const Target& target) {
  const nc::Abilities can = taken(nc::find_dialect(target.dialect)->abilities({}));
  plan::Settings settings;
  settings.output = target.output;
  settings.gauge_length_mm = {{1, gauge_length_mm}};
  settings.preferences = machine.preferences;
  settings.limits = machine.limits;
  settings.decimals_mm = can.decimals_mm;
  settings.decimals_deg = can.decimals_deg;
  settings.feed_decimals = can.feed_decimals;
  settings.inverse_time = can.inverse_time;
  settings.largest_inverse_time = can.largest_inverse_time;
  settings.adds_length_always = can.adds_length_always;
  settings.retracts_with_tcp = can.retracts_with_tcp;
  settings.retract_needs_tool = can.retract_needs_tool;
  settings.arcs = can.arcs;
  settings.arcs_with_tcp = can.arcs_with_tcp;
  return settings;
}

}  // namespace

std::string name_of(const Target& target) {
  return std::string{target.dialect} + (target.output == Output::tcp ? "/tcp" : "/axes");
}

machine::Definition bench_machine() {
  auto chain = machine::Chain::make(
      {rotary("C", Vec3::UnitZ()),
       rotary("A", Vec3::UnitX(), Range<Angle>{Angle::degrees(-110.0), Angle::degrees(110.0)})},
      {linear("Y", Vec3::UnitY()), linear("X", Vec3::UnitX()), linear("Z", Vec3::UnitZ())},
      UnitVector::normalised(Vec3::UnitZ()));
  const machine::AxisLimits rotary_limits{.max_speed = Angle::degrees(150.0).rad()};
  return {.name = "bench-ac-table",
          .version = "1.0.0",
          .title = "A/C swivel rotary table",
          .sources = {"Cripps et al. 2017"},
          .chain = std::move(chain).value(),
          .limits = {{"A", rotary_limits}, {"C", rotary_limits}},
          .preferences = {.tilt = machine::Preferences::Tilt::positive,
                          .first_turn = Range<Angle>{Angle::degrees(0.0), Angle::degrees(360.0)}},
          .controller = {.dialect = "heidenhain-iso", .output = Output::tcp},
          .sha256 = std::string(64, '0')};
}

jobs::PostJob bench_job(std::string cl, const Target& target) {
  return {.machine = bench_machine(),
          .path = jobs::ClText{.text = std::move(cl)},
          .gauge_length_mm = {{1, gauge_length_mm}},
          .post = {.output = target.output, .dialect = std::string{target.dialect}}};
}

Stages::Stages(const std::string& cl, const Target& target)
    : target_{target},
      machine_{bench_machine()},
      model_{machine_.chain},
      path_{read_path(cl)},
      settings_{settings_of(machine_, target)},
      joint_ranges_{plan::joint_ranges(machine_.chain, model_)},
      range_{plan::sequences(path_).front().range},
      zone_{plan::pole_zone(model_, path_.axis_rounding_rad,
                            plan::axis_freedom_rad(settings_.axis_tolerance_rad, false))} {}

std::size_t Stages::invert() const {
  std::size_t solutions = 0;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const auto rotaries = kinematics::inverse_rotary(model_, path_.axis_wp[i]);
    const auto& first = rotaries.branch[0];
    const auto linear_mm = kinematics::inverse_linear(model_, path_.tip_wp_mm[i], first.first_rad,
                                                      first.second_rad, gauge_length_mm);
    if (linear_mm) solutions += static_cast<std::size_t>(rotaries.count);
  }
  return solutions;
}

std::size_t Stages::choose() const {
  const auto chosen = plan::plain_choice(model_, joint_ranges_, path_, range_, zone_, settings_,
                                         gauge_length_mm, false);
  return chosen ? chosen->arrival.size() : search_branches();
}

std::size_t Stages::search_branches() const {
  const auto candidates =
      taken(plan::find_candidates(model_, path_, range_, zone_, path_.axis_rounding_rad));
  const auto chosen = taken(plan::choose_branches(model_, joint_ranges_, path_, candidates,
                                                  settings_, gauge_length_mm, false));
  return chosen.arrival.size();
}

std::size_t Stages::plan() const {
  return taken(plan::plan_program(model_, joint_ranges_, path_, settings_)).motion.blocks.size();
}

void Stages::make_motion() {
  motion_ = taken(plan::plan_program(model_, joint_ranges_, path_, settings_)).motion;
}

std::size_t Stages::read_and_analyse(const std::string& cl) const {
  const auto analysis =
      taken(analysis::analyse_path(model_, joint_ranges_, read_path(cl), settings_, {}));
  return analysis.zones.size();
}

void Stages::format(std::string& out) const {
  const auto* dialect = nc::find_dialect(target_.dialect);
  const path::ProgramHeader header{.program_name = "WAVES",
                                   .machine = machine_.name + "@" + machine_.version,
                                   .machine_hash = machine_.sha256.substr(0, 12),
                                   .comments = {}};
  taken(dialect->write(motion_, header, {}, out));
}

std::size_t Stages::prove(const std::string& nc) const {
  return taken(verify::prove(nc, *nc::find_reader(target_.dialect),
                             {.tool_path = path_,
                              .model = model_,
                              .motion = motion_,
                              .reader_setup = {.letters = motion_.letters},
                              .output = target_.output,
                              .gauge_length_mm = settings_.gauge_length_mm,
                              .tip_tolerance_mm = settings_.tip_tolerance_mm,
                              .axis_tolerance_rad = settings_.axis_tolerance_rad}))
      .blocks_read;
}

}  // namespace pentapost::bench
