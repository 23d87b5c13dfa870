#include "server/endpoints.hpp"

#include <algorithm>
#include <array>

namespace pentapost::server {
namespace {

using namespace std::string_view_literals;

constexpr std::array json{"application/json"sv};
constexpr std::array yaml{"application/yaml"sv, "text/yaml"sv, "text/plain"sv};
constexpr std::array schema{"application/schema+json"sv, "application/json"sv};
constexpr std::array program{"application/json"sv, "text/plain"sv};
constexpr std::array job_forms{"application/json"sv, "text/plain"sv, "multipart/form-data"sv};

constexpr std::array table{
    Endpoint{"POST", "/post", post_program, program, job_forms},
    Endpoint{"POST", "/analyse", analyse_path, json, job_forms},
    Endpoint{"POST", "/reorient", reorient_path, json, job_forms},
    Endpoint{"POST", "/compare", compare_machines, json, job_forms},
    Endpoint{"GET", "/machines", get_machines, json},
    Endpoint{"GET", "/machines/{name}", get_machine, json},
    Endpoint{"GET", "/machines/{name}/versions/{version}", get_machine_version, json},
    Endpoint{"GET", "/dialects", get_dialects, json},
    Endpoint{"GET", "/healthz", get_health, json},
    Endpoint{"GET", "/version", get_version, json},
    Endpoint{"GET", "/openapi.yaml", get_contract, yaml},
    Endpoint{"GET", "/schemas/{file}", get_schema, schema},
};

/// Takes the segment before the next '/' off `rest`.
std::string_view take_segment(std::string_view& rest) {
  const auto end = rest.find('/');
  const auto segment = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  return segment;
}

}  // namespace

std::span<const Endpoint> endpoints() { return table; }

std::optional<std::vector<std::string>> match_path(std::string_view pattern,
                                                   std::string_view path) {
  if (std::ranges::count(pattern, '/') != std::ranges::count(path, '/')) return std::nullopt;
  std::vector<std::string> names;
  while (!pattern.empty()) {
    const auto expected = take_segment(pattern);
    const auto found = take_segment(path);
    if (expected.starts_with('{')) {
      if (found.empty()) return std::nullopt;
      names.emplace_back(found);
    } else if (expected != found) {
      return std::nullopt;
    }
  }
  return names;
}

}  // namespace pentapost::server
