#include "server/json/machine_list_json.hpp"

#include "server/json/json_writer.hpp"

namespace pentapost::server {
namespace {

void write_machine(JsonWriter& writer, const machine::Library& machines, const std::string& name) {
  const auto& definition = machines.find(name)->definition;
  writer.begin_object();
  writer.key("name").string(definition.name);
  writer.key("version").string(definition.version);
  writer.key("versions").begin_array();
  for (const auto& version : machines.versions(name)) writer.string(version);
  writer.end_array();
  writer.key("title").string(definition.title);
  writer.key("sha256").string(definition.sha256);
  writer.key("dialect").string(definition.controller.dialect);
  writer.end_object();
}

}  // namespace

std::string machine_list_json(const machine::Library& machines) {
  std::string text;
  JsonWriter writer{text};
  writer.begin_object().key("machines").begin_array();
  for (const auto& name : machines.names()) write_machine(writer, machines, name);
  writer.end_array().end_object();
  return text;
}

}  // namespace pentapost::server
