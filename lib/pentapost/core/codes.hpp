#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace pentapost {

/// What went wrong, or deserves a word. Names are stable for callers; api/errors.md explains each.
enum class Code {
  // CL data
  damaged_motion,
  damaged_statement,
  bad_number,
  zero_tool_axis,
  axis_not_unit,
  no_motion,
  no_feed,
  unknown_statement,
  ignored_statement,
  unit_assumed,
  unit_conflict,
  bad_unit,
  bad_arc,
  arc_sense_assumed,
  bad_cycle,
  cycle_expanded,
  bad_nurbs,
  nurbs_linearised,
  feed_per_revolution,
  spindle_off,
  too_large,
  // NC programs that are analysed
  damaged_block,
  feed_rule_assumed,
  position_unknown,
  // the request
  bad_json,
  bad_form,
  unknown_key,
  missing_key,
  wrong_type,
  out_of_domain,
  conflicting_keys,
  unknown_machine,
  unknown_version,
  unknown_dialect,
  // machine definitions
  definition_schema,
  chain_shape,
  definition_meaning,
  // what this machine can't do
  out_of_reach,
  rotary_range,
  linear_range,
  linear_singular,
  half_turn,
  gauge_length_missing,
  gauge_length_assumed,
  linear_range_unchecked,
  origin_assumed,
  origin_missing,
  clearance_unchecked,
  clearance_coarse,
  not_reorientable,
  no_speed_limit,
  tolerance_below_digits,
  no_rotary_feed,
  bad_option,
  unsupported_output,
  not_in_dialect,
  retract_inserted,
  pole_turned,
  // our own
  proof_failed,
  defect,
  // HTTP
  bad_request,
  not_found,
  method_not_allowed,
  not_acceptable,
  unsupported_media_type,
  body_too_large,
  overloaded,
  head_too_large,
  too_slow,
  count_  ///< number of codes, not one of them
};

struct CodeRow {
  Code code;
  std::string_view name;   ///< as in `type` and `diagnostics[].code`
  std::string_view title;  ///< short, the same for every occurrence
};

