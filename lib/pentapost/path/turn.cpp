#include "pentapost/path/turn.hpp"

namespace pentapost::path {

Mat3 setup_turn(double theta_x_rad, double theta_z_rad) {
  return (Eigen::AngleAxisd{-theta_x_rad, Vec3::UnitX()} *
          Eigen::AngleAxisd{-theta_z_rad, Vec3::UnitZ()})
      .toRotationMatrix();
}

void turn(ToolPath& tool_path, const Mat3& rotation) {
  for (Vec3& tip_mm : tool_path.tip_wp_mm) tip_mm = rotation * tip_mm;
  for (Vec3& axis : tool_path.axis_wp) axis = (rotation * axis).normalized();
  for (Event& event : tool_path.events) {
    if (auto* arc = std::get_if<Arc>(&event.what)) {
      arc->centre_wp_mm = rotation * arc->centre_wp_mm;
      arc->normal_wp = (rotation * arc->normal_wp).normalized();
    } else if (auto* start = std::get_if<StartPoint>(&event.what)) {
      start->tip_wp_mm = rotation * start->tip_wp_mm;
      start->axis_wp = (rotation * start->axis_wp).normalized();
    }
  }
}

}  // namespace pentapost::path
