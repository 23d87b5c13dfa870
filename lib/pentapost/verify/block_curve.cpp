#include "pentapost/verify/block_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentapost::verify {
namespace {

using kinematics::Joints;
using kinematics::Model;
using kinematics::rotated;
using kinematics::SineCosine;

void set_axis(Station& station, const Vec3& first_direction, const Vec3& axis) {
  station.axis = axis;
  station.cosine = std::abs(first_direction.dot(axis));
  station.sine = first_direction.cross(axis).norm();
}

Joints at_share(const Joints& from, const Joints& change, double s) {
  return {.linear_mm = from.linear_mm + s * change.linear_mm,
          .first_rad = from.first_rad + s * change.first_rad,
          .second_rad = from.second_rad + s * change.second_rad};
}

}  // namespace

ChainShape::ChainShape(const Model& chain_model)
    : model{chain_model},
      tool_cosine{std::abs(chain_model.b.dot(chain_model.t))},
      tool_sine{chain_model.b.cross(chain_model.t).norm()} {}

Station tip_station(const ChainShape& shape, const Vec3& tip_mm, double first_rad,
                    double second_rad) {
  const Model& model = shape.model;
  Station station;
  station.tip_mm = tip_mm;
  const Vec3 inner = rotated(model.b, SineCosine{second_rad}, model.t);
  set_axis(station, model.a, rotated(model.a, SineCosine{first_rad}, inner));
  return station;
}

Station joint_station(const ChainShape& shape, const Joints& joints, double gauge_length_mm,
                      const Vec3& origin_mm) {
  const Model& model = shape.model;
  const SineCosine first{joints.first_rad}, second{joints.second_rad};
  Station station;
  set_axis(station, model.a, rotated(model.a, first, rotated(model.b, second, model.t)));

  Vec3 from_second = -model.b_point_mm - gauge_length_mm * model.t;
  if (model.has_linear[2]) from_second += model.linear_columns[2] * joints.linear_mm;
  const Vec3 second_arm = rotated(model.b, second, from_second);
  Vec3 from_first = model.b_point_mm - model.a_point_mm + second_arm;
  if (model.has_linear[1]) from_first += model.linear_columns[1] * joints.linear_mm;
  const Vec3 first_arm = rotated(model.a, first, from_first);
  station.tip_mm = model.a_point_mm + first_arm - origin_mm;
  if (model.has_linear[0]) station.tip_mm += model.linear_columns[0] * joints.linear_mm;
  station.arms.emplace(Arms{.first_mm = first_arm,
                            .first_turned_mm = from_first,
                            .second_mm = second_arm,
                            .second_length_mm = model.b.cross(from_second).norm(),
                            .first_turn = first,
                            .second_turn = second});
  return station;
}

BlockCurve::BlockCurve(Kind kind, const ChainShape& shape, const Joints& from, const Joints& to)
    : kind_{kind},
      shape_{&shape},
      from_{from},
      change_{.linear_mm = to.linear_mm - from.linear_mm,
              .first_rad = to.first_rad - from.first_rad,
              .second_rad = to.second_rad - from.second_rad} {}

BlockCurve BlockCurve::tip_line(const ChainShape& shape, const Vec3& tip_from_mm,
                                const Vec3& tip_to_mm, const Joints& from, const Joints& to) {
  BlockCurve curve{Kind::tip_line, shape, from, to};
  curve.tip_from_mm_ = tip_from_mm;
  curve.tip_change_mm_ = tip_to_mm - tip_from_mm;
  return curve;
}

BlockCurve BlockCurve::joint_line(const ChainShape& shape, const Joints& from, const Joints& to,
                                  double gauge_length_mm, const Vec3& origin_mm) {
  BlockCurve curve{Kind::joint_line, shape, from, to};
  curve.gauge_length_mm_ = gauge_length_mm;
  curve.origin_mm_ = origin_mm;
  const Model& model = shape.model;
  for (std::size_t place = 0; place < 3; ++place) {
    curve.linear_way_mm_[place].setZero();
    if (model.has_linear[place])
      curve.linear_way_mm_[place] = model.linear_columns[place] * curve.change_.linear_mm;
  }
  curve.before_second_mm_ = curve.linear_way_mm_[1].norm();
  curve.after_second_mm_ = curve.linear_way_mm_[2].norm();
  curve.across_second_mm_ = model.b.cross(curve.linear_way_mm_[2]).norm();
  return curve;
}

BlockCurve BlockCurve::arc(const ChainShape& shape, const path::Segment& arc,
                           const Joints& joints) {
  BlockCurve curve{Kind::arc, shape, joints, joints};
  curve.arc_ = arc;
  return curve;
}

Station BlockCurve::at(double s) const {
  const Joints joints = at_share(from_, change_, s);
  if (kind_ == Kind::joint_line)
    return joint_station(*shape_, joints, gauge_length_mm_, origin_mm_);
  const Vec3 tip_mm = arc_ ? arc_->tip_mm(s) : Vec3{tip_from_mm_ + s * tip_change_mm_};
  return tip_station(*shape_, tip_mm, joints.first_rad, joints.second_rad);
}

