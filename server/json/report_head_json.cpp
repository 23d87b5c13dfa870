#include "server/json/report_head_json.hpp"

namespace pentapost::server {

void write_machine(JsonWriter& writer, const jobs::ReportHead& head) {
  writer.key("machine").begin_object();
  writer.key("name").string(head.machine_name);
  writer.key("version").string(head.machine_version);
  writer.key("sha256").string(head.machine_sha256);
  writer.end_object();
}

void write_cl(JsonWriter& writer, const jobs::ReportHead& head) {
  writer.key("cl").begin_object();
  if (!head.cl_sha256.empty()) writer.key("sha256").string(head.cl_sha256);
  if (!head.cl_dialect.empty()) writer.key("dialect").string(head.cl_dialect);
  writer.key("lines").integer(head.cl_lines);
  writer.key("points").integer(head.cl_points);
  writer.key("units").string(head.cl_units);
  writer.end_object();
}

void write_nc(JsonWriter& writer, const jobs::ReportHead& head) {
  writer.key("nc").begin_object();
  writer.key("sha256").string(head.nc_sha256);
  writer.key("dialect").string(head.nc_dialect);
  writer.key("lines").integer(head.nc_lines);
  writer.key("blocks").integer(head.nc_blocks);
  writer.end_object();
}

}  // namespace pentapost::server
