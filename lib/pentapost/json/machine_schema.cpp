// The only file that includes valijson, which takes 20 s to compile.
#define VALIJSON_USE_EXCEPTIONS 1
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wrestrict"  // false alarm of g++ 12 in std::string (bug 105651)
#endif

#include "pentapost/json/machine_schema.hpp"

#include "pentapost/json/strict_reader.hpp"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pentapost::json {
namespace {

constexpr std::size_t longest_quote = 60;  ///< bytes of a found value in a message

using Error = valijson::ValidationResults::Error;

/// JSON pointer of a context, which is "<root>", "[axes]", "[X]", "[0]".
std::string pointer_of(const std::vector<std::string>& context) {
  std::string pointer;
  for (std::size_t i = 1; i < context.size(); ++i) {
    const auto& step = context[i];
    pointer += pointer_step(std::string_view{step}.substr(1, step.size() - 2));
  }
  return pointer;
}

/// The key that additionalProperties refused, which valijson names in its description alone.
std::optional<std::string> unknown_key_in(std::string_view description) {
  constexpr std::string_view before_key = "'additionalProperties' constraints: '";
  constexpr std::string_view behind_key = "'.";
  const auto found = description.find(before_key);
  if (found == std::string_view::npos || !description.ends_with(behind_key)) return std::nullopt;
  description.remove_prefix(found + before_key.size());
  description.remove_suffix(behind_key.size());
  return std::string{description};
}

/// The error with the longest context: the cause; those around it only follow from it.
Error innermost(const valijson::ValidationResults& results) {
  Error innermost = *results.begin();
  for (const auto& error : results)
    if (error.context.size() > innermost.context.size()) innermost = error;
  return innermost;
}

std::string found_at(const nlohmann::json& definition, const std::string& pointer) {
  const auto& value = definition.at(nlohmann::json::json_pointer{pointer});
  if (value.is_object()) return "an object";
  std::string text = value.dump(-1, ' ', true);
  if (text.size() <= longest_quote) return text;
  return value.is_array() ? "an array" : "a string of " + std::to_string(text.size()) + " bytes";
}

}  // namespace

Status check_machine_schema(std::string_view text) {
  const auto schema_json = nlohmann::json::parse(machine_schema_text());
  valijson::Schema schema;
  valijson::SchemaParser parser{valijson::SchemaParser::kDraft7};
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter{schema_json}, schema);

  const auto definition = nlohmann::json::parse(text);
  const valijson::adapters::NlohmannJsonAdapter target{definition};
  valijson::Validator validator;
  valijson::ValidationResults results;
  if (validator.validate(schema, target, &results)) return ok();
  const Error cause = innermost(results);
  std::string pointer = pointer_of(cause.context);
  if (const auto key = unknown_key_in(cause.description))
    return Problem{.code = Code::definition_schema,
                   .message = "does not fit the schema: the key is not known here",
                   .pointer = pointer + pointer_step(*key)};
  std::string message =
      "does not fit the schema: " + cause.description + " Found " + found_at(definition, pointer);
  return Problem{.code = Code::definition_schema,
                 .message = std::move(message),
                 .pointer = std::move(pointer)};
}

}  // namespace pentapost::json
