#pragma once

#include "pentapost/jobs/analysis_report.hpp"
#include "server/json/json_writer.hpp"

#include <string>
#include <string_view>

namespace pentapost::server {

/// How the places of a path are called.
struct PlaceKeys {
  std::string_view point, line;
};
inline constexpr PlaceKeys cl_place_keys{"point", "cl_line"};
inline constexpr PlaceKeys nc_place_keys{"block", "nc_line"};

std::string_view singularity_name(kinematics::SingularityKind kind);

/// "peak_deg_s" or "peak_mm_s".
std::string in_unit(bool rotary, std::string_view name, std::string_view per = "");

void write_vector(JsonWriter& writer, const Vec3& vector);
void write_range(JsonWriter& writer, const Range<double>& range);
void write_place(JsonWriter& writer, const PlaceKeys& keys, const jobs::PathPlace& place);
/// Zones below their key, and their number.
void write_zones(JsonWriter& writer, std::string_view key, const PlaceKeys& keys,
                 const jobs::ZonesReport& report);

}  // namespace pentapost::server
