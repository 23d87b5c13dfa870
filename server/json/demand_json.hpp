#pragma once

#include "pentapost/jobs/analysis_report.hpp"
#include "server/json/json_writer.hpp"
#include "server/json/zones_json.hpp"

#include <vector>

namespace pentapost::server {

/// The members of an axis: what the cutting path asks of it.
void write_demand(JsonWriter& writer, const PlaceKeys& keys, const jobs::AxisDemandReport& axis);

/// Writes "singular_directions".
void write_singular_directions(JsonWriter& writer,
                               const std::vector<jobs::SingularDirection>& directions);

}  // namespace pentapost::server
