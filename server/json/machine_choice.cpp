#include "server/json/machine_choice.hpp"

#include "pentapost/jobs/compare.hpp"
#include "pentapost/json/definition_json.hpp"

#include <string>
#include <utility>

namespace pentapost::server {
namespace {

using json::Object;
using machine::Definition;

std::string pointer_to(std::size_t index) { return "/machines/" + std::to_string(index); }

std::string_view trimmed(std::string_view name) {
  while (name.starts_with(' ')) name.remove_prefix(1);
  while (name.ends_with(' ')) name.remove_suffix(1);
  return name;
}

}  // namespace

std::optional<Definition> MachineChoice::named(std::string_view name,
                                               std::string_view pointer) const {
  const auto entry = find_machine(context_.machines, name);
  if (entry) return (*entry)->definition;
  source_.fail(entry.error().code, pointer, entry.error().message);
  return std::nullopt;
}

std::optional<Definition> MachineChoice::read(const json::Value& value) const {
  if (value.is_object()) {
    auto definition = json::definition_from_text(value.object().text_in(text_), context_.dialects,
                                                 value.pointer());
    if (definition) return std::move(definition).value();
    source_.fail(std::move(definition).error());
    return std::nullopt;
  }
  if (source_.first_problem()) return std::nullopt;
  if (!value.is_string())
    value.fail(Code::wrong_type,
               "expected a string, name or name@version, or an object, a definition");
  const std::string name = value.string();
  if (source_.first_problem()) return std::nullopt;
  return named(name, value.pointer());
}

std::vector<Definition> MachineChoice::one(const Object& job) const {
  const auto* const word = source_.word("machine", job, "machine");
  auto machine = word != nullptr ? named(*word, "/machine") : read(job.value("machine"));
  std::vector<Definition> machines;
  if (machine) machines.push_back(std::move(*machine));
  return machines;
}

std::vector<Definition> MachineChoice::several(const Object& job) const {
  const bool has_word = source_.word("machine", job, "machine") != nullptr;
  if (job.optional_value("machine") || has_word)
    source_.fail(Code::conflicting_keys, "/machine",
                 "a comparison is of machines, a list; leave both out for all");
  const auto* const names = source_.word("machines", job, "machines");
  const auto machines = job.optional_value("machines");
  if (source_.first_problem()) return {};
  if (names != nullptr) return listed(*names);
  return machines ? read_all(machines->array()) : all();
}

std::vector<Definition> MachineChoice::listed(std::string_view names) const {
  std::vector<Definition> machines;
  for (bool last = false; !last && !source_.first_problem();) {
    const auto comma = names.find(',');
    last = comma == std::string_view::npos;
    const std::size_t index = machines.size();
    if (index == jobs::CompareJob::most_machines) {
      source_.fail(Code::out_of_domain, "/machines", "there are too many machines");
      break;
    }
    auto machine = named(trimmed(names.substr(0, comma)), pointer_to(index));
    if (machine) machines.push_back(std::move(*machine));
    if (!last) names.remove_prefix(comma + 1);
  }
  return machines;
}

std::vector<Definition> MachineChoice::read_all(const json::Array& list) const {
  std::vector<Definition> machines;
  const auto most = jobs::CompareJob::most_machines;
  if (!source_.first_problem() && (list.size() == 0 || list.size() > most))
    list.fail(Code::out_of_domain, "found " + std::to_string(list.size()) +
                                       " machines, expected 1 to " + std::to_string(most));
  for (std::size_t i = 0; i < list.size() && !source_.first_problem(); ++i)
    if (auto machine = read(list.at(i))) machines.push_back(std::move(*machine));
  return machines;
}

std::vector<Definition> MachineChoice::all() const {
  std::vector<Definition> machines;
  for (const auto& name : context_.machines.names())
    machines.push_back(context_.machines.find(name)->definition);
  if (machines.empty())
    source_.fail(Code::out_of_domain, "/machines", "the library has no machine");
  return machines;
}

}  // namespace pentapost::server
