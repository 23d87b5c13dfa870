#include "pentapost/core/number_text.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/verify/feed_rule.hpp"
#include "pentapost/verify/hole.hpp"
#include "pentapost/verify/pole_allowance.hpp"
#include "pentapost/verify/printed_arc.hpp"
#include "pentapost/verify/replay.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::verify {
namespace {

using Kind = nc::ReadMotion::Kind;

bool rotary_stands_still(const Stop& from, const Stop& to) {
  return from.joints.first_rad == to.joints.first_rad &&
         from.joints.second_rad == to.joints.second_rad;
}

}  // namespace

std::optional<double> Replay::gauge_length_mm() const {
  if (!claim_.model.head_turns) return 0.0;
  const auto found = claim_.gauge_length_mm.find(tool_.value_or(1));
  if (found == claim_.gauge_length_mm.end()) return std::nullopt;
  return found->second;
}

bool Replay::prove(const Deviation& found) {
  // Written so that NaN fails.
  auto& [limit, proven] = near_pole_ ? held_near_pole_ : held_;
  if (!(found.tip_mm <= limit.tip_mm))
    return fail("the tool tip leaves the CL path by " + number_text(found.tip_mm, 9) +
                " mm, the tolerance is " + number_text(claim_.tip_tolerance_mm) + " mm");
  if (!(found.axis_chord <= limit.axis_chord))
    return fail(
        "the tool axis leaves the CL axis by " +
        number_text(angle_of_chord(found.axis_chord) * deg_per_rad, 9) + " deg, the tolerance is " +
        number_text(claim_.axis_tolerance_rad * deg_per_rad) + " deg" +
        (near_pole_
             ? " and " + number_text(claim_.pole_axis_rad * deg_per_rad) + " deg near the pole"
             : ""));
  proven = {std::max(proven.tip_mm, found.tip_mm), std::max(proven.axis_chord, found.axis_chord)};
  return true;
}

bool Replay::search(const BlockCurve& curve, const MovePart& part) {
  return prove(largest_deviation(curve, position_.before().station, position_.now().station, part,
                                 held().proven, held().limit));
}

Vec3 Replay::move_start_mm(std::uint32_t point) const {
  return hole_retract_mm_ ? *hole_retract_mm_ : claim_.tool_path.tip_wp_mm[point - 1];
}

const path::Segment& Replay::move_to(std::uint32_t point) {
  if (move_ && move_point_ == point) return *move_;
  const path::ToolPath& cl = claim_.tool_path;
  // Point 0 has no way to it; a move that stands there.
  const std::uint32_t before = point == 0 ? 0 : point - 1;
  const Vec3 start_mm = point == 0 ? cl.tip_wp_mm[0] : move_start_mm(point);
  move_.emplace(start_mm, cl.axis_wp[before], cl.tip_wp_mm[point], cl.axis_wp[point],
                point == 0 ? nullptr : cl_.arc());
  move_point_ = point;
  return *move_;
}

double Replay::move_length_mm(std::uint32_t point) {
  if (cl_.arc() != nullptr) return move_to(point).length_mm();
  return (claim_.tool_path.tip_wp_mm[point] - move_start_mm(point)).norm();
}

bool Replay::needs_place(const Stop& stop, const char* which) {
  if (stop.placed) return true;
  const std::string place = std::string{"the tool's position at the "} + which + " of the block ";
  if (stop.known != columns_.all()) return fail(place + "is not known");
  if (stop.meaning == Meaning::joints)
    return fail(place + "is not known: no gauge length for tool " +
                std::to_string(tool_.value_or(1)));
  return fail(place + (claim_.output == Output::tcp
                           ? "is no tool tip: neither TCP is on nor are all rotary axes at zero "
                             "with the length offset on"
                           : "is no set of joint values: TCP or the length offset is wrong"));
}

