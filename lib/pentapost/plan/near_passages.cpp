#include "pentapost/plan/near_passages.hpp"

#include "pentapost/plan/great_circle.hpp"
#include "pentapost/plan/sequences.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pentapost::plan {
namespace {

/// Moves that turn the axis by more have an uncertain great circle.
constexpr double half_turn_cosine = -0.98;

/// Follows the distance from one pole along one run and finds its minima: a minimum counts once the
/// distance has grown by more than the noise on both sides.
class Follower {
 public:
  Follower(std::uint8_t pole, std::size_t sequence, const Vec3& direction, const NearRule& rule,
           std::vector<NearPassage>& found)
      : pole_{pole}, sequence_{sequence}, direction_{direction}, rule_{rule}, found_{found} {}

  void start(std::uint32_t point, const Vec3& axis) {
    highest_ = lowest_ = place(point, 1.0, axis);
    has_nearest_ = false;
    rising_ = true;
  }

  void go_on(std::uint32_t point, const Vec3& from, const Vec3& to) {
    if (from != to && may_be_near(from, to)) {
      const GreatCircle turn{from, to};
      const double fraction = turn.nearest_fraction(direction_);
      if (fraction > 0.0 && fraction < 1.0) take(place(point, fraction, turn.axis(fraction)));
    }
    take(place(point, 1.0, to));
  }

  void end() {
    if (rising_) emit();
  }

 private:
  PlaceByPole place(std::uint32_t point, double fraction, const Vec3& axis) const {
    const double square = (axis - direction_).squaredNorm();
    const double far = rule_.far_chord;
    return {point, fraction, square < far * far ? std::sqrt(square) : far};
  }

  /// Whether a place inside the move may be nearer than its ends and near enough to count.
  bool may_be_near(const Vec3& from, const Vec3& to) const {
    const double ends =
        std::min((from - direction_).squaredNorm(), (to - direction_).squaredNorm());
    // (x + y)^2 <= 2 (x^2 + y^2)
    return ends <= 2.0 * (rule_.far_chord * rule_.far_chord + (to - from).squaredNorm());
  }

  void take(const PlaceByPole& here) {
    if (here.chord > highest_.chord) highest_ = here;
    if (here.chord < lowest_.chord) lowest_ = here;
    if (rising_ && here.chord < highest_.chord - rule_.noise_chord) {
      emit();
      before_ = highest_;
      lowest_ = here;
      rising_ = false;
    } else if (!rising_ && here.chord > lowest_.chord + rule_.noise_chord) {
      nearest_ = lowest_;
      has_nearest_ = true;
      highest_ = here;
      rising_ = true;
    }
  }

  void emit() {
    if (has_nearest_ && nearest_.chord <= rule_.nearest_chord)
      found_.push_back({pole_, sequence_, nearest_, before_, highest_});
    has_nearest_ = false;
  }

  const std::uint8_t pole_;
  const std::size_t sequence_;
  const Vec3 direction_;
  const NearRule& rule_;
  std::vector<NearPassage>& found_;
  bool rising_ = true;
  bool has_nearest_ = false;  ///< since it the distance has grown
  PlaceByPole highest_, lowest_, before_, nearest_;
};

/// Whether the move to a point may be subdivided and bent.
std::vector<bool> straight_feeds(const path::ToolPath& tool_path) {
  std::vector<bool> straight(tool_path.size(), false);
  for (std::size_t point = 1; point < tool_path.size(); ++point)
    straight[point] = tool_path.move[point] == path::Move::feed &&
                      tool_path.axis_wp[point - 1].dot(tool_path.axis_wp[point]) > half_turn_cosine;
  for (const path::Event& event : tool_path.events)
    if (std::holds_alternative<path::Arc>(event.what) && event.before_point < straight.size())
      straight[event.before_point] = false;
  return straight;
}

}  // namespace

std::vector<NearPassage> near_passages(const kinematics::Model& model,
                                       const path::ToolPath& tool_path, const PoleZone& zone,
                                       const NearRule& rule) {
  std::vector<NearPassage> found;
  const std::vector<bool> straight = straight_feeds(tool_path);
  const auto all = sequences(tool_path);
  for (const std::uint8_t pole : {std::uint8_t{1}, std::uint8_t{2}}) {
    if (!(pole == 1 ? zone.at_zero : zone.at_pi)) continue;
    for (std::size_t sequence = 0; sequence < all.size(); ++sequence) {
      Follower follower{pole, sequence, pole_axis(model, pole), rule, found};
      const PointRange range = all[sequence].range;
      follower.start(range.begin, tool_path.axis_wp[range.begin]);
      for (std::uint32_t point = range.begin + 1; point < range.end; ++point) {
        if (straight[point]) {
          follower.go_on(point, tool_path.axis_wp[point - 1], tool_path.axis_wp[point]);
          continue;
        }
        follower.end();
        follower.start(point, tool_path.axis_wp[point]);
      }
      follower.end();
    }
  }
  std::sort(found.begin(), found.end(), [](const NearPassage& one, const NearPassage& other) {
    return std::tuple{one.nearest.point, one.nearest.fraction} <
           std::tuple{other.nearest.point, other.nearest.fraction};
  });
  return found;
}

}  // namespace pentapost::plan
