#include "pentapost/json/definition_json.hpp"

#include "pentapost/core/sha256.hpp"
#include "pentapost/json/clearance_json.hpp"
#include "pentapost/json/direction.hpp"
#include "pentapost/json/machine_schema.hpp"
#include "pentapost/json/strict_reader.hpp"
#include "pentapost/machine/near_names.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pentapost::json {
namespace {

using machine::Joint;

constexpr std::size_t longest_matched_text = 2000;  ///< see check_machine_schema()
constexpr std::string_view linear_letters = "XYZUVW";
constexpr std::string_view rotary_letters = "ABC";

std::optional<Range<Angle>> angle_range_of(const Object& object, std::string_view key) {
  const auto range_deg = object.optional_range(key, Code::definition_meaning);
  if (!range_deg) return std::nullopt;
  return Range<Angle>{Angle::degrees(range_deg->lower), Angle::degrees(range_deg->upper)};
}

struct Axis {
  Joint joint;
  machine::AxisLimits limits;
};

Axis read_linear_axis(const std::string& name, const Object& object) {
  Axis axis{.joint = {name,
                      machine::LinearJoint{
                          .direction = direction_of(object, "direction", Code::definition_meaning),
                          .range_mm = object.optional_range("range_mm", Code::definition_meaning)}},
            .limits = {}};
  const auto limit = Domain::positive();
  axis.limits.max_speed = object.optional_number("max_speed_mm_s", limit);
  axis.limits.max_acceleration = object.optional_number("max_acceleration_mm_s2", limit);
  axis.limits.max_jerk = object.optional_number("max_jerk_mm_s3", limit);
  return axis;
}

Axis read_rotary_axis(const std::string& name, const Object& object) {
  Axis axis{.joint = {name, machine::RotaryJoint{.direction = direction_of(
                                                     object, "direction", Code::definition_meaning),
                                                 .point_mm = object.vector3("point_mm"),
                                                 .range = angle_range_of(object, "range_deg")}},
            .limits = {}};
  const auto limit_rad = [&](std::string_view key) -> std::optional<double> {
    const auto limit_deg = object.optional_number(key, Domain::positive());
    return limit_deg ? std::optional{*limit_deg * rad_per_deg} : std::nullopt;
  };
  axis.limits.max_speed = limit_rad("max_speed_deg_s");
  axis.limits.max_acceleration = limit_rad("max_acceleration_deg_s2");
  axis.limits.max_jerk = limit_rad("max_jerk_deg_s3");
  return axis;
}

std::map<std::string, Axis> read_axes(const Object& axes) {
  constexpr std::array<std::string_view, 2> types{"linear", "rotary"};
  std::map<std::string, Axis> read;
  for (const auto& name : axes.keys()) {
    const Object object = axes.object(name);
    const bool rotary = object.choice("type", types) == 1;
    const auto letters = rotary ? rotary_letters : linear_letters;
    if (name.size() != 1 || letters.find(name.front()) == std::string_view::npos)
      axes.fail_at(name, Code::definition_meaning,
                   "a " + std::string{rotary ? "rotary" : "linear"} +
                       " axis is named by one of the letters " + std::string{letters});
    read.emplace(name, rotary ? read_rotary_axis(name, object) : read_linear_axis(name, object));
    object.finish();
  }
  return read;
}

struct Sides {
  std::vector<Joint> table, head;
};

/// The joints in the order of the chain, which must close and hold every axis once.
Sides read_chain(const Object& root, const std::map<std::string, Axis>& axes) {
  const Array chain = root.array("chain");
  const auto names = chain.strings();
  const auto fail = [&](std::size_t i, std::string message) {
    chain.at(i).fail(Code::chain_shape, std::move(message));
  };
  Sides sides;
  bool base_seen = false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& name = names[i];
    const bool first = i == 0, last = i + 1 == names.size();
    if (first != (name == "workpiece"))
      fail(i, first ? "the chain starts with \"workpiece\"" : "the workpiece is inside the chain");
    else if (last != (name == "tool"))
      fail(i, last ? "the chain ends with \"tool\"" : "the tool is inside the chain");
    if (first || last) continue;
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), name) !=
        names.begin() + static_cast<std::ptrdiff_t>(i))
      fail(i, name + " stands twice in the chain");
    if (name == "base") {
      base_seen = true;
    } else if (const auto axis = axes.find(name); axis != axes.end()) {
      (base_seen ? sides.head : sides.table).push_back(axis->second.joint);
    } else {
      fail(i, name + " is not among the axes");
    }
  }
  if (!base_seen) chain.fail(Code::chain_shape, "the chain has no \"base\"");
  for (const auto& [name, axis] : axes)
    if (std::find(names.begin(), names.end(), name) == names.end())
      root.object("axes").fail_at(name, Code::chain_shape,
                                  "the axis " + name + " is not in the chain");
  return sides;
}

