#include "server/json/zones_json.hpp"

namespace pentapost::server {
namespace {

std::string_view name_of(jobs::Cure::Kind kind) {
  switch (kind) {
    case jobs::Cure::Kind::feed:
      return "feed";
    case jobs::Cure::Kind::solution:
      return "solution";
    case jobs::Cure::Kind::axis_change:
      return "axis-change";
    case jobs::Cure::Kind::reorientation:
      break;
  }
  return "reorientation";
}

void write_cures(JsonWriter& writer, const std::vector<jobs::Cure>& cures) {
  writer.key("cures").begin_array();
  for (const auto& cure : cures) {
    writer.begin_object();
    writer.key("kind").string(name_of(cure.kind));
    if (cure.kind == jobs::Cure::Kind::feed) writer.key("feed_mm_min").number(cure.feed_mm_min);
    if (cure.kind == jobs::Cure::Kind::axis_change)
      writer.key("pole_axis_deg").number(cure.axis_change_deg);
    if (cure.kind == jobs::Cure::Kind::reorientation) {
      writer.key("theta_x_deg").number(cure.theta_x_deg);
      writer.key("theta_z_deg").number(cure.theta_z_deg);
    }
    writer.key("peak_ratio").number(cure.peak_ratio);
    writer.key("time_lost_s").number(cure.time_lost_s);
    writer.end_object();
  }
  writer.end_array();
}

}  // namespace

std::string_view singularity_name(kinematics::SingularityKind kind) {
  return kind == kinematics::SingularityKind::pole ? "pole" : "reach-boundary";
}

void write_vector(JsonWriter& writer, const Vec3& vector) {
  writer.begin_array();
  for (const double component : vector) writer.number(component);
  writer.end_array();
}

void write_range(JsonWriter& writer, const Range<double>& range) {
  writer.begin_array().number(range.lower).number(range.upper).end_array();
}

void write_place(JsonWriter& writer, const PlaceKeys& keys, const jobs::PathPlace& place) {
  writer.begin_object();
  writer.key(keys.point).integer(place.point);
  writer.key(keys.line).integer(place.line);
  writer.key("s_mm").number(place.s_mm);
  write_vector(writer.key("tip_mm"), place.tip_wp_mm);
  writer.end_object();
}

std::string in_unit(bool rotary, std::string_view name, std::string_view per) {
  return std::string{name}.append(rotary ? "_deg" : "_mm").append(per);
}

void write_zones(JsonWriter& writer, std::string_view key, const PlaceKeys& keys,
                 const jobs::ZonesReport& report) {
  writer.key(key).begin_array();
  for (const auto& zone : report.zones) {
    writer.begin_object();
    if (zone.kind) writer.key("kind").string(singularity_name(*zone.kind));
    writer.key("axis").string(zone.axis);
    write_place(writer.key("from"), keys, zone.from);
    write_place(writer.key("to"), keys, zone.to);
    if (zone.closest_deg) writer.key("closest_deg").number(*zone.closest_deg);
    writer.key(in_unit(zone.rotary, "peak", "_s")).number(zone.peak_speed);
    writer.key("peak_ratio").number(zone.peak_ratio);
    if (zone.amplification) writer.key("amplification").number(*zone.amplification);
    writer.key("lowest_feed_mm_min").number(zone.lowest_feed_mm_min);
    writer.key("programmed_time_s").number(zone.programmed_time_s);
    writer.key("time_lost_s").number(zone.time_lost_s);
    if (zone.kind) write_cures(writer, zone.cures);
    writer.end_object();
  }
  writer.end_array();
  writer.key(std::string{key}.append("_total")).integer(report.total);
}

}  // namespace pentapost::server
