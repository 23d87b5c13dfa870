#include "server/app.hpp"

#include "server/http/gzip.hpp"
#include "server/http/media_type.hpp"
#include "server/json/problem_json.hpp"

#include <algorithm>
#include <utility>

namespace pentapost::server {
namespace {

constexpr std::size_t longest_id = 128;
constexpr std::size_t least_compressed = 16'384;  // below, a packet or two are saved at most

bool is_usable_id(std::string_view id) {
  return !id.empty() && id.size() <= longest_id && std::ranges::all_of(id, [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           std::string_view{"-_.:/+=@~"}.find(c) != std::string_view::npos;
  });
}

/// The values of all headers of that name as one list (RFC 9110, 5.3).
std::string header_list(const Request& request, std::string_view name) {
  std::string list;
  for (const auto& [key, value] : request.headers)
    if (key == name) list += (list.empty() ? "" : ", ") + value;
  return list;
}

std::string joined(MediaTypes types) {
  std::string text;
  for (const auto type : types) text += (text.empty() ? "" : ", ") + std::string{type};
  return text;
}

bool serves(const Endpoint& endpoint, std::string_view method) {
  return endpoint.method == method || (endpoint.method == "GET" && method == "HEAD");
}

std::string allowed_methods(std::string_view path) {
  std::string methods;
  for (const auto& endpoint : endpoints()) {
    if (!match_path(endpoint.path, path)) continue;
    methods += (methods.empty() ? "" : ", ") + std::string{endpoint.method};
    if (endpoint.method == "GET") methods += ", HEAD";
  }
  return methods;
}

/// Whether the endpoint takes the body that the head announces.
Status check_content(const Endpoint& endpoint, const Request& request) {
  if (endpoint.consumes.empty()) return ok();
  const auto* const encoding = find_field(request.headers, "content-encoding");
  if (encoding != nullptr && media_type_of(*encoding) != "identity") {
    return Problem{.code = Code::unsupported_media_type,
                   .message = "a body must not have a Content-Encoding"};
  }
  const auto* const type = find_field(request.headers, "content-type");
  const auto media_type = type == nullptr ? std::string{} : media_type_of(*type);
  if (std::ranges::find(endpoint.consumes, media_type) != endpoint.consumes.end()) return ok();
  return Problem{.code = Code::unsupported_media_type,
                 .message = "the Content-Type must be one of: " + joined(endpoint.consumes)};
}

/// The media types that an endpoint offers, best first. A job posted as plain text is answered so.
std::vector<std::string_view> offered_types(const Endpoint& endpoint, const Request& request) {
  std::vector<std::string_view> types{endpoint.produces.begin(), endpoint.produces.end()};
  const auto* const content_type = find_field(request.headers, "content-type");
  if (endpoint.consumes.empty() || content_type == nullptr) return types;
  const auto same = std::ranges::find(types, media_type_of(*content_type));
  if (same != types.end()) std::rotate(types.begin(), same, same + 1);
  return types;
}

}  // namespace

App::App(Services services, const AppLimits& limits)
    : services_{std::move(services)}, admission_{limits.running_jobs, limits.waiting_jobs} {}

void App::identify(Request& request) const {
  const auto* const given = find_field(request.headers, "x-request-id");
  request.id = given != nullptr && is_usable_id(*given) ? *given : services_.next_request_id();
}

Response App::finished(Response response, const Request& request) const {
  response.headers.emplace_back("X-Request-Id", request.id);
  response.headers.emplace_back("X-Content-Type-Options", "nosniff");
  const bool compressible =
      response.body.size() >= least_compressed && find_field(response.headers, "ETag") == nullptr;
  if (!compressible) return response;
  response.headers.emplace_back("Vary", "Accept-Encoding");
  if (!accepts_gzip(header_list(request, "accept-encoding"))) return response;
  response.body = gzip(response.body);
  response.headers.emplace_back("Content-Encoding", "gzip");
  return response;
}

Response App::refuse(const Problem& problem, const Request& request) const {
  return finished(problem_response(problem, request.id), request);
}

std::variant<App::Passage, Response> App::enter(const Request& request) {
  for (const auto& endpoint : endpoints()) {
    auto names = match_path(endpoint.path, request.path);
    if (!names || !serves(endpoint, request.method)) continue;
    if (const auto status = check_content(endpoint, request); !status)
      return refuse(status.error(), request);
    const auto offered = offered_types(endpoint, request);
    const auto media_type = negotiate(header_list(request, "accept"), offered);
    if (!media_type) {
      return refuse(Problem{.code = Code::not_acceptable,
                            .message = "the answer can be one of: " + joined(endpoint.produces)},
                    request);
    }
    Passage passage{&endpoint, std::move(*names), *media_type, std::nullopt};
    if (endpoint.consumes.empty()) return passage;
    auto ticket = admission_.enter();
    if (!ticket) {
      return refuse(Problem{.code = Code::overloaded,
                            .message = "as many jobs as the bound allows are under way; "
                                       "nothing of this one was started"},
                    request);
    }
    passage.ticket.emplace(std::move(*ticket));
    return passage;
  }
  const auto methods = allowed_methods(request.path);
  if (methods.empty())
    return refuse(Problem{.code = Code::not_found, .message = "there is nothing at this path"},
                  request);
  auto response = refuse(
      Problem{.code = Code::method_not_allowed, .message = "the methods here are: " + methods},
      request);
  response.headers.emplace_back("Allow", methods);
  return response;
}

Response App::answer(Passage passage, Request request) {
  Call call{.services = services_,
            .admission = admission_,
            .request = std::move(request),
            .names = std::move(passage.names),
            .media_type = passage.media_type};
  auto result = passage.endpoint->handler(call);
  if (result) return finished(std::move(result).value(), call.request);
  auto response = refuse(result.error(), call.request);
  response.cl = std::move(call.cl);
  if (response.status == 500) response.defect = result.error().message;
  return response;
}

Response App::handle(Request request) {
  identify(request);
  auto entry = enter(request);
  if (auto* const refusal = std::get_if<Response>(&entry)) return std::move(*refusal);
  return answer(std::move(std::get<Passage>(entry)), std::move(request));
}

}  // namespace pentapost::server
