#include "pentapost/plan/block_maker.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/kinematics/forward.hpp"
#include "pentapost/kinematics/inverse.hpp"
#include "pentapost/plan/state_space.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::plan {
namespace {

Problem outside(Code code, const std::string& axis, double value, const Range<double>& range,
                const char* unit, std::uint32_t line) {
  return {.code = code,
          .message = axis + " = " + number_text(value, 3) + " " + unit + " lies outside " +
                     number_text(range.lower, 3) + " to " + number_text(range.upper, 3) + " " +
                     unit + " at CL line " + std::to_string(line),
          .cl_line = line};
}

}  // namespace

WordColumns word_columns(const kinematics::Model& model) {
  WordColumns columns;
  columns.letters.clear();
  for (const auto& name : model.linear_names) columns.letters += name;
  columns.count = 3 + model.rotary_count;
  if (model.rotary_count == 0) return columns;
  if (model.rotary_count == 1) {
    columns.letters += model.rotary_names[0];
    return columns;
  }
  const bool in_order = model.rotary_names[0] < model.rotary_names[1];
  columns.first = in_order ? 3 : 4;
  columns.second = in_order ? 4 : 3;
  columns.letters += model.rotary_names[in_order ? 0 : 1];
  columns.letters += model.rotary_names[in_order ? 1 : 0];
  return columns;
}

BlockMaker::BlockMaker(const kinematics::Model& model, const JointRanges& ranges,
                       const Settings& settings, double gauge_length_mm, bool check_linear)
    : model_{model},
      ranges_{ranges},
      settings_{settings},
      gauge_length_mm_{gauge_length_mm},
      gauge_in_words_mm_{model.head_turns ? gauge_length_mm : 0.0},
      added_by_control_mm_{settings.adds_length_always
                               ? Vec3{gauge_in_words_mm_ * kinematics::length_direction(model)}
                               : Vec3::Zero()},
      check_linear_{check_linear},
      columns_{word_columns(model)} {}

Result<Posture> BlockMaker::posture(const Vec3& tip_mm, const RotaryPair& rotary,
                                    std::uint32_t cl_line) {
  Posture made;
  if (last_turns_ && rotary == last_rotary_) {
    made = last_;
  } else {
    const auto word_of = [&](double value_rad) {
      return decimal_count(value_rad * deg_per_rad, settings_.decimals_deg);
    };
    const auto printed_rad = [&](std::int64_t count) {
      return decimal_value(count, settings_.decimals_deg) * rad_per_deg;
    };
    if (model_.rotary_count > 0) {
      made.word[columns_.first] = word_of(rotary.first_rad);
      made.printed.first_rad = printed_rad(made.word[columns_.first]);
    }
    if (model_.rotary_count > 1) {
      made.word[columns_.second] = word_of(rotary.second_rad);
      made.printed.second_rad = printed_rad(made.word[columns_.second]);
    }
    last_turns_.emplace(model_, made.printed.first_rad, made.printed.second_rad);
    made.axis = last_turns_->tool_axis();
    last_rotary_ = rotary;
    last_ = made;
  }
  if (auto status = check_ranges(tip_mm, rotary, cl_line); !status)
    return std::move(status).error();

  Vec3 words_mm = tip_mm;
  if (settings_.output == Output::axes) {
    const auto linear = kinematics::inverse_linear(model_, tip_mm + settings_.origin_mm,
                                                   *last_turns_, gauge_in_words_mm_);
    if (!linear)
      return Problem{.code = Code::linear_singular,
                     .message = "the linear axes do not span space in the posture of CL line " +
                                std::to_string(cl_line),
                     .cl_line = cl_line};
    words_mm = *linear - added_by_control_mm_;
  }
  Vec3 printed_mm;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    made.word[i] = decimal_count(words_mm[index], settings_.decimals_mm);
    printed_mm[index] = decimal_value(made.word[i], settings_.decimals_mm);
  }
  if (settings_.output == Output::tcp) {
    made.tip_mm = printed_mm;
    return made;
  }
  made.linear_mm = printed_mm + added_by_control_mm_;
  made.tip_mm =
      kinematics::forward_tip_mm(model_, *last_turns_, made.linear_mm, gauge_in_words_mm_) -
      settings_.origin_mm;
  return made;
}

Posture BlockMaker::middle(const Posture& from, const Posture& to) const {
  Posture made;
  made.printed = {0.5 * (from.printed.first_rad + to.printed.first_rad),
                  0.5 * (from.printed.second_rad + to.printed.second_rad)};
  if (settings_.output == Output::tcp) {
    made.tip_mm = 0.5 * (from.tip_mm + to.tip_mm);
    made.axis = kinematics::forward_axis(model_, made.printed.first_rad, made.printed.second_rad);
    return made;
  }
  made.linear_mm = 0.5 * (from.linear_mm + to.linear_mm);
  const auto pose = kinematics::forward(model_,
                                        {.linear_mm = made.linear_mm,
                                         .first_rad = made.printed.first_rad,
                                         .second_rad = made.printed.second_rad},
                                        gauge_in_words_mm_);
  made.tip_mm = pose.tip_mm - settings_.origin_mm;
  made.axis = pose.axis;
  return made;
}

std::int64_t BlockMaker::count_mm(double length_mm) const {
  return decimal_count(length_mm, settings_.decimals_mm);
}

Status BlockMaker::check_ranges(const Vec3& tip_mm, const RotaryPair& rotary,
                                std::uint32_t cl_line) const {
  const std::array<double, 2> value_rad{rotary.first_rad, rotary.second_rad};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& range = ranges_.rotary_rad[i];
    if (in_range(range, value_rad[i])) continue;
    return outside(Code::rotary_range, model_.rotary_names[i], value_rad[i] * deg_per_rad,
                   {range->lower * deg_per_rad, range->upper * deg_per_rad}, "deg", cl_line);
  }
  if (!check_linear_) return ok();
  const auto physical = kinematics::inverse_linear(
      model_, tip_mm + settings_.origin_mm, rotary.first_rad, rotary.second_rad, gauge_length_mm_);
  if (!physical) return ok();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& range = ranges_.linear_mm[i];
    const double value_mm = (*physical)[static_cast<Eigen::Index>(i)];
    if (range && !range->contains(value_mm))
      return outside(Code::linear_range, model_.linear_names[i], value_mm, *range, "mm", cl_line);
  }
  return ok();
}

}  // namespace pentapost::plan
