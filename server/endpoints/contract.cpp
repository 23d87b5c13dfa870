#include "server/contract.hpp"

#include "server/endpoints.hpp"

namespace pentapost::server {

Result<Response> get_contract(Call& call) {
  return Response{.content_type = std::string{call.media_type} + "; charset=utf-8",
                  .body = std::string{openapi_text()}};
}

Result<Response> get_schema(Call& call) {
  for (const auto& file : schema_files()) {
    if (file.name != call.names[0]) continue;
    return Response{.content_type = std::string{call.media_type}, .body = std::string{file.text}};
  }
  return Problem{.code = Code::not_found, .message = "there is no schema of that name"};
}

}  // namespace pentapost::server
