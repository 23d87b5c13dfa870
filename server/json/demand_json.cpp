#include "server/json/demand_json.hpp"

#include <optional>
#include <string_view>

namespace pentapost::server {

void write_demand(JsonWriter& writer, const PlaceKeys& keys, const jobs::AxisDemandReport& axis) {
  const auto number = [&](std::string_view name, std::string_view per,
                          const std::optional<double>& value) {
    if (value) writer.key(in_unit(axis.rotary, name, per)).number(*value);
  };
  if (axis.span) {
    number("min", "", axis.span->lower);
    number("max", "", axis.span->upper);
  }
  number("peak", "_s", axis.peak_speed);
  number("asked", "_s", axis.asked_speed);
  if (axis.amplification) writer.key("amplification").number(*axis.amplification);
  number("limit", "_s", axis.speed_limit);
  number("peak", "_s2", axis.peak_acceleration);
  number("limit", "_s2", axis.acceleration_limit);
  if (axis.peak_ratio) writer.key("peak_ratio").number(*axis.peak_ratio);
  if (axis.peak_at) write_place(writer.key("peak_at"), keys, *axis.peak_at);
}

void write_singular_directions(JsonWriter& writer,
                               const std::vector<jobs::SingularDirection>& directions) {
  writer.key("singular_directions").begin_array();
  for (const auto& each : directions) {
    writer.begin_object();
    writer.key("kind").string(singularity_name(each.kind));
    write_vector(writer.key("direction"), each.direction);
    writer.key("half_angle_deg").number(each.half_angle_deg);
    writer.end_object();
  }
  writer.end_array();
}

}  // namespace pentapost::server
