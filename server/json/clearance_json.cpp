#include "server/json/clearance_json.hpp"

#include "pentapost/json/clearance_json.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace pentapost::server {
namespace {

using json::Domain;
using json::Object;
using namespace std::string_view_literals;

constexpr std::array frame_words{"table"sv, "workpiece"sv};
constexpr auto safety_domain = Domain::between(0.0, clearance::largest_safety_mm);

clearance::JigBox read_box(const Object& object) {
  clearance::JigBox box{.min_mm = json::read_clearance_point(object, "min_mm"),
                        .max_mm = json::read_clearance_point(object, "max_mm"),
                        .frame = object.choice("frame", frame_words) == 0
                                     ? clearance::JigBox::Frame::table
                                     : clearance::JigBox::Frame::workpiece};
  if (!((box.max_mm - box.min_mm).minCoeff() > 0.0))
    object.fail_at("max_mm", Code::out_of_domain,
                   "expected each coordinate to be above that of min_mm");
  object.finish();
  return box;
}

void read_jig(const Object& object, clearance::Model& model) {
  const auto boxes = object.optional_array("jig");
  if (!boxes) return;
  if (boxes->size() > clearance::most_jig_boxes)
    return boxes->fail(Code::out_of_domain, "found " + std::to_string(boxes->size()) +
                                                " boxes, expected at most " +
                                                std::to_string(clearance::most_jig_boxes));
  for (std::size_t i = 0; i < boxes->size(); ++i)
    model.jig.push_back(read_box(boxes->at(i).object()));
}

}  // namespace

std::optional<clearance::Model> read_clearance(const Object& job) {
  const auto object = job.optional_object("clearance");
  if (!object) return std::nullopt;
  clearance::Model model;
  if (const auto holder = object->optional_array("holder"))
    model.holder = json::read_tool_cylinders(*holder, Code::out_of_domain);
  if (const auto spindle = object->optional_array("spindle"))
    model.machine.spindle = json::read_tool_cylinders(*spindle, Code::out_of_domain);
  if (const auto table = object->optional_object("table"))
    model.machine.table = json::read_table_disc(*table, Code::out_of_domain);
  read_jig(*object, model);
  model.safety_mm = object->optional_number("safety_mm", safety_domain).value_or(model.safety_mm);
  object->finish();
  return model;
}

}  // namespace pentapost::server
