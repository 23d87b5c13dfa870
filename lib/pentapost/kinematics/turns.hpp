#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/kinematics/rotate.hpp"

namespace pentapost::kinematics {

/// The two rotary motions at given joint values; a joint that the chain lacks does not turn.
/// Refers to the model.
class Turns {
 public:
  Turns(const Model& model, double first_rad, double second_rad)
      : model_{model}, first_{first_rad}, second_{second_rad} {}
  Vec3 first(const Vec3& vector) const {
    return model_.rotary_count < 1 ? vector : rotated(model_.a, first_, vector);
  }
  Vec3 second(const Vec3& vector) const {
    return model_.rotary_count < 2 ? vector : rotated(model_.b, second_, vector);
  }
  Vec3 undo_first(const Vec3& vector) const {
    return model_.rotary_count < 1 ? vector : rotated(model_.a, -first_, vector);
  }
  Vec3 undo_second(const Vec3& vector) const {
    return model_.rotary_count < 2 ? vector : rotated(model_.b, -second_, vector);
  }
  Vec3 tool_axis() const { return first(second(model_.t)); }

  /// The tip with all linear joints at zero.
  Vec3 tip_without_linear_mm(double gauge_length_mm) const {
    const Vec3 from_b_mm = -model_.b_point_mm - gauge_length_mm * model_.t;
    return model_.a_point_mm + first(model_.b_point_mm - model_.a_point_mm + second(from_b_mm));
  }

  /// Tip velocity per linear joint: D0 + Ra (D1 + Rb D2).
  Mat3 linear_matrix() const {
    Mat3 matrix = model_.linear_columns[0];
    if (!model_.has_linear[1] && !model_.has_linear[2]) return matrix;
    for (Eigen::Index i = 0; i < 3; ++i) {
      Vec3 beyond_a = model_.linear_columns[1].col(i);
      if (model_.has_linear[2]) beyond_a += second(model_.linear_columns[2].col(i));
      matrix.col(i) += first(beyond_a);
    }
    return matrix;
  }

 private:
  const Model& model_;
  SineCosine first_, second_;
};

}  // namespace pentapost::kinematics
