#include "stages.hpp"

#include "pentapost/cl/reader.hpp"
#include "pentapost/kinematics/inverse.hpp"

#include <stdexcept>
#include <utility>

namespace pentapost::bench {
namespace {

machine::Joint linear(const char* name, const Vec3& direction) {
  return {name, machine::LinearJoint{UnitVector::normalised(direction), {}}};
}

machine::Joint rotary(const char* name, const Vec3& direction,
                      std::optional<Range<Angle>> range = {}) {
  return {name, machine::RotaryJoint{UnitVector::normalised(direction), Vec3::Zero(), range}};
}

}  // namespace

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

jobs::PostJob bench_job(std::string cl) {
  return {.machine = bench_machine(),
          .path = jobs::ClText{.text = std::move(cl)},
          .gauge_length_mm = {{1, 120.0}}};
}

path::ToolPath bench_path(const std::string& cl) {
  cl::ReadResult result = cl::read(cl);
  if (result.diagnostics.has_errors()) throw std::logic_error{"the bench's CL text is damaged"};
  return std::move(result.path);
}

std::size_t invert_all(const kinematics::Model& model, const path::ToolPath& path) {
  std::size_t solutions = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto rotaries = kinematics::inverse_rotary(model, path.axis_wp[i]);
    const auto& first = rotaries.branch[0];
    const auto linear_mm = kinematics::inverse_linear(model, path.tip_wp_mm[i], first.first_rad,
                                                      first.second_rad, 120.0);
    if (linear_mm) solutions += static_cast<std::size_t>(rotaries.count);
  }
  return solutions;
}

}  // namespace pentapost::bench
