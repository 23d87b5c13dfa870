#include "pentapost/json/clearance_json.hpp"

#include "pentapost/json/direction.hpp"

#include <cstddef>
#include <string>

namespace pentapost::json {
namespace {

using machine::largest_clearance_size_mm;

constexpr Domain size_domain{.lower = 0.0, .upper = largest_clearance_size_mm, .lower_open = true};
constexpr auto height_domain =
    Domain::between(-largest_clearance_size_mm, largest_clearance_size_mm);

}  // namespace

std::vector<machine::ToolCylinder> read_tool_cylinders(const Array& array, Code contradiction) {
  std::vector<machine::ToolCylinder> cylinders;
  if (array.size() > machine::most_tool_cylinders) {
    array.fail(Code::out_of_domain, "found " + std::to_string(array.size()) +
                                        " cylinders, expected at most " +
                                        std::to_string(machine::most_tool_cylinders));
    return cylinders;
  }
  for (std::size_t i = 0; i < array.size(); ++i) {
    const Object object = array.at(i).object();
    const machine::ToolCylinder cylinder{.radius_mm = object.number("radius_mm", size_domain),
                                         .from_mm = object.number("from_mm", height_domain),
                                         .to_mm = object.number("to_mm", height_domain)};
    if (!(cylinder.from_mm < cylinder.to_mm))
      object.fail_at("to_mm", contradiction, "the cylinder ends where it starts or below");
    object.finish();
    cylinders.push_back(cylinder);
  }
  return cylinders;
}

machine::TableDisc read_table_disc(const Object& object, Code contradiction) {
  machine::TableDisc table;
  table.radius_mm = object.number("radius_mm", size_domain);
  if (object.has("centre_mm")) table.centre_mm = read_clearance_point(object, "centre_mm");
  if (object.has("normal")) table.normal = direction_of(object, "normal", contradiction);
  table.thickness_mm =
      object.optional_number("thickness_mm", size_domain).value_or(table.thickness_mm);
  // null counts as not given.
  for (const std::string_view key : {"centre_mm", "normal"}) object.optional_value(key);
  object.finish();
  return table;
}

Vec3 read_clearance_point(const Object& object, std::string_view key) {
  Vec3 point_mm = object.vector3(key);
  if (point_mm.cwiseAbs().maxCoeff() > machine::largest_clearance_coordinate_mm)
    object.fail_at(key, Code::out_of_domain, "found a coordinate beyond the largest, 1000000 mm");
  return point_mm;
}

}  // namespace pentapost::json