inline constexpr std::array code_rows{
    CodeRow{Code::damaged_motion, "damaged_motion", "A motion statement of the CL data is damaged"},
    CodeRow{Code::damaged_statement, "damaged_statement", "A statement of the CL data is damaged"},
    CodeRow{Code::bad_number, "bad_number", "A number is not finite or not readable"},
    CodeRow{Code::zero_tool_axis, "zero_tool_axis", "A tool axis vector has no direction"},
    CodeRow{Code::axis_not_unit, "axis_not_unit", "A tool axis vector is not of unit length"},
    CodeRow{Code::no_motion, "no_motion", "The text holds no motion"},
    CodeRow{Code::no_feed, "no_feed", "A cutting motion has no feed"},
    CodeRow{Code::unknown_statement, "unknown_statement",
            "A statement is not known and was left out"},
    CodeRow{Code::ignored_statement, "ignored_statement", "A statement has no effect here"},
    CodeRow{Code::unit_assumed, "unit_assumed", "The unit of length was assumed"},
    CodeRow{Code::unit_conflict, "unit_conflict", "Statements disagree about the unit of length"},
    CodeRow{Code::bad_unit, "bad_unit", "A unit is not known"},
    CodeRow{Code::bad_arc, "bad_arc", "An arc is not possible"},
    CodeRow{Code::arc_sense_assumed, "arc_sense_assumed",
            "The sense of an arc was taken from its neighbours"},
    CodeRow{Code::bad_cycle, "bad_cycle", "A drilling cycle is incomplete"},
    CodeRow{Code::cycle_expanded, "cycle_expanded", "A cycle was written as single moves"},
    CodeRow{Code::bad_nurbs, "bad_nurbs", "A NURBS block is damaged"},
    CodeRow{Code::nurbs_linearised, "nurbs_linearised",
            "A NURBS curve was divided into straight moves"},
    CodeRow{Code::feed_per_revolution, "feed_per_revolution",
            "A feed per revolution needs a spindle speed"},
    CodeRow{Code::spindle_off, "spindle_off", "A tool cuts with the spindle off"},
    CodeRow{Code::too_large, "too_large", "A part of the input is larger than the limit"},
    CodeRow{Code::damaged_block, "damaged_block", "A block of the NC program is not understood"},
    CodeRow{Code::feed_rule_assumed, "feed_rule_assumed", "The meaning of a feed was assumed"},
    CodeRow{Code::position_unknown, "position_unknown", "A feed move leads to an unknown place"},
    CodeRow{Code::bad_json, "bad_json", "The body is not valid JSON"},
    CodeRow{Code::bad_form, "bad_form", "The body is not a valid form"},
    CodeRow{Code::unknown_key, "unknown_key", "A key is not known"},
    CodeRow{Code::missing_key, "missing_key", "A required key is missing"},
    CodeRow{Code::wrong_type, "wrong_type", "A value has the wrong type"},
    CodeRow{Code::out_of_domain, "out_of_domain", "A value is outside its domain"},
    CodeRow{Code::conflicting_keys, "conflicting_keys", "Keys exclude each other"},
    CodeRow{Code::unknown_machine, "unknown_machine", "No such machine"},
    CodeRow{Code::unknown_version, "unknown_version", "No such version of the machine"},
    CodeRow{Code::unknown_dialect, "unknown_dialect", "No such dialect"},
    CodeRow{Code::definition_schema, "definition_schema",
            "A machine definition does not fit its schema"},
    CodeRow{Code::chain_shape, "chain_shape", "A kinematic chain is not usable"},
    CodeRow{Code::definition_meaning, "definition_meaning",
            "A machine definition contradicts itself"},
    CodeRow{Code::out_of_reach, "out_of_reach", "The machine cannot reach a tool axis"},
    CodeRow{Code::rotary_range, "rotary_range", "A rotary axis leaves its range"},
    CodeRow{Code::linear_range, "linear_range", "A linear axis leaves its range"},
    CodeRow{Code::linear_singular, "linear_singular",
            "The linear axes do not span space in a posture"},
    CodeRow{Code::half_turn, "half_turn", "The tool axis turns by about 180 degrees in one move"},
    CodeRow{Code::gauge_length_missing, "gauge_length_missing",
            "The gauge length of a tool is needed"},
    CodeRow{Code::gauge_length_assumed, "gauge_length_assumed",
            "A gauge length of zero was assumed"},
    CodeRow{Code::linear_range_unchecked, "linear_range_unchecked",
            "Linear ranges were not checked"},
    CodeRow{Code::origin_assumed, "origin_assumed", "The place of the workpiece was assumed"},
    CodeRow{Code::origin_missing, "origin_missing", "The place of the workpiece is needed"},
    CodeRow{Code::clearance_unchecked, "clearance_unchecked", "Collisions were not checked"},
    CodeRow{Code::clearance_coarse, "clearance_coarse", "The check for collisions is a coarse one"},
    CodeRow{Code::not_reorientable, "not_reorientable",
            "A path can be reoriented for two rotary axes only"},
    CodeRow{Code::no_speed_limit, "no_speed_limit", "No axis has a speed limit to measure by"},
    CodeRow{Code::tolerance_below_digits, "tolerance_below_digits",
            "A tolerance is finer than the digits printed"},
    CodeRow{Code::no_rotary_feed, "no_rotary_feed", "A feed for turning in place is not known"},
    CodeRow{Code::bad_option, "bad_option", "An option of the dialect is not usable"},
    CodeRow{Code::unsupported_output, "unsupported_output",
            "The dialect does not offer this output"},
    CodeRow{Code::not_in_dialect, "not_in_dialect", "The dialect has no word for this"},
    CodeRow{Code::retract_inserted, "retract_inserted", "A retract was inserted"},
    CodeRow{Code::pole_turned, "pole_turned",
            "A rotary axis turns while the tool axis is at the pole"},
    CodeRow{Code::proof_failed, "proof_failed", "The NC program failed its proof"},
    CodeRow{Code::defect, "defect", "The service has a defect"},
    CodeRow{Code::bad_request, "bad_request", "The request is malformed"},
    CodeRow{Code::not_found, "not_found", "No such resource"},
    CodeRow{Code::method_not_allowed, "method_not_allowed", "The method is not allowed here"},
    CodeRow{Code::not_acceptable, "not_acceptable", "No acceptable media type"},
    CodeRow{Code::unsupported_media_type, "unsupported_media_type",
            "The content type is not supported"},
    CodeRow{Code::body_too_large, "body_too_large", "The body is over the limit"},
    CodeRow{Code::overloaded, "overloaded", "More work than the bound is under way"},
    CodeRow{Code::head_too_large, "head_too_large", "The request's head is over the limit"},
    CodeRow{Code::too_slow, "too_slow", "The request did not arrive in time"},
};

constexpr bool code_rows_are_complete() {
  if (code_rows.size() != static_cast<std::size_t>(Code::count_)) return false;
  for (std::size_t i = 0; i < code_rows.size(); ++i)
    if (code_rows[i].code != static_cast<Code>(i)) return false;
  return true;
}
static_assert(code_rows_are_complete(), "one row a code, in the order of the enumeration");

constexpr const CodeRow& row_of(Code code) { return code_rows[static_cast<std::size_t>(code)]; }

}  // namespace pentapost
