#include "pentapost/cl/interpreter.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace pentapost::cl {
namespace {

// Heidenhain's T ends here, Siemens' at 32000, and no magazine comes near: more is a slip.
constexpr int highest_tool_number = 32767;
constexpr int highest_length_register = 99'999'999;

/// The number words[i]; nullopt where it is none, not whole, out of range or has a word glued to
/// it.
std::optional<int> whole_number(const Words& words, std::size_t i, int lowest, int highest) {
  if (i >= words.size() || !words[i].is_number()) return std::nullopt;
  if (i + 1 < words.size() && words[i + 1].is_glued_to(words[i])) return std::nullopt;
  const double number = words[i].number;
  if (!(number >= lowest && number <= highest) || number != std::floor(number)) return std::nullopt;
  return static_cast<int>(number);
}

std::optional<int> tool_number(const Words& words, std::size_t i) {
  return whole_number(words, i, 1, highest_tool_number);
}

bool names_length_register(const Word& word) {
  return word.is("ADJUST") || word.is("OSETNO") || word.is("OFSTNO");
}

/// Where in a tool change the length register stands; 0: nowhere.
/// @param is_fourth  "tool, pocket, length, register" is a form of the dialect.
std::size_t place_of_length_register(const Words& words, bool is_fourth) {
  std::size_t numbers = 0, last_number = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (names_length_register(words[i])) return i + 1;
    if (!words[i].is_number()) continue;
    ++numbers;
    last_number = i;
  }
  return is_fourth && numbers == 4 ? last_number : 0;
}

bool names_surface_speed(const Words& words) {
  return words.has("SFM") || words.has("SMM") || words.has("SURFAC") || words.has("CSS");
}

constexpr std::array<MinorWord, 23> spindle_words{{{"ON"},
                                                   {"OFF"},
                                                   {"STOP"},
                                                   {"CLW"},
                                                   {"CW"},
                                                   {"CCLW"},
                                                   {"CCW"},
                                                   {"RPM"},
                                                   {"SFM"},
                                                   {"SMM"},
                                                   {"SURFAC"},
                                                   {"CSS"},
                                                   {"AUTO"},
                                                   {"LOW"},
                                                   {"MEDIUM"},
                                                   {"HIGH"},
                                                   {"LOCK"},
                                                   {"NEUTRL"},
                                                   {"ORIENT", Takes::number_if_there},
                                                   {"RANGE", Takes::number_or_gear},
                                                   {"MAXRPM", Takes::number},
                                                   {"RADIUS", Takes::number},
                                                   {"DIAMTR", Takes::number}}};

bool names_sense(const Words& words) {
  return words.has("CLW") || words.has("CW") || words.has("CCLW") || words.has("CCW");
}

/// True where a SPINDL only sets a gear or a limit and starts nothing.
bool is_spindle_setting(const Words& words) {
  if (words.has("ON") || words.has("RPM") || names_surface_speed(words) || names_sense(words))
    return false;
  for (const std::string_view word : {"RANGE", "MAXRPM", "AUTO", "LOW", "MEDIUM", "HIGH"})
    if (words.has(word)) return true;
  return false;
}

/// What is wrong with a SPINDL that starts the spindle; empty: nothing.
std::string start_fault(const Words& words, const FormMatch& form) {
  constexpr double highest_rpm = 1e6;
  const auto speed = form.number;
  if (speed && !(*speed > 0.0 && *speed <= highest_rpm)) return std::string{form.text};
  const bool clockwise = words.has("CLW") || words.has("CW");
  if (clockwise && (words.has("CCLW") || words.has("CCW"))) return "both senses";
  const bool names_mode = words.has("RPM") || names_surface_speed(words);
  const bool goes_on = words.has("ON") || (names_sense(words) && !names_mode);
  return speed || goes_on ? "" : "no speed";
}

// INVERS and the like are left out on purpose: such a feed cannot be had from its number alone.
constexpr std::array<MinorWord, 12> feed_words{{{"MMPM"},
                                                {"IPM"},
                                                {"MMPR"},
                                                {"IPR"},
                                                {"PERMIN"},
                                                {"PERREV"},
                                                {"RAPID"},
                                                {"RANGE", Takes::number_or_gear},
                                                {"RAPTO", Takes::number_if_there},
                                                {"MAXIPM", Takes::number},
                                                {"LOCK", Takes::on_or_off},
                                                {"ADJUST", Takes::on_or_off}}};

}  // namespace

void Interpreter::change_tool(int number, std::optional<int> length_register_number) {
  path_.add_event(line_, path::ToolChange{number, length_register_number, tool_name_});
  path_.has_tool_change = true;
  loaded_tool_name_ = path_tool_name_;
  tool_name_.clear();
}

/// Changes to the tool `number`, with the length register among the words.
void Interpreter::change_tool_as_written(std::optional<int> number) {
  if (!number || words_.has_damage())
    return report_damage(Severity::error, Code::damaged_statement,
                         "a whole tool number from 1 to " + std::to_string(highest_tool_number));
  const std::size_t at = place_of_length_register(words_, dialect_.name == "fusion-apt");
  const auto length_register = whole_number(words_, at, 0, highest_length_register);
  if (at > 0 && !length_register)
    return report_damage(Severity::error, Code::damaged_statement, "a whole length register");
  change_tool(*number, at > 0 ? length_register : std::nullopt);
}

