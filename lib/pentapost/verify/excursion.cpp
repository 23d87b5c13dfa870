#include "pentapost/verify/excursion.hpp"

#include "pentapost/core/number_text.hpp"

namespace pentapost::verify {
namespace {

/// How far a way runs beside the tool axis.
double sideways_mm(const Vec3& way_mm, const Vec3& axis) { return axis.cross(way_mm).norm(); }

std::string mm_text(double length_mm) { return number_text(length_mm, 6) + " mm"; }

}  // namespace

void Excursion::begin(const std::optional<ToolPlace>& left) {
  active_ = true;
  has_left_ = false;
  left_ = left;
  wrong_.reset();
}

std::optional<std::string> Excursion::take(const ToolPlace& from, const ToolPlace& to,
                                           bool rotary_stands_still, bool is_feed,
                                           const Slack& slack) {
  if (!left_) return std::nullopt;
  const bool leaves = !has_left_;
  const Vec3 way_mm = to.tip_mm - from.tip_mm;
  const double allowed_mm = slack.tip_mm + slack.axis_rad * way_mm.norm();
  const bool returns = is_at_left(to, slack.tip_mm);
  has_left_ = !returns;
  const double height_mm = (to.tip_mm - left_->tip_mm).dot(left_->axis);

  std::optional<std::string> found;
  if ((leaves || returns) && !rotary_stands_still)
    found = "turns rotary axes where the tool is in the cut";
  else if ((leaves || returns) && !(sideways_mm(way_mm, from.axis) <= allowed_mm))
    found = "leaves the tool axis by " + mm_text(sideways_mm(way_mm, from.axis)) +
            " where it leaves or comes back to the cut";
  else if (leaves && !(way_mm.dot(from.axis) >= -allowed_mm))
    found = "retracts into the material by " + mm_text(-way_mm.dot(from.axis));
  else if (!(height_mm >= -(slack.tip_mm + slack.axis_rad * (to.tip_mm - left_->tip_mm).norm())))
    found = "goes " + mm_text(-height_mm) + " below the place where the cut was left";
  if (found && !wrong_) wrong_ = found;
  return is_feed && leaves ? found : std::nullopt;
}

}  // namespace pentapost::verify
