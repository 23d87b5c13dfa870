#pragma once

#include "sample/chains.hpp"

#include <string>
#include <vector>

/// Chains on which a rotary inverse goes wrong first.
namespace pentapost::sample {

/// Two rotary heads with lambda between their axes and mu between the second one and the tool axis
/// (which is +Z), turned out of all coordinate planes.
inline machine::Chain head_of(double lambda_rad, double mu_rad, double twist_rad = 0.7) {
  const Vec3 tool = Vec3{0.2, -0.3, 0.9}.normalized();
  const Vec3 across = tool.cross(Vec3::UnitX()).normalized();
  const Vec3 second = Eigen::AngleAxisd{mu_rad, across} * tool;
  const Vec3 hinge = Eigen::AngleAxisd{twist_rad, second} * across;
  const Vec3 first = Eigen::AngleAxisd{lambda_rad, hinge} * second;
  return chain_of(
      {}, {x(), y(), z(), rotary("C", first, {10, -20, 30}), rotary("B", second, {-40, 50, 260})},
      tool);
}

inline std::vector<NamedChain> hard_chains() {
  const double deg = rad_per_deg;
  std::vector<NamedChain> chains;
  const auto add = [&](std::string name, double lambda_rad, double mu_rad) {
    chains.push_back({std::move(name), head_of(lambda_rad, mu_rad)});
  };
  add("equal_45", 45 * deg, 45 * deg);
  add("lambda_larger_by_2e_5", 45 * deg + 2e-5, 45 * deg);
  add("lambda_smaller_by_2e_5", 45 * deg - 2e-5, 45 * deg);
  add("right_angles", 90 * deg, 90 * deg);
  add("lambda_right_by_more_than_2e_5", 90 * deg + 2e-5, 90 * deg);
  add("both_right_by_more_than_2e_5", 90 * deg + 2e-5, 90 * deg + 2e-5);
  add("right_by_1e_15", 90 * deg + 1e-15, 90 * deg - 1e-15);
  add("obtuse_lambda", 135 * deg, 45 * deg);
  add("obtuse_mu", 45 * deg, 135 * deg);
  add("obtuse_both", 120 * deg, 130 * deg);
  add("small_lambda", 1e-3, 60 * deg);
  add("small_mu", 60 * deg, 1e-3);
  add("least_lambda", 2e-6, 80 * deg);
  add("least_mu", 80 * deg, 2e-6);
  add("least_both", 2e-6, 2e-6);
  add("lambda_near_180", 180 * deg - 1e-4, 30 * deg);
  add("unequal", 30 * deg, 70 * deg);
  return chains;
}

/// Every sample chain and the hard ones.
inline std::vector<NamedChain> all_chains() {
  auto all = chains();
  for (auto& chain : hard_chains()) all.push_back(std::move(chain));
  return all;
}

/// Those with two rotary joints.
inline std::vector<NamedChain> five_axis_chains() {
  auto all = all_chains();
  std::erase_if(all, [](const NamedChain& each) { return each.chain.rotary_count() != 2; });
  return all;
}

inline const auto name_of_chain = [](const auto& info) { return info.param.name; };

}  // namespace pentapost::sample
