#pragma once

#include "pentapost/jobs/report_head.hpp"
#include "server/json/json_writer.hpp"

namespace pentapost::server {

/// Writes "machine": its name, version and sha256.
void write_machine(JsonWriter& writer, const jobs::ReportHead& head);

/// Writes "cl": what the path was read from.
void write_cl(JsonWriter& writer, const jobs::ReportHead& head);
/// Writes "nc" in its place, where the path is an NC program.
void write_nc(JsonWriter& writer, const jobs::ReportHead& head);

}  // namespace pentapost::server
