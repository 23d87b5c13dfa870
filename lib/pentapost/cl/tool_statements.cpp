#include "pentapost/cl/interpreter.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::cl {
namespace {

constexpr double highest_tool_number = 99'999'999.0;

std::optional<int> whole_number(double number) {
  if (!(number >= 0.0 && number <= highest_tool_number) || number != std::floor(number))
    return std::nullopt;
  return static_cast<int>(number);
}

std::optional<int> whole_number(std::optional<double> number) {
  return number ? whole_number(*number) : std::nullopt;
}

std::optional<int> length_register(const Words& words) {
  for (const std::string_view word : {"ADJUST", "OSETNO", "OFSTNO"})
    if (const auto number = whole_number(words.number_after(word))) return number;
  return std::nullopt;
}

std::optional<double> first_number(const Words& words) {
  for (const Word& word : words)
    if (word.is_number()) return word.number;
  return std::nullopt;
}

bool names_surface_speed(const Words& words) {
  return words.has("SFM") || words.has("SMM") || words.has("SURFAC") || words.has("CSS");
}

/// The speed among the words of a SPINDL: the first number that no other word claims.
std::optional<double> spindle_speed(const Words& words) {
  bool claimed = false;
  for (const Word& word : words) {
    if (word.is_number() && !claimed) return word.number;
    claimed = word.is("RANGE") || word.is("MAXRPM") || word.is("ORIENT") || word.is("RADIUS");
  }
  return std::nullopt;
}

}  // namespace

void Interpreter::change_tool(int number, std::optional<int> length_register_number) {
  path_.add_event(line_, path::ToolChange{number, length_register_number, tool_name_});
  path_.has_tool_change = true;
  loaded_tool_name_ = path_tool_name_;
  tool_name_.clear();
}

void Interpreter::load_tool(const Major& major) {
  words_.read(major.rest);
  const auto number = first_number(words_);
  const auto tool = whole_number(number);
  if (words_.size() > 0 && words_[0].kind == Word::Kind::quoted) tool_name_ = words_[0].text;
  if (!tool && (number || tool_name_.empty()))
    return report_damage(Severity::error, Code::damaged_statement, "a whole tool number");
  // "tool, pocket, length, register": Fusion.
  const bool has_four_numbers = dialect_.name == "fusion-apt" && words_.numbers().size() == 4;
  if (has_four_numbers) {
    const auto numbers = words_.numbers();
    change_tool(tool.value_or(0), whole_number(numbers[3]));
    return;
  }
  change_tool(tool.value_or(0), length_register(words_));
}

void Interpreter::load(const Major& major) {
  words_.read(major.rest);
  if (words_.size() == 0 || !words_[0].is("TOOL")) return without_effect(major);
  const auto number = first_number(words_);
  const auto tool = number ? whole_number(*number) : selected_tool_;
  if (!tool) return report_damage(Severity::error, Code::damaged_statement, "a whole tool number");
  if (tool_name_.empty()) tool_name_ = path_tool_name_;
  change_tool(*tool, length_register(words_));
}

void Interpreter::select(const Major& major) {
  words_.read(major.rest);
  if (words_.size() > 0 && words_[0].is("TOOL"))
    selected_tool_ = whole_number(first_number(words_));
}

void Interpreter::tool_path(const Major& major) {
  drop_arc();
  end_cycle();
  const std::string_view text = major.rest;
  const std::size_t name_end = std::min(text.find(','), text.size());
  path_.add_event(line_, path::Operation{std::string{trimmed(text.substr(0, name_end))}});
  path_tool_name_.clear();
  path_tool_line_ = line_;
  const std::string_view behind = trimmed(text.substr(std::min(name_end + 1, text.size())));
  const std::size_t comma = behind.find(',');
  if (comma != std::string_view::npos && same_word(trimmed(behind.substr(0, comma)), "TOOL"))
    path_tool_name_ = trimmed(behind.substr(comma + 1));
  if (dialect_.axis_resets) axis_ = Vec3::UnitZ();
  rapid_ = false;
  in_text_ = false;
}

void Interpreter::end_of_path(const Major&) {
  drop_arc();
  end_cycle();
  if (path_.has_tool_change && loaded_tool_name_ != path_tool_name_ && !path_tool_name_.empty()) {
    report_at(Severity::warning, Code::ignored_statement, path_tool_line_, [&] {
      return "The tool path is for the tool " + quoted_excerpt(path_tool_name_) +
             ", but no LOAD/TOOL changes to it.";
    });
  }
  rapid_ = false;
  in_text_ = dialect_.text_around;
}

void Interpreter::add_tool_data(std::optional<double> diameter, std::optional<double> corner_radius,
                                std::optional<double> length) {
  const auto in_mm = [&](std::optional<double> number) -> std::optional<double> {
    if (!number || !(*number >= 0.0)) return std::nullopt;
    return mm_ * *number;
  };
  path_.add_event(line_, path::ToolData{in_mm(diameter), in_mm(corner_radius), in_mm(length)});
}

