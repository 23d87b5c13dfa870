#include "pentapost/nc/dialect.hpp"
#include "pentapost/nc/lint.hpp"
#include "server/endpoints.hpp"
#include "server/json/json_writer.hpp"

#include <string>
#include <variant>
#include <vector>

namespace pentapost::server {
namespace {

struct OptionWriter {
  JsonWriter& writer;
  void operator()(bool value) const { writer.boolean(value); }
  void operator()(double value) const { writer.number(value); }
  void operator()(const std::string& value) const { writer.string(value); }
  void operator()(const std::vector<std::string>& lines) const {
    writer.begin_array();
    for (const auto& line : lines) writer.string(line);
    writer.end_array();
  }
};

void write_rules(JsonWriter& writer, const nc::Lint& lint) {
  writer.key("rules").begin_array();
  for (const auto& rule : lint.rules) {
    writer.begin_object();
    writer.key("name").string(rule.name);
    writer.key("description").string(rule.description);
    if (!rule.source.empty()) writer.key("source").string(rule.source);
    writer.end_object();
  }
  writer.end_array();
}

void write_dialect(JsonWriter& writer, const nc::Dialect& dialect) {
  writer.begin_object();
  writer.key("name").string(dialect.name);
  writer.key("title").string(dialect.title);
  writer.key("options").begin_array();
  for (const auto& option : dialect.options) {
    writer.begin_object();
    writer.key("name").string(option.name);
    writer.key("default");
    std::visit(OptionWriter{writer}, option.default_value);
    writer.key("description").string(option.description);
    writer.end_object();
  }
  writer.end_array();
  if (const auto* const lint = nc::find_lint(dialect.name)) write_rules(writer, *lint);
  writer.end_object();
}

}  // namespace

Result<Response> get_dialects(Call&) {
  Response response{.content_type = "application/json"};
  JsonWriter writer{response.body};
  writer.begin_object().key("dialects").begin_array();
  for (const auto* dialect : nc::dialects()) write_dialect(writer, *dialect);
  writer.end_array().end_object();
  return response;
}

}  // namespace pentapost::server
