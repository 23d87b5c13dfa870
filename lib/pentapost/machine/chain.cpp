#include "pentapost/machine/chain.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>

namespace pentapost::machine {
namespace {

constexpr double smallest_sine = 1e-6;    ///< below it the triangle of section 2 is degenerate
constexpr double smallest_volume = 1e-6;  ///< of three unit directions that span space

Problem shape(std::string message) { return {Code::chain_shape, std::move(message)}; }

double sine_between(const Vec3& x, const Vec3& y) { return x.cross(y).norm(); }

}  // namespace

Result<Chain> Chain::make(std::vector<Joint> table, std::vector<Joint> head, UnitVector tool_axis) {
  std::vector<Vec3> linear, rotary;
  std::vector<std::string> names;
  const auto look_at = [&](const Joint& joint) {
    names.push_back(joint.name);
    if (const auto* turning = std::get_if<RotaryJoint>(&joint.kind))
      rotary.push_back(turning->direction.vec());
    else
      linear.push_back(std::get<LinearJoint>(joint.kind).direction.vec());
  };
  std::for_each(table.begin(), table.end(), look_at);
  std::for_each(head.begin(), head.end(), look_at);

  std::sort(names.begin(), names.end());
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    return shape("the chain names the joint " + *twice + " twice");
  if (linear.size() != 3)
    return shape("the chain has " + std::to_string(linear.size()) + " linear joints; 3 are needed");
  if (const double volume = std::abs(linear[0].dot(linear[1].cross(linear[2])));
      volume < smallest_volume)
    return shape("the directions of the linear joints do not span space (volume " +
                 number_text(volume) + ")");
  if (rotary.size() > 2)
    return shape("the chain has " + std::to_string(rotary.size()) +
                 " rotary joints; at most 2 are possible");
  if (rotary.size() == 2 && sine_between(rotary[0], rotary[1]) < smallest_sine)
    return shape("the two rotary axes are parallel");
  if (rotary.size() == 2 && sine_between(rotary.back(), tool_axis.vec()) < smallest_sine)
    return shape("the rotary axis nearest the tool is parallel to the tool axis");
  return Chain{std::move(table), std::move(head), tool_axis, static_cast<int>(rotary.size())};
}

bool Chain::head_turns() const noexcept {
  return std::any_of(head_.begin(), head_.end(),
                     [](const Joint& joint) { return joint.is_rotary(); });
}

}  // namespace pentapost::machine
