#include "pentapost/kinematics/model.hpp"

#include "pentapost/kinematics/rotate.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pentapost::kinematics {
namespace {

using machine::Joint;
using machine::LinearJoint;
using machine::RotaryJoint;

/// Cosines below this are those of a right angle: rounding of two unit vectors.
constexpr double right_angle_cosine = 1e-15;

/// A joint as the way from the workpiece to the tool meets it: +1 head side, -1 table side.
struct Step {
  const Joint* joint;
  double sign;
};

std::vector<Step> walk(const machine::Chain& chain) {
  std::vector<Step> steps;
  for (const Joint& joint : chain.table()) steps.push_back({&joint, -1.0});
  for (const Joint& joint : chain.head()) steps.push_back({&joint, +1.0});
  return steps;
}

std::array<std::string, 3> sorted_linear_names(const std::vector<Step>& steps) {
  std::array<std::string, 3> names;
  std::size_t count = 0;
  for (const Step& step : steps)
    if (!step.joint->is_rotary()) names.at(count++) = step.joint->name;
  std::sort(names.begin(), names.end());
  return names;
}

void place_joints(Model& model, const std::vector<Step>& steps) {
  model.linear_names = sorted_linear_names(steps);
  std::size_t place = 0;
  for (const auto& [joint, sign] : steps) {
    if (const auto* turning = std::get_if<RotaryJoint>(&joint->kind)) {
      (place == 0 ? model.a : model.b) = sign * turning->direction.vec();
      (place == 0 ? model.a_point_mm : model.b_point_mm) = turning->point_mm;
      model.rotary_names.at(place++) = joint->name;
    } else {
      const auto name =
          std::find(model.linear_names.begin(), model.linear_names.end(), joint->name);
      const auto column = name - model.linear_names.begin();
      model.linear_columns.at(place).col(column) =
          sign * std::get<LinearJoint>(joint->kind).direction.vec();
      model.has_linear.at(place) = true;
    }
  }
}

/// Any unit vector at right angles to `axis`; a coordinate direction where there is one.
Vec3 perpendicular(const Vec3& axis) {
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  const Vec3 start = Vec3::Unit(smallest);
  return (start - axis.dot(start) * axis).normalized();
}

/// Draws the triangle: flips, sides and beta_zero.
void draw_triangle(Model& model) {
  const Vec3 &a = model.a, &b = model.b, &t = model.t;
  model.b_flipped = b.dot(t) < 0.0;
  const Vec3 b_drawn = model.b_flipped ? Vec3{-b} : b;
  const double cos_lambda = a.dot(b_drawn);
  model.a_flipped = std::abs(cos_lambda) <= right_angle_cosine ? a.dot(t) < 0.0 : cos_lambda < 0.0;
  const Vec3 a_drawn = model.a_flipped ? Vec3{-a} : a;
  model.fixed.a_drawn = a_drawn;
  model.lambda_rad = angle_between_rad(a_drawn, b_drawn);
  model.mu_rad = angle_between_rad(b_drawn, t);
  // From the shadows of t and a along b, since the differences of dot products lose digits where
  // lambda or mu is small.
  const Vec3 t_quarter = b.cross(t), a_quarter = b.cross(a_drawn);
  model.beta_zero_rad = std::atan2(b.dot(t_quarter.cross(a_quarter)), t_quarter.dot(a_quarter));
}

/// Prepares how the tool axis, seen along a, depends on the second joint.
void prepare_view_along_a(Model& model) {
  Model::Fixed& fixed = model.fixed;
  const auto view = [&](const Vec3& vector) {
    return Eigen::Vector2d{fixed.p.dot(vector), fixed.q.dot(vector)};
  };
  if (model.rotary_count < 2) {
    fixed.start = view(model.t);
    return;
  }
  const Vec3 axis_at_zero = rotated(model.b, SineCosine{model.beta_zero_rad}, model.t);
  const Vec3 quarter = model.b.cross(axis_at_zero);
  fixed.start = view(axis_at_zero);
  fixed.turned_half = view(model.b.cross(quarter));
  fixed.turned_quarter = view(quarter);
}

}  // namespace

Mat3 rotation(const Vec3& axis, double angle_rad) {
  const SineCosine angle{angle_rad};
  Mat3 matrix;
  for (Eigen::Index i = 0; i < 3; ++i) matrix.col(i) = rotated(axis, angle, Vec3::Unit(i));
  return matrix;
}

Model::Model(const machine::Chain& chain)
    : rotary_count{chain.rotary_count()},
      head_turns{chain.head_turns()},
      t{chain.tool_axis().vec()} {
  place_joints(*this, walk(chain));
  fixed.a_drawn = a;
  if (rotary_count == 1) lambda_rad = angle_between_rad(a, t);
  if (rotary_count == 2) draw_triangle(*this);

  fixed.p = perpendicular(a);
  fixed.q = a.cross(fixed.p);
  fixed.sin_half_difference = std::sin((mu_rad - lambda_rad) / 2.0);
  fixed.cos_half_difference = std::cos((mu_rad - lambda_rad) / 2.0);
  fixed.sin_half_sum = std::sin((lambda_rad + mu_rad) / 2.0);
  fixed.cos_half_sum = std::cos((lambda_rad + mu_rad) / 2.0);
  fixed.sin_lambda_sin_mu = std::sin(lambda_rad) * std::sin(mu_rad);
  prepare_view_along_a(*this);

  if (std::count(has_linear.begin(), has_linear.end(), true) == 1)
    fixed.linear_place = has_linear[0] ? 0 : has_linear[1] ? 1 : 2;
  const Mat3 linear_directions = linear_columns[0] + linear_columns[1] + linear_columns[2];
  fixed.linear_volume = linear_directions.determinant();
  fixed.linear_inverse = linear_directions.inverse();
}

}  // namespace pentapost::kinematics
