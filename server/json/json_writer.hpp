#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::server {

/// Appends `text` as a JSON string. Bytes that are not UTF-8 become U+FFFD, one each.
void append_json_string(std::string& out, std::string_view text);

/// Writes JSON in the order of the calls. Numbers read back as the same double.
class JsonWriter {
 public:
  explicit JsonWriter(std::string& out) : out_{out} {}

  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }
  JsonWriter& key(std::string_view name);
  JsonWriter& string(std::string_view text);
  /// Throws std::logic_error where `number` is not finite.
  JsonWriter& number(double number);
  JsonWriter& integer(std::uint64_t number);
  JsonWriter& boolean(bool value);
  JsonWriter& null();
  /// JSON text as it is.
  JsonWriter& raw(std::string_view json);

 private:
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  void separate();

  std::string& out_;
  bool needs_comma_ = false;
};

/// The number; null: there is none.
void write_number(JsonWriter& writer, const std::optional<double>& number);
void write_numbers(JsonWriter& writer, const std::vector<double>& numbers);
void write_numbers(JsonWriter& writer, const std::vector<std::optional<double>>& numbers);

}  // namespace pentapost::server
