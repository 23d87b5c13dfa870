#pragma once

#include "pentapost/jobs/setup_report.hpp"
#include "server/json/json_writer.hpp"

#include <optional>
#include <string_view>

namespace pentapost::server {

std::string_view objective_name(jobs::Objective objective);

/// What stands in the way; null: nothing.
void write_obstacle(JsonWriter& writer, const std::optional<jobs::Obstacle>& obstacle);

/// The path in one setup. A setup that is not possible has no figures: their keys are left out.
void write_setup_report(JsonWriter& writer, const jobs::SetupReport& report);
/// null: there is none.
void write_setup_report(JsonWriter& writer, const std::optional<jobs::SetupReport>& report);

}  // namespace pentapost::server
