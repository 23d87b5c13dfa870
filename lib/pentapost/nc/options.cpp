#include "pentapost/nc/options.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pentapost::nc {
namespace {

constexpr std::size_t longest_line = 250;

const OptionRow* find_row(std::span<const OptionRow> rows, std::string_view name) {
  const auto row = std::ranges::find(rows, name, &OptionRow::name);
  return row == rows.end() ? nullptr : &*row;
}

std::string names_of(std::span<const OptionRow> rows) {
  std::string names;
  for (const OptionRow& row : rows) {
    if (!names.empty()) names += ", ";
    names += row.name;
  }
  return names;
}

bool is_printable(std::string_view line) {
  return line.size() <= longest_line &&
         std::ranges::all_of(line, [](char c) { return c >= ' ' && c <= '~'; });
}

std::string range_text(double lowest, double highest) {
  return "outside " + number_text(lowest, 6) + " to " + number_text(highest, 6);
}

/// The first "{word}" in `line` that is not among `known`; empty: there is none.
std::string_view unknown_placeholder(std::string_view line,
                                     std::initializer_list<std::string_view> known) {
  for (auto open = line.find('{'); open != std::string_view::npos;
       open = line.find('{', open + 1)) {
    const auto close = line.find('}', open);
    if (close == std::string_view::npos) return {};
    const auto placeholder = line.substr(open, close - open + 1);
    if (std::ranges::find(known, placeholder) == known.end()) return placeholder;
  }
  return {};
}

std::string unknown_placeholder_text(std::string_view found,
                                     std::initializer_list<std::string_view> known) {
  std::string text{found};
  text += " stands for nothing";
  for (const std::string_view placeholder : known)
    text.append(placeholder == *known.begin() ? "; known is " : ", ").append(placeholder);
  return text;
}

std::string pointer_to(std::string_view name) {
  std::string pointer = "/controller/options/";
  for (const char c : name) {
    if (c == '~')
      pointer += "~0";
    else if (c == '/')
      pointer += "~1";
    else
      pointer += c;
  }
  return pointer;
}

}  // namespace

OptionReader::OptionReader(std::span<const OptionRow> rows, const machine::Options& options)
    : rows_{rows}, options_{options} {
  for (const auto& [name, value] : options) {
    if (find_row(rows, name) == nullptr)
      refuse(name, "not known; this dialect has " + names_of(rows));
  }
}

void OptionReader::refuse(std::string_view name, const std::string& reason) {
  if (problem_) return;
  std::string message{"option "};
  message.append(name).append(": ").append(reason);
  problem_ = Problem{.code = Code::bad_option, .message = message, .pointer = pointer_to(name)};
}

template <class T>
const T& OptionReader::typed(std::string_view name, std::string_view type_name) {
  const OptionRow* const row = find_row(rows_, name);
  if (row == nullptr || !std::holds_alternative<T>(row->default_value))
    throw std::logic_error{"OptionReader: no row of this name and type"};
  const auto set = options_.find(std::string{name});
  if (set != options_.end()) {
    if (const T* const value = std::get_if<T>(&set->second)) return *value;
    refuse(name, std::string{"must be "}.append(type_name));
  }
  return std::get<T>(row->default_value);
}

bool OptionReader::flag(std::string_view name) { return typed<bool>(name, "true or false"); }

int OptionReader::whole(std::string_view name, int lowest, int highest) {
  const double given = typed<double>(name, "a number");
  if (!(given >= lowest && given <= highest)) {
    refuse(name, number_text(given, 6) + " is " + range_text(lowest, highest));
    return lowest;
  }
  if (given != std::trunc(given)) refuse(name, number_text(given, 6) + " is not a whole number");
  return static_cast<int>(given);
}

double OptionReader::number(std::string_view name, double lowest, double highest) {
  const double given = typed<double>(name, "a number");
  if (given >= lowest && given <= highest) return given;
  refuse(name, number_text(given, 6) + " is " + range_text(lowest, highest));
  return lowest;
}

std::string OptionReader::text(std::string_view name) {
  const std::string& given = typed<std::string>(name, "a string");
  if (!is_printable(given))
    refuse(name, "must be one line of up to 250 printable ASCII characters");
  return given;
}

std::vector<std::string> OptionReader::lines(std::string_view name,
                                             std::initializer_list<std::string_view> placeholders) {
  const auto& given = typed<std::vector<std::string>>(name, "a list of strings");
  for (const std::string& line : given) {
    if (line.empty() || !is_printable(line))
      refuse(name, "each string must be one line of 1 to 250 printable ASCII characters");
    const auto unknown = unknown_placeholder(line, placeholders);
    if (!unknown.empty()) refuse(name, unknown_placeholder_text(unknown, placeholders));
  }
  return given;
}

}  // namespace pentapost::nc
