#include "pentapost/verify/tool_position.hpp"

#include "pentapost/kinematics/forward.hpp"

namespace pentapost::verify {
namespace {

/// Linear directions this close to X, Y and Z are these.
constexpr double direction_rounding = 1e-12;

bool directions_are_plain(const kinematics::Model& model) {
  const Mat3 directions =
      model.linear_columns[0] + model.linear_columns[1] + model.linear_columns[2];
  return (directions - Mat3::Identity()).cwiseAbs().maxCoeff() <= direction_rounding;
}

}  // namespace

ToolPosition::ToolPosition(const ChainShape& shape, const AxisColumns& columns, Output output,
                           const Vec3& origin_mm)
    : shape_{shape},
      columns_{columns},
      output_{output},
      origin_mm_{origin_mm},
      length_direction_{kinematics::length_direction(shape.model)},
      plain_{directions_are_plain(shape.model)} {}

bool ToolPosition::rotary_words_are_zero(const Words& words) const {
  for (std::size_t column = 3; column < columns_.count(); ++column)
    if (words[column] != 0.0) return false;
  return true;
}

Meaning ToolPosition::meaning_of(const nc::ReadMotion& motion) const {
  if (motion.machine_frame) return Meaning::unknown;
  if (output_ == Output::axes) {
    // Where the head turns the words may hold the gauge length; elsewhere the control has to add
    // it.
    const bool length_is_held = motion.tool_length_offset || shape_.model.head_turns;
    return !motion.tcp && length_is_held ? Meaning::joints : Meaning::unknown;
  }
  if (motion.tcp) return Meaning::tip;
  const bool plain = plain_ && motion.tool_length_offset && rotary_words_are_zero(now_.words);
  return plain ? Meaning::tip : Meaning::unknown;
}

void ToolPosition::lose(std::uint8_t columns) {
  now_.known = static_cast<std::uint8_t>(now_.known & ~columns);
  now_.placed = false;
}

void ToolPosition::go(const nc::ReadMotion& motion, std::optional<double> gauge_length_mm) {
  before_ = now_;
  // The linear words change their meaning with TCP, except where tip and axes agree.
  const bool rotary_is_known = (before_.known & columns_.rotary()) == columns_.rotary();
  if (motion.tcp != tcp_ && !(plain_ && rotary_is_known && rotary_words_are_zero(before_.words)))
    now_.known = static_cast<std::uint8_t>(now_.known & ~AxisColumns::linear);
  tcp_ = motion.tcp;
  now_.known = static_cast<std::uint8_t>((now_.known | motion.stated) & motion.known);
  now_.words = motion.position;
  now_.length_is_added = motion.tool_length_offset && shape_.model.head_turns;
  now_.meaning = meaning_of(motion);
  now_.placed = now_.known == columns_.all() && now_.meaning != Meaning::unknown &&
                place(now_, gauge_length_mm);
}

bool ToolPosition::place(Stop& stop, std::optional<double> gauge_length_mm) const {
  stop.joints = columns_.joints(stop.words);
  if (stop.meaning == Meaning::joints) {
    if (!gauge_length_mm) return false;
    if (stop.length_is_added) stop.joints.linear_mm += *gauge_length_mm * length_direction_;
    stop.station = joint_station(shape_, stop.joints, *gauge_length_mm, origin_mm_);
    return true;
  }
  const bool turned = !before_.placed || before_.meaning != Meaning::tip ||
                      before_.joints.first_rad != stop.joints.first_rad ||
                      before_.joints.second_rad != stop.joints.second_rad;
  if (turned)
    stop.station =
        tip_station(shape_, stop.joints.linear_mm, stop.joints.first_rad, stop.joints.second_rad);
  else
    stop.station.tip_mm = stop.joints.linear_mm;
  return true;
}

Stop ToolPosition::place_with(std::size_t column, double word, double gauge_length_mm) const {
  Stop stop = now_;
  stop.words[column] = word;
  stop.placed = place(stop, gauge_length_mm);
  return stop;
}

}  // namespace pentapost::verify
