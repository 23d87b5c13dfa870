#include "pentapost/kinematics/forward.hpp"

namespace pentapost::kinematics {

Pose forward(const Model& model, const Joints& joints, double gauge_length_mm) {
  const Turns turn{model, joints.first_rad, joints.second_rad};
  return {forward_tip_mm(model, turn, joints.linear_mm, gauge_length_mm), turn.tool_axis()};
}

Vec3 forward_tip_mm(const Model& model, const Turns& turn, const Vec3& linear_mm,
                    double gauge_length_mm) {
  Vec3 from_b_mm = -model.b_point_mm - gauge_length_mm * model.t;
  if (model.has_linear[2]) from_b_mm += model.linear_columns[2] * linear_mm;
  Vec3 from_a_mm = model.b_point_mm - model.a_point_mm + turn.second(from_b_mm);
  if (model.has_linear[1]) from_a_mm += model.linear_columns[1] * linear_mm;
  Vec3 tip_mm = model.a_point_mm + turn.first(from_a_mm);
  if (model.has_linear[0]) tip_mm += model.linear_columns[0] * linear_mm;
  return tip_mm;
}

Vec3 forward_axis(const Model& model, double first_rad, double second_rad) {
  return Turns{model, first_rad, second_rad}.tool_axis();
}

LinearMap linear_map(const Model& model, double first_rad, double second_rad,
                     double gauge_length_mm) {
  const Turns turn{model, first_rad, second_rad};
  return {turn.linear_matrix(), turn.tip_without_linear_mm(gauge_length_mm)};
}

Vec3 length_direction(const Model& model) {
  const Mat3 directions =
      model.linear_columns[0] + model.linear_columns[1] + model.linear_columns[2];
  return directions.inverse() * model.t;
}

}  // namespace pentapost::kinematics
