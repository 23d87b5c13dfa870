#pragma once

#include "pentapost/core/result.hpp"
#include "server/http/admission.hpp"
#include "server/http/message.hpp"
#include "server/services.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::server {

/// A request on its way to its endpoint.
struct Call {
  const Services& services;
  Admission& admission;
  Request request;
  std::vector<std::string> names;  ///< what stands for each {name} of the path, in order
  std::string_view media_type;     ///< of the answer that the client accepts best
  std::optional<ClTrace> cl = {};  ///< set by the handler, for the log
};

using Handler = Result<Response> (*)(Call& call);
using MediaTypes = std::span<const std::string_view>;

struct Endpoint {
  std::string_view method;  ///< GET serves HEAD too
  std::string_view path;    ///< "/machines/{name}"
  Handler handler;
  MediaTypes produces;       ///< preferred ones first
  MediaTypes consumes = {};  ///< of the body; empty: it takes none
};

/// All that is served. The OpenAPI document has the same ones; a test compares them.
std::span<const Endpoint> endpoints();

/// What stands for each {name} of `pattern` in `path`; nullopt: the path is another one.
std::optional<std::vector<std::string>> match_path(std::string_view pattern, std::string_view path);

// endpoints/*.cpp
Result<Response> post_program(Call& call);
Result<Response> analyse_path(Call& call);
Result<Response> reorient_path(Call& call);
Result<Response> compare_machines(Call& call);
Result<Response> get_machines(Call& call);
Result<Response> get_machine(Call& call);
Result<Response> get_machine_version(Call& call);
Result<Response> get_dialects(Call& call);
Result<Response> get_health(Call& call);
Result<Response> get_version(Call& call);
Result<Response> get_contract(Call& call);
Result<Response> get_schema(Call& call);

}  // namespace pentapost::server
