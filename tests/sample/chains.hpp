#pragma once

#include "pentapost/machine/chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Kinematic chains for tests: every topology of the bundled machines, with their points and
/// ranges, and random ones of every kind. Independent of machines/ and of the JSON reader.
namespace pentapost::sample {

struct NamedChain {
  std::string name;  ///< letters, digits and underscores: serves as a GoogleTest name
  machine::Chain chain;
};
inline void PrintTo(const NamedChain& sample, std::ostream* out) { *out << sample.name; }

inline machine::Joint linear(std::string name, const Vec3& direction,
                             std::optional<Range<double>> range_mm = std::nullopt) {
  return {std::move(name), machine::LinearJoint{UnitVector::normalised(direction), range_mm}};
}

inline machine::Joint rotary(std::string name, const Vec3& direction,
                             const Vec3& point_mm = Vec3::Zero()) {
  return {std::move(name),
          machine::RotaryJoint{UnitVector::normalised(direction), point_mm, std::nullopt}};
}

inline machine::Joint rotary(std::string name, const Vec3& direction, const Vec3& point_mm,
                             double lower_deg, double upper_deg) {
  return {std::move(name),
          machine::RotaryJoint{UnitVector::normalised(direction), point_mm,
                               Range<Angle>{Angle::degrees(lower_deg), Angle::degrees(upper_deg)}}};
}

/// The chain, which must be a possible one (otherwise std::bad_variant_access).
inline machine::Chain chain_of(std::vector<machine::Joint> table, std::vector<machine::Joint> head,
                               const Vec3& tool_axis = Vec3::UnitZ()) {
  return machine::Chain::make(std::move(table), std::move(head), UnitVector::normalised(tool_axis))
      .value();
}

inline machine::Joint x() { return linear("X", Vec3::UnitX()); }
inline machine::Joint y() { return linear("Y", Vec3::UnitY()); }
inline machine::Joint z() { return linear("Z", Vec3::UnitZ()); }

/// hermle-c600u: A/C trunnion, axes through the origin, right-handed (Cripps et al. 2017 eq. (1)).
inline machine::Chain trunnion_ac() {
  return chain_of({rotary("C", Vec3::UnitZ()), rotary("A", Vec3::UnitX(), {0, 0, 0}, -110, 110)},
                  {y(), x(), z()});
}
/// dmu-50-evolution: 45 deg nutating table, lambda = mu = 45 deg.
inline machine::Chain nutating_table() {
  return chain_of({rotary("C", -Vec3::UnitZ(), {0, 0, 155}, -29999, 29999),
                   rotary("B", {0, -1, 1}, {0, 0, 155}, 0, 180)},
                  {linear("X", Vec3::UnitX(), Range<double>{-250, 250}),
                   linear("Y", Vec3::UnitY(), Range<double>{-265, 155}),
                   linear("Z", Vec3::UnitZ(), Range<double>{162, 542})});
}
/// dmu-70-evo: nutating table with one tilt sign.
inline machine::Chain nutating_table_half() {
  return chain_of({rotary("C", -Vec3::UnitZ(), {0, 0, 0}, -99999, 99999),
                   rotary("B", {0, 1, -1}, {0, 0, 0}, 0, 102)},
                  {x(), y(), z()});
}
/// haas-umc-750: B/C trunnion by ISO 841 signs.
inline machine::Chain trunnion_bc() {
  return chain_of({rotary("C", -Vec3::UnitZ()), rotary("B", -Vec3::UnitY(), {0, 0, 0}, -35, 110)},
                  {x(), y(), z()});
}
/// mazak-variaxis-630: A/C trunnion by ISO 841 signs, tilt axis above the table face.
inline machine::Chain trunnion_ac_iso() {
  return chain_of({rotary("C", -Vec3::UnitZ()), rotary("A", -Vec3::UnitX(), {0, 0, 50}, -120, 30)},
                  {x(), y(), z()});
}
/// dmu-125p: nutating head over a rotary table, linear Y under the table.
inline machine::Chain nutating_head() {
  return chain_of(
      {rotary("C", -Vec3::UnitZ(), {0, 0, 0}, -29999, 29999), linear("Y", -Vec3::UnitY())},
      {x(), z(), rotary("B", {0, 1, 1}, {0, 272, 172}, 0, 180)});
}
/// dmu-80-monoblock: swivel head over a rotary table, linear Z under the table.
inline machine::Chain swivel_head() {
  return chain_of(
      {rotary("C", -Vec3::UnitZ(), {0, 0, 0}, -29640, 29640), linear("Z", -Vec3::UnitZ())},
      {x(), y(), rotary("B", Vec3::UnitY(), {100, 114, 195}, -120, 30)});
}
/// huron-kx100: C/B fork head, linear X under the table.
inline machine::Chain fork_head_cb() {
  return chain_of({linear("X", -Vec3::UnitX())},
                  {y(), z(), rotary("C", Vec3::UnitZ(), {0, 0, 0}, -190, 190),
                   rotary("B", Vec3::UnitY(), {0, 0, 360}, -95, 95)});
}
/// makino-mag3: C/A fork head, linear X under the table.
inline machine::Chain fork_head_ca() {
  return chain_of({linear("X", -Vec3::UnitX())},
                  {z(), y(), rotary("C", Vec3::UnitZ(), {0, 0, 0}, -360, 360),
                   rotary("A", Vec3::UnitX(), {0, 0, 205}, -110, 110)});
}
/// linuxcnc-xyzac-trt: trunnion whose axes do not meet.
inline machine::Chain trunnion_ac_offset() {
  return chain_of({rotary("C", Vec3::UnitZ(), {0, 0, 0}, -36000, 36000),
                   rotary("A", Vec3::UnitX(), {0, 20, 10}, -100, 50)},
                  {x(), y(), z()});
}
/// linuxcnc-bridgemill: C/B head, all linear joints on the head side.
inline machine::Chain bridge_head_cb() {
  return chain_of(
      {}, {x(), y(), z(), rotary("C", Vec3::UnitZ()), rotary("B", -Vec3::UnitY(), {0, 0, 250})});
}
/// pocket-nc-v2: B table on an A trunnion; the pole is the Y axis, lambda = mu = 90 deg.
inline machine::Chain trunnion_ba() {
  return chain_of({rotary("B", -Vec3::UnitY(), {0, 0, 0}, -10000, 10000),
                   rotary("A", -Vec3::UnitX(), {0, 0, 0}, -26, 136)},
                  {x(), y(), z()});
}
/// generic-ca-head.
inline machine::Chain gantry_head_ca() {
  return chain_of({}, {x(), y(), z(), rotary("C", Vec3::UnitZ(), {0, 0, 0}, -200, 200),
                       rotary("A", Vec3::UnitX(), {0, 0, 200}, -95, 95)});
}
/// generic-3axis.
inline machine::Chain three_axis() { return chain_of({}, {x(), y(), z()}); }
/// generic-4axis-a.
inline machine::Chain four_axis_a() {
  return chain_of({rotary("A", -Vec3::UnitX())}, {x(), y(), z()});
}
/// A quill on a tilting head: the linear directions lose rank at B = 90 deg.
inline machine::Chain quill_on_head() {
  return chain_of({rotary("C", -Vec3::UnitZ())},
                  {x(), y(), rotary("B", Vec3::UnitY(), {0, 0, 300}, -120, 120), z()});
}

/// Every topology above.
inline std::vector<NamedChain> bundled_chains() {
  return {{"trunnion_ac", trunnion_ac()},
          {"nutating_table", nutating_table()},
          {"nutating_table_half", nutating_table_half()},
          {"trunnion_bc", trunnion_bc()},
          {"trunnion_ac_iso", trunnion_ac_iso()},
          {"nutating_head", nutating_head()},
          {"swivel_head", swivel_head()},
          {"fork_head_cb", fork_head_cb()},
          {"fork_head_ca", fork_head_ca()},
          {"trunnion_ac_offset", trunnion_ac_offset()},
          {"bridge_head_cb", bridge_head_cb()},
          {"trunnion_ba", trunnion_ba()},
          {"gantry_head_ca", gantry_head_ca()},
          {"three_axis", three_axis()},
          {"four_axis_a", four_axis_a()},
          {"quill_on_head", quill_on_head()}};
}

/// A direction, evenly distributed on the sphere.
inline Vec3 random_axis(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (;;) {
    const Vec3 direction{normal(random), normal(random), normal(random)};
    if (direction.norm() > 1e-3) return direction.normalized();
  }
}

/// A direction at `angle_rad` to the unit vector `axis`, turned about it at random.
inline Vec3 random_axis_at(std::mt19937_64& random, const Vec3& axis, double angle_rad) {
  for (;;) {
    const Vec3 across = axis.cross(random_axis(random));
    if (across.norm() > 1e-2)
      return (std::cos(angle_rad) * axis + std::sin(angle_rad) * across.normalized()).normalized();
  }
}

/// A chain of `rotary_count` rotary joints in any order with three linear ones, cut between table
/// and head anywhere. The angles lambda and mu of two rotary joints are right ones, equal, a pair
/// that sums to 180 deg, or any, in turn with `kind` (0 to 3).
inline machine::Chain random_chain(std::mt19937_64& random, int rotary_count, int kind) {
  std::uniform_real_distribution<double> offset_mm{-300.0, 300.0};
  std::uniform_real_distribution<double> angle_rad{0.1, pi - 0.1};
  const Vec3 tool_axis = random_axis(random);
  const double mu_rad = kind == 0 ? pi / 2 : angle_rad(random);
  const double lambda_rad = kind == 0   ? pi / 2
                            : kind == 1 ? mu_rad
                            : kind == 2 ? pi - mu_rad
                                        : angle_rad(random);
  const Vec3 second = random_axis_at(random, tool_axis, mu_rad);
  const Vec3 first = random_axis_at(random, second, lambda_rad);
  const auto point_mm = [&] {
    return Vec3{offset_mm(random), offset_mm(random), offset_mm(random)};
  };
  Mat3 linear_directions;
  do {
    for (int i = 0; i < 3; ++i) linear_directions.col(i) = random_axis(random);
  } while (std::abs(linear_directions.determinant()) < 0.2);

  std::vector<bool> place_is_rotary(3 + static_cast<std::size_t>(rotary_count), false);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rotary_count); ++i)
    place_is_rotary[i] = true;
  std::shuffle(place_is_rotary.begin(), place_is_rotary.end(), random);
  const std::size_t in_table =
      std::uniform_int_distribution<std::size_t>{0, place_is_rotary.size()}(random);

  std::vector<machine::Joint> table, head;
  int linear_used = 0, rotary_used = 0;
  for (std::size_t i = 0; i < place_is_rotary.size(); ++i) {
    // The directions above are those of a tool that moves; a joint that carries the workpiece
    // moves it the other way.
    const double sign = i < in_table ? -1.0 : 1.0;
    auto& side = i < in_table ? table : head;
    if (place_is_rotary[i]) {
      const bool is_last = rotary_used + 1 == rotary_count;
      side.push_back(
          rotary(rotary_used == 0 ? "C" : "A", sign * (is_last ? second : first), point_mm()));
      ++rotary_used;
    } else {
      side.push_back(linear(std::string(1, static_cast<char>('X' + linear_used)),
                            sign * linear_directions.col(linear_used)));
      ++linear_used;
    }
  }
  return chain_of(std::move(table), std::move(head), tool_axis);
}

/// Random chains with two rotary joints, and some with one and none; the same for the same seed.
inline std::vector<NamedChain> random_chains(int count, std::uint64_t seed = 42) {
  std::mt19937_64 random{seed};
  std::vector<NamedChain> chains;
  for (int i = 0; i < count; ++i) {
    const int rotary_count = i % 10 == 8 ? 1 : i % 10 == 9 ? 0 : 2;
    chains.push_back({"random_" + std::to_string(i), random_chain(random, rotary_count, i % 4)});
  }
  return chains;
}

/// Every topology and forty random chains.
inline std::vector<NamedChain> chains() {
  auto all = bundled_chains();
  for (auto& chain : random_chains(40)) all.push_back(std::move(chain));
  return all;
}

}  // namespace pentapost::sample