void Interpreter::load_tool(const Major& major) {
  words_.read(major.rest);
  const bool has_name = words_.size() > 0 && words_[0].kind == Word::Kind::quoted;
  if (has_name) tool_name_ = words_[0].text;
  const bool is_second = has_name || (words_.size() > 0 && words_[0].is("TOOL"));
  change_tool_as_written(tool_number(words_, is_second ? 1 : 0));
}

void Interpreter::load(const Major& major) {
  words_.read(major.rest);
  if (words_.size() == 0 || !words_[0].is("TOOL")) return without_effect(major);
  if (tool_name_.empty()) tool_name_ = path_tool_name_;
  const bool is_as_selected = words_.size() == 1 || names_length_register(words_[1]);
  change_tool_as_written(is_as_selected ? selected_tool_ : tool_number(words_, 1));
}

void Interpreter::select(const Major& major) {
  words_.read(major.rest);
  if (words_.size() > 0 && words_[0].is("TOOL")) selected_tool_ = tool_number(words_, 1);
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
  const FormMatch form = match_form(words_, spindle_words);
  const auto refuse = [&](const std::string& found) {
    report_damage(Severity::error, Code::damaged_statement,
                  "a speed above 0 up to 1e6 rpm and CLW or CCLW, or OFF; found " + found);
  };
  if (!form.fault.empty()) return refuse(form.fault);
  if (words_.size() == 0) return refuse("nothing");
  const std::optional<double> speed = form.number;
  const bool is_bare = words_.size() == 1 && (words_.has("ON") || words_.has("OFF"));
  if (is_bare && dialect_.bare_spindle_is_unclear)
    report(Severity::warning, Code::ignored_statement, [&] {
      return quoted_excerpt(statement_->text) +
             " is taken by its word, which writers of this dialect have exchanged: check where the "
             "spindle runs.";
    });
  // "LOCK,ON" and "LOCK,OFF" are about the override.
  if (words_[0].is("LOCK")) return without_effect(major);
  if (words_.has("OFF") || words_.has("STOP") || speed == 0.0) {
    spindle_.state = State::off;
    path_.add_event(line_, path::Spindle{});
    return;
  }
  if (words_.has("ORIENT") || words_.has("LOCK") || words_.has("NEUTRL"))
    return without_effect(major);
  if (!speed && is_spindle_setting(words_)) return without_effect(major);
  if (const std::string fault = start_fault(words_, form); !fault.empty()) return refuse(fault);
  if (words_.has("CCLW") || words_.has("CCW")) last_direction_ = State::counterclockwise;
  if (words_.has("CLW") || words_.has("CW")) last_direction_ = State::clockwise;
  spindle_.state = last_direction_;
  if (speed && names_surface_speed(words_)) {
    report(Severity::warning, Code::ignored_statement, [&] {
      return quoted_excerpt(statement_->text) + " gives a surface speed, which was left out.";
    });
  } else if (speed) {
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

/// A feed in mm that was divided by 25.4, or one in inch that is called mm.
void Interpreter::check_low_feed(double feed_mm_min) {
  constexpr double lowest_usual_mm_min = 1.0;
  if (low_feed_reported_ || feed_mm_min >= lowest_usual_mm_min) return;
  low_feed_reported_ = true;
  report(Severity::warning, Code::unit_conflict, [&] {
    return quoted_excerpt(statement_->text) + " at CL line " + std::to_string(line_) +
           " is a feed of " + number_text(feed_mm_min, 6) +
           " mm/min, below 1 mm/min: check its unit. Further such feeds are not named.";
  });
}

/// A damaged feed is an error: the moves behind it would run with the feed before it.
void Interpreter::feed(const Major& major) {
  words_.read(major.rest);
  const FormMatch form = match_form(words_, feed_words);
  const auto refuse = [&](const std::string& found) {
    report_damage(Severity::error, Code::damaged_statement,
                  "a feed above 0 and its unit; found " + found);
  };
  if (!form.fault.empty()) return refuse(form.fault);
  const Word* unit_word = nullptr;
  FeedUnit unit = feed_unit_;
  for (const Word& word : words_) {
    const auto named = feed_unit(word);
    if (!named) continue;
    if (unit_word != nullptr) return refuse("a second unit, " + quoted_excerpt(word.text));
    unit_word = &word;
    unit = *named;
  }
  if (words_.has("RAPID")) return form.number ? refuse("RAPID with a feed") : rapid(major);
  if (!form.number) {
    const bool is_setting = words_.has("LOCK") || words_.has("MAXIPM") || words_.has("ADJUST");
    return is_setting ? without_effect(major) : refuse("no feed");
  }
  const double value = *form.number * mm_per(unit.length.value_or(units_));
  constexpr double highest_feed = 1e7;
  if (!(value > 0.0 && value <= highest_feed)) return refuse(std::string{form.text});
  if (unit_word != nullptr) check_feed_unit(unit, unit_word->text);
  if (!unit.per_revolution) check_low_feed(value);
  feed_unit_ = unit;
  feed_is_known_ = true;
  using Unit = path::FeedRate::Unit;
  path_.add_event(
      line_, path::FeedRate{value, unit.per_revolution ? Unit::mm_per_revolution : Unit::mm_min});
}

}  // namespace pentapost::cl
