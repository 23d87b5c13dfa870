#include "pentapost/cl/interpreter.hpp"

#include "pentapost/core/number_text.hpp"

#include <cmath>

namespace pentapost::cl {
namespace {

constexpr double longest_dwell_s = 86400.0;

/// Free text behind a major word, without the quotes around it.
std::string_view free_text(std::string_view text) {
  text = trimmed(text);
  const bool is_quoted = text.size() >= 2 && (text.front() == '\'' || text.front() == '"') &&
                         text.back() == text.front();
  return is_quoted ? trimmed(text.substr(1, text.size() - 2)) : text;
}

}  // namespace

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

void Interpreter::unit_statement(const Major& major) {
  if (units_are_given_) return;
  words_.read(major.rest);
  const auto unit = stated_unit(words_);
  if (!unit) return report_damage(Severity::error, Code::bad_unit, "MM or INCHES");
  if (*unit != units_) {
    report(Severity::warning, Code::unit_conflict, [&] {
      return "CL line " + std::to_string(line_) + " says " + std::string{name_of(*unit)} +
             ", CL line " + std::to_string(units_line_) + " said " + std::string{name_of(units_)} +
             ": what follows is read in " + std::string{name_of(*unit)} + ".";
    });
  }
  units_ = *unit;
  mm_ = mm_per(units_);
  units_line_ = line_;
}

void Interpreter::part_name(const Major& major) {
  const std::string_view name = free_text(major.rest);
  if (path_.program_name.empty()) path_.program_name = name;
}

void Interpreter::print(const Major& major) {
  const std::string_view text = free_text(major.rest);
  if (!text.empty() && !dialect_.pprint_is_data)
    path_.add_event(line_, path::Comment{std::string{text}});
}

void Interpreter::tool_name(const Major& major) { tool_name_ = free_text(major.rest); }

void Interpreter::insert(const Major& major) {
  std::string_view text = free_text(major.rest);
  while (!text.empty() && text.back() == '$') text = trimmed(text.substr(0, text.size() - 1));
  if (!text.empty()) path_.add_event(line_, path::InsertedText{std::string{text}});
}

/// AUXFUN/n is the word M n.
void Interpreter::auxiliary_function(const Major& major) {
  words_.read(major.rest);
  const bool is_one = words_.size() == 1 && words_[0].is_number();
  const double number = is_one ? words_[0].number : -1.0;
  if (!(number >= 0.0 && number <= 9999.0) || number != std::floor(number))
    return report_damage(Severity::warning, Code::damaged_statement,
                         "a whole number from 0 to 9999");
  path_.add_event(line_, path::InsertedText{"M" + number_text(number)});
}

void Interpreter::delay(const Major& major) {
  words_.read(major.rest);
  const bool is_one = words_.size() > 0 && words_[0].is_number();
  double time_s = is_one ? words_[0].number : 0.0;
  if (words_.has("REV")) {
    if (!(spindle_.speed_rpm.value_or(0.0) > 0.0))
      return report_damage(Severity::warning, Code::damaged_statement, "a spindle speed before it");
    time_s = time_s * 60.0 / *spindle_.speed_rpm;
  }
  if (!(time_s > 0.0 && time_s <= longest_dwell_s))
    return report_damage(Severity::warning, Code::damaged_statement, "a time from 0 to 86400 s");
  path_.add_event(line_, path::Dwell{time_s});
}

void Interpreter::stop(const Major&) { path_.add_event(line_, path::Stop{false}); }
void Interpreter::optional_stop(const Major&) { path_.add_event(line_, path::Stop{true}); }

void Interpreter::cutter_compensation(const Major& major) {
  words_.read(major.rest);
  if (!words_.has("OFF")) without_effect(major);
}

void Interpreter::without_effect(const Major&) {
  report(Severity::warning, Code::ignored_statement,
         [&] { return quoted_excerpt(statement_->text) + " has no effect here."; });
}

void Interpreter::silent(const Major&) {}

/// CATIA names operations in comments.
void Interpreter::comment(const Statement& statement) {
  const std::size_t colon = statement.text.find(':');
  if (colon == std::string_view::npos) return;
  if (!same_word(trimmed(statement.text.substr(0, colon)), "OPERATION NAME")) return;
  path_.add_event(line_, path::Operation{std::string{trimmed(statement.text.substr(colon + 1))}});
}

/// Creo's tool and feature are in comments; its points are in the coordinate system of CSYS
/// already.
void Interpreter::data_comment(const Statement& statement) {
  const Major major = read_major(statement.text);
  if (major.word() == "CUTTER") {
    cutter(major);
  } else if (major.word() == "FEATNO") {
    path_.add_event(line_, path::Operation{"FEATNO " + std::string{trimmed(major.rest)}});
    if (dialect_.axis_resets) axis_ = Vec3::UnitZ();
  }
}

}  // namespace pentapost::cl
