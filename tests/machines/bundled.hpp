#pragma once

#include "pentapost/core/units.hpp"
#include "pentapost/json/machine_files.hpp"
#include "pentapost/machine/definition.hpp"

#include <Eigen/Geometry>

#include <array>
#include <filesystem>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The machines of machines/, for tests of their kinematics.
namespace pentapost::sample {

struct BundledMachine {
  machine::Definition definition;
};
inline void PrintTo(const BundledMachine& machine, std::ostream* out) {
  *out << machine.definition.name;
}

/// The newest version of every machine. Throws where a file is bad.
inline std::vector<BundledMachine> bundled_machines() {
  constexpr std::array<std::string_view, 6> dialects{"heidenhain", "heidenhain-iso", "siemens-840d",
                                                     "fanuc-30i",  "haas-ngc",       "linuxcnc"};
  const auto report =
      json::load_machines(std::filesystem::path{PENTAPOST_SOURCE_DIR} / "machines", dialects);
  if (!report.bad.empty()) throw std::runtime_error{json::text_of(report.bad.front())};
  std::vector<BundledMachine> machines;
  for (const auto& name : report.library.names())
    machines.push_back({report.library.find(name)->definition});
  return machines;
}

inline machine::Definition bundled_machine(std::string_view name) {
  for (const auto& machine : bundled_machines())
    if (machine.definition.name == name) return machine.definition;
  throw std::runtime_error{"no such machine: " + std::string{name}};
}

/// Joint values by letter, mm and rad; a letter that is missing is 0.
using JointValues = std::map<std::string, double>;

/// The motion of one joint by its definition: a positive value moves the carried body along, or
/// right-handed about, the direction.
inline Eigen::Isometry3d motion_of(const machine::Joint& joint, const JointValues& values) {
  const auto found = values.find(joint.name);
  const double value = found == values.end() ? 0.0 : found->second;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (const auto* const turning = std::get_if<machine::RotaryJoint>(&joint.kind)) {
    motion.translate(turning->point_mm);
    motion.rotate(Eigen::AngleAxisd{value, turning->direction.vec()});
    motion.translate(-turning->point_mm);
  } else {
    motion.translate(value * std::get<machine::LinearJoint>(joint.kind).direction.vec());
  }
  return motion;
}

/// Tool tip and tool axis in the workpiece frame.
struct ToolPose {
  Vec3 tip_mm;
  Vec3 axis;
};

/// T_bw^-1 T_bt with homogeneous matrices, straight from the definition: the truth that the
/// library's forward chain is held against.
inline ToolPose pose_by_definition(const machine::Chain& chain, const JointValues& values,
                                   double gauge_length_mm) {
  Eigen::Isometry3d T_base_wp = Eigen::Isometry3d::Identity();
  for (const auto& joint : chain.table()) T_base_wp = motion_of(joint, values) * T_base_wp;
  Eigen::Isometry3d T_base_tool = Eigen::Isometry3d::Identity();
  for (const auto& joint : chain.head()) T_base_tool = T_base_tool * motion_of(joint, values);
  const Eigen::Isometry3d T_wp_tool = T_base_wp.inverse() * T_base_tool;
  const Vec3 axis = chain.tool_axis().vec();
  return {T_wp_tool * (-gauge_length_mm * axis), T_wp_tool.linear() * axis};
}

}  // namespace pentapost::sample