bool Replay::on_path(const nc::ReadMotion& motion, const Covered& covered) {
  const path::Move move = claim_.tool_path.move[covered.point];
  if (cl_.advance_to(covered.point)) settings_are_new_ = true;
  if (const std::string wrong = wrong_length_register(cl_, motion); !wrong.empty())
    return fail(wrong);
  // Without a block of its own the first point is proven as the start of the first cut.
  if (!entered_ && covered.point != 0 &&
      (move != path::Move::feed || claim_.tool_path.move[0] == path::Move::hole))
    return fail("no block reaches the first CL point");
  if (!needs_place(position_.now(), "end")) return false;
  bool proven = false;
  switch (move) {
    case path::Move::rapid:
      proven = reach_point(motion, covered);
      break;
    case path::Move::feed:
      // From a tool change or from home the tool comes by a way of its own.
      proven = covered.point == 0 || (cl_.starts_anew() && excursion_.is_active())
                   ? reach_point(motion, covered)
                   : cut(motion, covered);
      break;
    case path::Move::hole:
      proven = drill(motion, covered);
      break;
  }
  entered_ = true;
  if (move != path::Move::hole && covered.to_fraction == 1.0) hole_retract_mm_.reset();
  return proven;
}

bool Replay::reach_point(const nc::ReadMotion& motion, const Covered& covered) {
  if (motion.kind != Kind::rapid && motion.kind != Kind::line)
    return fail("an arc or a cycle where the CL data has a rapid move");
  if (motion.kind == Kind::line && !(motion.feed > 0.0)) return fail("a feed move without a feed");
  excursion_.end();
  const Station& end = position_.now().station;
  const path::ToolPath& cl = claim_.tool_path;
  const std::uint32_t point = covered.point;
  if (covered.to_fraction == 1.0)
    return prove(
        {(end.tip_mm - cl.tip_wp_mm[point]).norm(), (end.axis - cl.axis_wp[point]).norm()});
  const path::Segment& move = move_to(point);
  return prove({(end.tip_mm - move.tip_mm(covered.to_fraction)).norm(),
                (end.axis - move.axis(covered.to_fraction)).norm()});
}

bool Replay::cut(const nc::ReadMotion& motion, const Covered& covered) {
  if (motion.kind != Kind::line && motion.kind != Kind::arc)
    return fail(motion.kind == Kind::rapid ? "a rapid move where the CL data cuts"
                                           : "a cycle where the CL data has none");
  if (!needs_place(position_.before(), "start") || !come_back()) return false;
  if (position_.before().meaning != position_.now().meaning)
    return fail("the words change their meaning within a cut");
  if (settings_are_new_ && !settings_are_right()) return false;
  if (!feed_is_right(motion, covered)) return false;
  near_pole_ = has_changed_axis(claim_, covered.point);
  const bool proven =
      motion.kind == Kind::arc ? cut_arc(motion, covered) : cut_line(motion, covered);
  near_pole_ = false;
  return proven;
}

bool Replay::settings_are_right() {
  const std::string wrong = wrong_setting(cl_, tool_, spindle_);
  if (!wrong.empty()) return fail(wrong);
  settings_are_new_ = false;
  return true;
}

bool Replay::feed_is_right(const nc::ReadMotion& motion, const Covered& covered) {
  const Stop &from = position_.before(), &to = position_.now();
  const bool tip_moves = from.joints.linear_mm != to.joints.linear_mm;
  FeedCase feed_case{.programmed_mm_min = cl_.feed_mm_min()};
  if (motion.feed_mode == nc::ReadMotion::Feed::inverse_time)
    feed_case.cl_length_mm =
        move_length_mm(covered.point) * (covered.to_fraction - covered.from_fraction);
  else
    feed_case.f_is_tip_speed =
        tip_moves && (to.meaning == Meaning::tip || rotary_stands_still(from, to));
  const std::string wrong = wrong_feed(motion, feed_case);
  return wrong.empty() || fail(wrong);
}

BlockCurve Replay::curve() const {
  const Stop &from = position_.before(), &to = position_.now();
  if (to.meaning == Meaning::joints)
    return BlockCurve::joint_line(shape_, from.joints, to.joints, gauge_length_mm().value_or(0.0),
                                  claim_.origin_mm);
  return BlockCurve::tip_line(shape_, from.station.tip_mm, to.station.tip_mm, from.joints,
                              to.joints);
}