/// CUTTER/diameter, corner radius, ... and TLDATA/kind, diameter, corner radius, length, ...
void Interpreter::cutter(const Major& major) {
  words_.read(major.rest);
  const auto numbers = words_.numbers();
  if (numbers.empty() || words_.has_damage())
    return report_damage(Severity::warning, Code::damaged_statement, "the diameter of the tool");
  const auto at = [&](std::size_t i) {
    return i < numbers.size() ? std::optional{numbers[i]} : std::nullopt;
  };
  const bool has_length = major.word() == "TLDATA";
  add_tool_data(at(0), at(1), has_length ? at(2) : std::nullopt);
}

void Interpreter::spindle(const Major& major) {
  using State = path::Spindle::State;
  words_.read(major.rest);
  if (words_.has_damage())
    return report_damage(Severity::warning, Code::damaged_statement, "speed and sense");
  const auto speed = spindle_speed(words_);
  const bool is_bare = words_.size() == 1 && (words_.has("ON") || words_.has("OFF"));
  if (is_bare && dialect_.bare_spindle_is_unclear)
    report(Severity::warning, Code::ignored_statement, [&] {
      return quoted_excerpt(statement_->text) +
             " is taken by its word, which writers of this dialect have exchanged: check where the "
             "spindle runs.";
    });
  if (words_.has("OFF") || words_.has("STOP") || speed == 0.0) {
    spindle_.state = State::off;
    path_.add_event(line_, path::Spindle{});
    return;
  }
  if (words_.has("ORIENT") || words_.has("LOCK") || words_.has("NEUTRL"))
    return without_effect(major);
  if (words_.has("CCLW") || words_.has("CCW")) last_direction_ = State::counterclockwise;
  if (words_.has("CLW") || words_.has("CW")) last_direction_ = State::clockwise;
  spindle_.state = last_direction_;
  if (speed && names_surface_speed(words_)) {
    report(Severity::warning, Code::ignored_statement, [&] {
      return quoted_excerpt(statement_->text) + " gives a surface speed, which was left out.";
    });
  } else if (speed) {
    constexpr double highest_rpm = 1e6;
    if (!(*speed > 0.0 && *speed <= highest_rpm))
      return report_damage(Severity::warning, Code::damaged_statement, "a speed from 0 to 1e6 rpm");
    spindle_.speed_rpm = *speed;
  }
  path_.add_event(line_, spindle_);
}

void Interpreter::check_feed_unit(const FeedUnit& unit, std::string_view word) {
  const auto expected = units_found_.stated ? units_ : units_found_.by_feed.value_or(units_);
  const auto line = units_found_.stated ? units_line_ : units_found_.feed_line;
  if (units_are_given_ || unit_conflict_reported_ || !unit.length || *unit.length == expected)
    return;
  unit_conflict_reported_ = true;
  report(Severity::warning, Code::unit_conflict, [&] {
    return "The feed unit " + quoted_excerpt(word) + " at CL line " + std::to_string(line_) +
           " contradicts the unit at CL line " + std::to_string(line) + ": lengths are read in " +
           std::string{name_of(units_)} + ", the feed in its own unit.";
  });
}

void Interpreter::feed(const Major& major) {
  words_.read(major.rest);
  std::optional<double> number;
  FeedUnit unit = feed_unit_;
  for (const Word& word : words_) {
    if (word.is_number() && !number) number = word.number;
    if (const auto named = feed_unit(word)) {
      unit = *named;
      check_feed_unit(unit, word.text);
    }
  }
  if (!number && words_.has("RAPID")) return rapid(major);
  if (words_.has("INVERS") || words_.has("FRN")) return without_effect(major);
  const double value = number.value_or(0.0) * mm_per(unit.length.value_or(units_));
  constexpr double highest_feed = 1e7;
  if (words_.has_damage() || !(value > 0.0 && value <= highest_feed))
    return report_damage(Severity::warning, Code::damaged_statement,
                         "a feed above 0 and its unit; the feed before it stays");
  feed_unit_ = unit;
  feed_is_known_ = true;
  using Unit = path::FeedRate::Unit;
  path_.add_event(
      line_, path::FeedRate{value, unit.per_revolution ? Unit::mm_per_revolution : Unit::mm_min});
}

void Interpreter::coolant(const Major& major) {
  using State = path::Coolant::State;
  words_.read(major.rest);
  State state = last_coolant_;
  if (words_.has("OFF"))
    state = State::off;
  else if (words_.has("MIST"))
    state = State::mist;
  else if (words_.has("THRU") || words_.has("THROUGH") || words_.has("TOOL"))
    state = State::through;
  else if (words_.has("AIR"))
    state = State::air;
  else if (words_.has("FLOOD") || words_.has("TAPKUL"))
    state = State::flood;
  if (state != State::off) last_coolant_ = state;
  path_.add_event(line_, path::Coolant{state});
}

}  // namespace pentapost::cl
