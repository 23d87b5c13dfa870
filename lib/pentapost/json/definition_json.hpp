#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/machine/definition.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace pentapost::json {

/// A definition's text may have this many bytes; more is a Problem too_large.
inline constexpr std::size_t max_definition_bytes = 1 << 20;

/// The machine that a definition describes (machines/README.md).
///
/// Checks, in this order: JSON, the schema (api/schemas/machine.schema.json), meaning: directions
/// of unit length (off by 1e-6 at most, and normalised), a chain that closes, three linear axes
/// that span space, ranges, a known dialect. Degrees become radians.
///
/// @param text  a file's bytes, or those of an inline definition (Object::text_in); its sha256 is
///              the definition's.
/// @param dialects  names that controller.dialect may have.
/// @param pointer_prefix  goes before the JSON pointer of a Problem: where an inline definition is.
/// @return Problem with code bad_json, bad_number, too_large, definition_schema, chain_shape,
///         definition_meaning or unknown_dialect, with its JSON pointer.
Result<machine::Definition> definition_from_text(std::string_view text,
                                                 std::span<const std::string_view> dialects,
                                                 std::string_view pointer_prefix = "");

}  // namespace pentapost::json
