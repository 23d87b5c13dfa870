#include "server/endpoints.hpp"
#include "server/json/json_writer.hpp"

namespace pentapost::server {

Result<Response> get_health(Call&) {
  Response response{.content_type = "application/json", .body = R"({"status":"ok"})"};
  response.headers.emplace_back("Cache-Control", "no-store");
  return response;
}

Result<Response> get_version(Call&) {
  Response response{.content_type = "application/json"};
  JsonWriter writer{response.body};
  writer.begin_object();
  writer.key("name").string("pentapost");
  writer.key("version").string(PENTAPOST_VERSION);
  writer.key("compiler").string(PENTAPOST_COMPILER);
  writer.end_object();
  return response;
}

}  // namespace pentapost::server
