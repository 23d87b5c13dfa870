#include "server/json/problem_json.hpp"

#include <array>
#include <cstddef>

namespace pentapost::server {
namespace {

struct StatusRow {
  Code code;
  int status;
};

// What a code is answered with when it is the reason for a refusal. Codes that are remarks only
// have the status that a caller's mistake has.
constexpr std::array status_rows{
    StatusRow{Code::damaged_motion, 400},
    StatusRow{Code::damaged_statement, 400},
    StatusRow{Code::bad_number, 400},
    StatusRow{Code::zero_tool_axis, 400},
    StatusRow{Code::axis_not_unit, 400},
    StatusRow{Code::no_motion, 400},
    StatusRow{Code::no_feed, 400},
    StatusRow{Code::unknown_statement, 400},
    StatusRow{Code::ignored_statement, 400},
    StatusRow{Code::unit_assumed, 400},
    StatusRow{Code::unit_conflict, 400},
    StatusRow{Code::bad_unit, 400},
    StatusRow{Code::bad_arc, 400},
    StatusRow{Code::arc_sense_assumed, 400},
    StatusRow{Code::bad_cycle, 400},
    StatusRow{Code::cycle_expanded, 400},
    StatusRow{Code::bad_nurbs, 400},
    StatusRow{Code::nurbs_linearised, 400},
    StatusRow{Code::feed_per_revolution, 400},
    StatusRow{Code::spindle_off, 400},
    StatusRow{Code::too_large, 400},
    StatusRow{Code::damaged_block, 400},
    StatusRow{Code::feed_rule_assumed, 400},
    StatusRow{Code::position_unknown, 400},
    StatusRow{Code::bad_json, 400},
    StatusRow{Code::bad_form, 400},
    StatusRow{Code::unknown_key, 400},
    StatusRow{Code::missing_key, 400},
    StatusRow{Code::wrong_type, 400},
    StatusRow{Code::out_of_domain, 400},
    StatusRow{Code::conflicting_keys, 400},
    StatusRow{Code::unknown_machine, 404},
    StatusRow{Code::unknown_version, 404},
    StatusRow{Code::unknown_dialect, 422},
    StatusRow{Code::definition_schema, 422},
    StatusRow{Code::chain_shape, 422},
    StatusRow{Code::definition_meaning, 422},
    StatusRow{Code::out_of_reach, 422},
    StatusRow{Code::rotary_range, 422},
    StatusRow{Code::linear_range, 422},
    StatusRow{Code::linear_singular, 422},
    StatusRow{Code::half_turn, 422},
    StatusRow{Code::gauge_length_missing, 422},
    StatusRow{Code::gauge_length_assumed, 422},
    StatusRow{Code::linear_range_unchecked, 422},
    StatusRow{Code::origin_assumed, 422},
    StatusRow{Code::origin_missing, 422},
    StatusRow{Code::clearance_unchecked, 422},
    StatusRow{Code::clearance_coarse, 422},
    StatusRow{Code::not_reorientable, 422},
    StatusRow{Code::no_speed_limit, 422},
    StatusRow{Code::tolerance_below_digits, 422},
    StatusRow{Code::no_rotary_feed, 422},
    StatusRow{Code::bad_option, 422},
    StatusRow{Code::unsupported_output, 422},
    StatusRow{Code::not_in_dialect, 422},
    StatusRow{Code::retract_inserted, 422},
    StatusRow{Code::pole_turned, 422},
    StatusRow{Code::proof_failed, 500},
    StatusRow{Code::defect, 500},
    StatusRow{Code::bad_request, 400},
    StatusRow{Code::not_found, 404},
    StatusRow{Code::method_not_allowed, 405},
    StatusRow{Code::not_acceptable, 406},
    StatusRow{Code::unsupported_media_type, 415},
    StatusRow{Code::body_too_large, 413},
    StatusRow{Code::overloaded, 503},
    StatusRow{Code::head_too_large, 431},
    StatusRow{Code::too_slow, 408},
};

constexpr bool status_rows_are_complete() {
  if (status_rows.size() != static_cast<std::size_t>(Code::count_)) return false;
  for (std::size_t i = 0; i < status_rows.size(); ++i)
    if (status_rows[i].code != static_cast<Code>(i)) return false;
  return true;
}
static_assert(status_rows_are_complete(), "one row a code, in the order of the enumeration");

constexpr std::size_t most_diagnostics = 100;

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::error:
      return "error";
    case Severity::warning:
      return "warning";
    case Severity::info:
      break;
  }
  return "info";
}

void write_diagnostic(JsonWriter& writer, const Diagnostic& diagnostic) {
  writer.begin_object();
  writer.key("severity").string(name_of(diagnostic.severity));
  writer.key("code").string(row_of(diagnostic.code).name);
  if (diagnostic.cl_line > 0) writer.key("cl_line").integer(diagnostic.cl_line);
  writer.key("message").string(diagnostic.message);
  writer.end_object();
}

/// The diagnostics of a Problem; where it has none, itself.
Diagnostics diagnostics_of(const Problem& problem) {
  if (problem.diagnostics.total() > 0) return problem.diagnostics;
  Diagnostics diagnostics;
  diagnostics.add({.severity = Severity::error,
                   .code = problem.code,
                   .cl_line = problem.cl_line.value_or(0),
                   .message = problem.message});
  return diagnostics;
}

}  // namespace

int status_of(Code code) { return status_rows[static_cast<std::size_t>(code)].status; }

void write_diagnostics(JsonWriter& writer, const Diagnostics& diagnostics) {
  writer.key("diagnostics").begin_array();
  std::size_t written = 0;
  for (const auto severity : {Severity::error, Severity::warning, Severity::info}) {
    for (const auto& diagnostic : diagnostics.list()) {
      if (diagnostic.severity != severity || written == most_diagnostics) continue;
      write_diagnostic(writer, diagnostic);
      ++written;
    }
  }
  writer.end_array();
  writer.key("diagnostics_total").integer(diagnostics.total());
}

Response problem_response(const Problem& problem, std::string_view request_id) {
  const auto& row = row_of(problem.code);
  Response response{.status = status_of(problem.code),
                    .content_type = std::string{problem_media_type}};
  JsonWriter writer{response.body};
  writer.begin_object();
  writer.key("type").string("urn:pentapost:problem:" + std::string{row.name});
  writer.key("title").string(row.title);
  writer.key("status").integer(static_cast<std::uint64_t>(response.status));
  writer.key("detail").string(problem.message);
  writer.key("code").string(row.name);
  // A value of the wrong type has a place always: "" is the whole document.
  if (!problem.pointer.empty() || problem.code == Code::wrong_type)
    writer.key("pointer").string(problem.pointer);
  if (problem.cl_line) writer.key("cl_line").integer(*problem.cl_line);
  writer.key("request_id").string(request_id);
  write_diagnostics(writer, diagnostics_of(problem));
  writer.end_object();
  if (problem.code == Code::overloaded) response.headers.emplace_back("Retry-After", "1");
  return response;
}

}  // namespace pentapost::server
