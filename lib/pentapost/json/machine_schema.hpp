#pragma once

#include "pentapost/core/result.hpp"

#include <string_view>

namespace pentapost::json {

/// Bytes of api/schemas/machine.schema.json, as of the build.
std::string_view machine_schema_text();

/// Holds a definition's text against the schema.
///
/// @param text  JSON that Document::parse accepts, with `name` and `version` of at most 2000 bytes
///              (regular expressions of the standard library need stack for every letter).
/// @return Problem definition_schema with the JSON pointer of the innermost value that does not
/// fit.
Status check_machine_schema(std::string_view text);

}  // namespace pentapost::json