// With y the vector from the first rotary axis to the tip and y = R(a, alpha) v,
//   y'' = alpha' a x y' + alpha' a x R v' + R v'',   v'' = beta'^2 b x (b x w) + 2 beta' b x w',
// w the vector from the second axis to the tip. A function whose second derivative is at most K
// keeps its first derivative within K/2 of the mean, which bounds y' and v' by their differences.
double BlockCurve::tip_acceleration_mm(const Station& from, const Station& to, double h) const {
  if (kind_ == Kind::tip_line) return 0.0;
  if (kind_ == Kind::arc) {
    const double sweep_rad = h * arc_->sweep_rad();
    return sweep_rad * sweep_rad * arc_->largest_radius_mm() +
           2.0 * sweep_rad * h * std::abs(arc_->radius_change_mm());
  }
  const double alpha = std::abs(change_.first_rad) * h;
  const double beta = std::abs(change_.second_rad) * h;
  const double second_arm_mm = std::max(from.arms->second_length_mm, to.arms->second_length_mm);
  const double turned_acceleration =
      beta * beta * second_arm_mm + 2.0 * beta * across_second_mm_ * h;
  if (alpha == 0.0) return turned_acceleration;
  const double turned_speed = std::min(
      (to.arms->first_turned_mm - from.arms->first_turned_mm).norm() + 0.5 * turned_acceleration,
      (before_second_mm_ + after_second_mm_) * h + beta * second_arm_mm);
  if (alpha < 1.0)
    return (alpha * ((to.arms->first_mm - from.arms->first_mm).norm() + turned_speed) +
            turned_acceleration) /
           (1.0 - 0.5 * alpha);
  const double arm_mm =
      std::max(from.arms->first_mm.norm(), to.arms->first_mm.norm()) + 0.5 * turned_speed;
  return alpha * alpha * arm_mm + 2.0 * alpha * turned_speed + turned_acceleration;
}

// y' = R (alpha' a x v + v') with v' = D1 + beta' b x w + R(b, beta) D2.
Vec3 BlockCurve::tip_velocity_mm(const Station& station) const {
  const Model& model = shape_->model;
  const Arms& arms = *station.arms;
  Vec3 turned = change_.first_rad * model.a.cross(arms.first_turned_mm) +
                change_.second_rad * model.b.cross(arms.second_mm) + linear_way_mm_[1];
  if (model.has_linear[2]) turned += rotated(model.b, arms.second_turn, linear_way_mm_[2]);
  return linear_way_mm_[0] + rotated(model.a, arms.first_turn, turned);
}

// By Leibniz' rule; v(n) <= beta'^n |w| + n beta'^(n-1) |w'| across b, for n > 1.
double BlockCurve::tip_snap_mm(const Station& from, const Station& to) const {
  const double alpha = std::abs(change_.first_rad);
  const double beta = std::abs(change_.second_rad);
  const double arm = std::max(from.arms->second_length_mm, to.arms->second_length_mm);
  const double way = across_second_mm_;
  const double first = before_second_mm_ + after_second_mm_ + beta * arm;
  const double second = beta * (beta * arm + 2.0 * way);
  const double third = beta * beta * (beta * arm + 3.0 * way);
  const double fourth = beta * beta * beta * (beta * arm + 4.0 * way);
  const double inner_arm = std::sqrt(std::max(from.arms->first_turned_mm.squaredNorm(),
                                              to.arms->first_turned_mm.squaredNorm())) +
                           0.5 * first;
  return fourth +
         alpha * (4.0 * third + alpha * (6.0 * second + alpha * (4.0 * first + alpha * inner_arm)));
}

// With gamma the angle between a and the axis o, the parts of o'' tangent to the sphere are
//   alpha'^2 cos gamma sin gamma,  2 alpha' beta' cos gamma sin mu,  beta'^2 cos mu sin mu
// at most; gamma changes no faster than beta.
BlockCurve::AxisRates BlockCurve::axis_rates(const Station& from, const Station& to,
                                             double h) const {
  const double alpha = std::abs(change_.first_rad) * h;
  const double beta = std::abs(change_.second_rad) * h;
  const double gamma_slack = 0.5 * beta * shape_->tool_sine;
  const double sine = std::min(1.0, std::max(from.sine, to.sine) + gamma_slack);
  const double cosine = std::min(1.0, std::max(from.cosine, to.cosine) + gamma_slack);
  const double tilt = beta * shape_->tool_sine;
  return {.speed = alpha * sine + tilt,
          .acceleration = alpha * alpha * std::min(0.5, cosine * sine) +
                          2.0 * alpha * cosine * tilt + beta * tilt * shape_->tool_cosine,
          .reach = 2.0 * sine + tilt};
}

}  // namespace pentapost::verify