machine::Preferences read_preferences(const Object& root) {
  constexpr std::array<std::string_view, 2> tilts{"positive", "negative"};
  machine::Preferences preferences;
  const auto object = root.optional_object("preferences");
  if (!object) return preferences;
  if (const auto tilt = object->optional_choice("tilt", tilts))
    preferences.tilt =
        *tilt == 0 ? machine::Preferences::Tilt::positive : machine::Preferences::Tilt::negative;
  preferences.first_turn = angle_range_of(*object, "first_turn_deg");
  object->finish();
  return preferences;
}

machine::Clearance read_clearance(const Object& root) {
  machine::Clearance clearance;
  const auto object = root.optional_object("clearance");
  if (!object) return clearance;
  if (const auto spindle = object->optional_array("spindle"))
    clearance.spindle = read_tool_cylinders(*spindle, Code::definition_meaning);
  if (const auto table = object->optional_object("table"))
    clearance.table = read_table_disc(*table, Code::definition_meaning);
  object->finish();
  return clearance;
}

machine::OptionValue option_of(const Value& value) {
  if (value.is_boolean()) return value.boolean();
  if (value.is_number()) return value.number();
  if (value.is_array()) return value.array().strings();
  return value.string();
}

machine::Controller read_controller(const Object& root,
                                    std::span<const std::string_view> dialects) {
  constexpr std::array<std::string_view, 2> outputs{"tcp", "axes"};
  machine::Controller controller;
  const Object object = root.object("controller");
  controller.dialect = object.string("dialect");
  if (std::find(dialects.begin(), dialects.end(), controller.dialect) == dialects.end()) {
    const std::vector<std::string> known{dialects.begin(), dialects.end()};
    const auto near = machine::near_names(controller.dialect, known);
    object.fail_at("dialect", Code::unknown_dialect,
                   "there is no dialect \"" + controller.dialect + "\"" +
                       (near.empty() ? "" : "; did you mean \"" + near.front() + "\"?"));
  }
  controller.output = object.choice("output", outputs) == 0 ? Output::tcp : Output::axes;
  if (const auto options = object.optional_object("options")) {
    for (const auto& name : options->keys())
      controller.options.emplace(name, option_of(options->value(name)));
  }
  object.finish();
  return controller;
}

/// Refuses what the regular expressions of the schema cannot take.
void check_matched_texts(const Object& root) {
  for (const std::string_view key : {"name", "version"}) {
    const auto value = root.optional_value(key);
    if (value && value->is_string() && value->string().size() > longest_matched_text)
      value->fail(Code::definition_schema,
                  "the string is longer than " + std::to_string(longest_matched_text) + " bytes");
  }
}

Result<machine::Definition> read_definition(std::string_view text,
                                            std::span<const std::string_view> dialects) {
  if (text.size() > max_definition_bytes)
    return Problem{.code = Code::too_large,
                   .message = "the definition has " + std::to_string(text.size()) +
                              " bytes; at most " + std::to_string(max_definition_bytes) +
                              " are allowed"};
  auto document = Document::parse(text);
  if (!document) return std::move(document).error();
  if (document->root().is_object()) check_matched_texts(document->object());
  if (document->problem()) return *document->problem();
  if (auto fits = check_machine_schema(text); !fits) return std::move(fits).error();

  const Object root = document->object();
  root.optional_string("$schema");
  root.integer("schema_version", 1, 1);
  const auto axes = read_axes(root.object("axes"));
  Sides sides = read_chain(root, axes);
  std::map<std::string, machine::AxisLimits> limits;
  for (const auto& [name, axis] : axes) limits.emplace(name, axis.limits);
  const UnitVector tool_axis = direction_of(root, "tool_axis", Code::definition_meaning);
  auto preferences = read_preferences(root);
  auto clearance = read_clearance(root);
  auto controller = read_controller(root, dialects);
  auto name = root.string("name");
  auto version = root.string("version");
  auto title = root.string("title");
  auto sources = root.array("sources").strings();
  root.finish();
  if (document->problem()) return *document->problem();

  auto chain = machine::Chain::make(std::move(sides.table), std::move(sides.head), tool_axis);
  if (!chain) {
    Problem problem = std::move(chain).error();
    problem.pointer = "/axes";
    return problem;
  }
  return machine::Definition{.name = std::move(name),
                             .version = std::move(version),
                             .title = std::move(title),
                             .sources = std::move(sources),
                             .chain = std::move(chain).value(),
                             .limits = std::move(limits),
                             .preferences = std::move(preferences),
                             .controller = std::move(controller),
                             .sha256 = sha256_hex(text),
                             .clearance = std::move(clearance)};
}

}  // namespace

Result<machine::Definition> definition_from_text(std::string_view text,
                                                 std::span<const std::string_view> dialects,
                                                 std::string_view pointer_prefix) {
  auto definition = read_definition(text, dialects);
  if (definition) return definition;
  Problem problem = std::move(definition).error();
  problem.pointer.insert(0, pointer_prefix);
  return problem;
}

}  // namespace pentapost::json