bool Replay::cut_line(const nc::ReadMotion&, const Covered& covered) {
  const path::ToolPath& cl = claim_.tool_path;
  const std::uint32_t point = covered.point;
  const BlockCurve block_curve = curve();
  const bool is_whole_line =
      covered.from_fraction == 0.0 && covered.to_fraction == 1.0 && cl_.arc() == nullptr;
  if (is_whole_line) {
    const Deviation bound = quick_bound(
        block_curve, position_.before().station, position_.now().station, move_start_mm(point),
        cl.axis_wp[point - 1], cl.tip_wp_mm[point], cl.axis_wp[point], tip_resolution_mm_);
    const Deviation& proven = held().proven;
    if (bound.tip_mm <= proven.tip_mm && bound.axis_chord <= proven.axis_chord) return true;
  }
  return search(block_curve, {.move = move_to(point),
                              .from_fraction = covered.from_fraction,
                              .to_fraction = covered.to_fraction,
                              .tip_resolution_mm = tip_resolution_mm_});
}

bool Replay::cut_arc(const nc::ReadMotion& motion, const Covered& covered) {
  const Stop &from = position_.before(), &to = position_.now();
  if (columns_.find('X') != 0U || columns_.find('Y') != 1U || columns_.find('Z') != 2U)
    return fail("an arc on a machine without X, Y and Z");
  const Mat3 to_cl =
      to.meaning == Meaning::tip
          ? Mat3::Identity()
          : kinematics::linear_map(claim_.model, to.joints.first_rad, to.joints.second_rad,
                                   gauge_length_mm().value_or(0.0))
                .matrix;
  std::string wrong;
  const auto printed = printed_arc(motion, from, to, to_cl, wrong);
  if (!printed) return fail(wrong);
  const path::Segment& move = move_to(covered.point);
  wrong = wrong_turning(*printed, move, covered.to_fraction - covered.from_fraction);
  if (!wrong.empty()) return fail(wrong);
  return search(BlockCurve::arc(shape_, *printed, to.joints),
                {.move = move,
                 .from_fraction = covered.from_fraction,
                 .to_fraction = covered.to_fraction,
                 .tip_resolution_mm = tip_resolution_mm_});
}

std::optional<Vec3> Replay::last_place_mm(std::uint32_t point) const {
  const auto& axes = claim_.tool_path.axis_wp;
  if (point == 0 || cl_.starts_anew()) return std::nullopt;
  if (!((axes[point] - axes[point - 1]).norm() <= held_.limit.axis_chord)) return std::nullopt;
  return move_start_mm(point);
}

bool Replay::drill(const nc::ReadMotion& motion, const Covered& covered) {
  const path::CycleStart* cycle = cl_.cycle();
  if (motion.kind != Kind::drill || cycle == nullptr)
    return fail("no drilling cycle where the CL data has a hole");
  if (motion.tcp) return fail("a drilling cycle while TCP is on");
  const auto z = columns_.find('Z');
  if (!z || covered.to_fraction != 1.0) return fail("a drilling cycle without Z or in parts");
  const Stop &from = position_.before(), bottom = position_.now();
  if ((from.known & columns_.rotary()) != columns_.rotary() ||
      !std::equal(from.words.begin() + 3, from.words.end(), bottom.words.begin() + 3))
    return fail("a rotary axis moves within a drilling cycle, or is not known before it");
  if (excursion_.is_active() && excursion_.wrong_for_return())
    return fail("before this hole the tool " + *excursion_.wrong_for_return());
  excursion_.end();
  if (settings_are_new_ && !settings_are_right()) return false;
  std::string wrong = wrong_hole_feed(motion, cl_);
  if (wrong.empty()) wrong = wrong_cycle_data(motion, *cycle, 2.0 * tip_resolution_mm_);
  if (!wrong.empty()) return fail(wrong);

  const double gauge_mm = gauge_length_mm().value_or(0.0);
  const Vec3& axis = claim_.tool_path.axis_wp[covered.point];
  const HoleLevels levels = hole_levels(*cycle, claim_.tool_path.tip_wp_mm[covered.point], axis);
  const Stop clearance = position_.place_with(*z, motion.clearance_z_mm, gauge_mm);
  const Stop retract = position_.place_with(*z, motion.retract_z_mm, gauge_mm);
  if (!prove(hole_deviation(levels, axis, bottom, clearance, retract))) return false;
  std::optional<Stop> travel;
  if (motion.travel_z_mm) travel = position_.place_with(*z, *motion.travel_z_mm, gauge_mm);
  wrong = wrong_travel(from, clearance, travel, last_place_mm(covered.point), axis, held_.limit);
  if (!wrong.empty()) return fail(wrong);
  position_.set(retract);
  hole_retract_mm_ = levels.retract_mm;
  return true;
}

}  // namespace pentapost::verify
