#pragma once

#include "pentapost/core/units.hpp"

#include <optional>
#include <string>

namespace pentapost::verify {

/// The tool at an end of a block off the path.
struct ToolPlace {
  Vec3 tip_mm;
  Vec3 axis;
};

/// A way off the path: retract, repositioning, plunge. Collects what would be wrong with it, since
/// only its end tells whether it returns to the cut or goes on in the air.
class Excursion {
 public:
  /// How exactly printed positions are known.
  struct Slack {
    double tip_mm = 0.0;    ///< between two printed positions
    double axis_rad = 0.0;  ///< between the printed tool axis and the planned one
  };

  bool is_active() const { return active_; }
  /// @param left  where the tool leaves the path; nullopt: it was not on it, or is not known.
  void begin(const std::optional<ToolPlace>& left);
  void end() { active_ = false; }
  const std::optional<ToolPlace>& left() const { return left_; }

  /// Whether the tool has not moved away yet, or is back, by at most `slack_mm`.
  bool is_at_left(const ToolPlace& place, double slack_mm) const {
    return left_ && (place.tip_mm - left_->tip_mm).norm() <= slack_mm;
  }

  /// A block off the path whose both ends are known.
  /// @return what is wrong whatever follows: a feed block that leaves the cut sideways.
  std::optional<std::string> take(const ToolPlace& from, const ToolPlace& to,
                                  bool rotary_stands_still, bool is_feed, const Slack& slack);
  /// A block off the path of which one end is not known.
  void take_unknown() { has_left_ = true; }

  /// What is wrong if the tool now goes on cutting where it left. nullopt: nothing.
  const std::optional<std::string>& wrong_for_return() const { return wrong_; }

 private:
  bool active_ = false;
  bool has_left_ = false;  ///< a block has moved away
  std::optional<ToolPlace> left_;
  std::optional<std::string> wrong_;
};

}  // namespace pentapost::verify
