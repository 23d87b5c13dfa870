#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pentapost::server {

/// Names and values in the order they came. Header names are in lower case.
using Fields = std::vector<std::pair<std::string, std::string>>;

/// The first value of that name; nullptr: there is none.
inline const std::string* find_field(const Fields& fields, std::string_view name) {
  for (const auto& [key, value] : fields)
    if (key == name) return &value;
  return nullptr;
}

/// One HTTP request, independent of the library that carries it.
struct Request {
  std::string method;   ///< as sent: "GET"
  std::string path;     ///< percent-decoded, without the query
  Fields query = {};    ///< percent-decoded
  Fields headers = {};  ///< names in lower case
  std::string body = {};
  std::string id = {};  ///< X-Request-Id of the answer and the log
};

/// What the log says of the CL data of a job: never the data themselves.
struct ClTrace {
  std::string sha256;
  std::uint64_t bytes = 0;
};

struct Response {
  int status = 200;
  std::string content_type = {};
  Fields headers = {};  ///< beside Content-Type, Content-Length, Date, Connection
  std::string body = {};
  std::optional<ClTrace> cl = {};  ///< for the log
  std::string defect = {};         ///< for the log: what went wrong in the service; empty: nothing
};

}  // namespace pentapost::server
