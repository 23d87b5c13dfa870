#pragma once

#include "server/http/message.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace pentapost::server {

/// One answered request, as the log knows it. CL data are a customer's secret: no body, no query.
struct AccessRecord {
  std::string id, method, path;
  int status = 0;
  std::uint64_t bytes = 0;  ///< of the answer's content
  double duration_ms = 0.0;
  std::optional<ClTrace> cl = {};
};

using LogField = std::pair<std::string_view, std::variant<std::string, std::int64_t>>;

/// JSON lines, one an event, each with time, level and event. Safe to call from all threads.
class Log {
 public:
  using Sink = std::function<void(const std::string& line)>;
  /// Writes to stderr.
  Log();
  /// Writes to `sink`, one call at a time.
  explicit Log(Sink sink);
  ~Log();

  void access(const AccessRecord& record);
  /// A defect: what an exception said, under the id that the client was told.
  void defect(const std::string& id, std::string_view what);
  void info(std::string_view event, std::initializer_list<LogField> fields = {});
  void error(std::string_view event, std::initializer_list<LogField> fields = {});

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace pentapost::server
