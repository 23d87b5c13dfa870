#include "pentapost/jobs/unproven.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pentapost::jobs {
namespace {

/// A code for a coolant that the dialect has none for.
constexpr std::string_view harmless_code = "M8";

/// The dialect's own text for an option that is text of the program; nullopt: it is none.
std::optional<machine::OptionValue> own_text(const nc::OptionRow& row) {
  if (std::holds_alternative<std::vector<std::string>>(row.default_value)) return row.default_value;
  if (!row.name.starts_with("coolant_")) return std::nullopt;
  const auto& code = std::get<std::string>(row.default_value);
  return code.empty() ? std::string{harmless_code} : code;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

/// The Problem of options whose text keeps a program from being proven; nullopt: it does not.
std::optional<Problem> unproven_options(const Problem& problem, const nc::Dialect& dialect,
                                        machine::Options options, const OptionsTrial& passes) {
  std::vector<std::string> changed;
  for (const nc::OptionRow& row : dialect.options) {
    const auto given = options.find(std::string{row.name});
    const auto own = own_text(row);
    if (!own || given == options.end() || given->second == row.default_value) continue;
    changed.push_back(given->first);
    given->second = *own;
  }
  if (changed.empty() || !passes(options)) return std::nullopt;
  return Problem{.code = Code::not_in_dialect,
                 .message = "the program with the text of controller.options (" + joined(changed) +
                            ") cannot be proven: " + problem.message,
                 .pointer = "/machine/controller/options" +
                            (changed.size() == 1 ? "/" + changed.front() : std::string{})};
}

}  // namespace

Problem unproven(Problem problem, const nc::Dialect& dialect, const machine::Options& options,
                 const path::ToolPath& tool_path, const OptionsTrial& passes) {
  if (auto fault = unproven_options(problem, dialect, options, passes)) return *std::move(fault);
  for (const path::Event& event : tool_path.events) {
    if (!std::holds_alternative<path::InsertedText>(event.what)) continue;
    return {.code = Code::not_in_dialect,
            .message = "the program with the text that the CL data insert (first at CL line " +
                       std::to_string(event.cl_line) + ") cannot be proven: " + problem.message,
            .cl_line = event.cl_line};
  }
  return problem;
}

}  // namespace pentapost::jobs
