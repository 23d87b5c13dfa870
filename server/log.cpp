#include "server/log.hpp"

#include "server/json/json_writer.hpp"

#include <spdlog/logger.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <mutex>
#include <utility>

namespace pentapost::server {
namespace {

class FunctionSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  explicit FunctionSink(Log::Sink write) : write_{std::move(write)} {}

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    write_(std::string{line.data(), line.size()});
  }
  void flush_() override {}

 private:
  Log::Sink write_;
};

/// The members of a line behind time and level, without the braces of an object.
class Members {
 public:
  explicit Members(std::string_view event) {
    writer_.begin_object();
    writer_.key("event").string(event);
  }
  JsonWriter& operator()(std::string_view key) { return writer_.key(key); }
  std::string_view text() const { return std::string_view{text_}.substr(1); }

 private:
  std::string text_;
  JsonWriter writer_{text_};
};

void add_fields(Members& members, std::initializer_list<LogField> fields) {
  for (const auto& [key, value] : fields) {
    if (const auto* text = std::get_if<std::string>(&value))
      members(key).string(*text);
    else
      members(key).raw(std::to_string(std::get<std::int64_t>(value)));
  }
}

}  // namespace

struct Log::Writer {
  explicit Writer(spdlog::sink_ptr target) : logger{"pentapost", std::move(target)} {
    logger.set_formatter(std::make_unique<spdlog::pattern_formatter>(
        R"({"time":"%Y-%m-%dT%H:%M:%S.%eZ","level":"%l",%v})", spdlog::pattern_time_type::utc));
    logger.flush_on(spdlog::level::info);
  }
  void write(spdlog::level::level_enum level, const Members& members) {
    const auto text = members.text();
    logger.log(level, spdlog::string_view_t{text.data(), text.size()});
  }
  spdlog::logger logger;
};

Log::Log() : writer_{std::make_unique<Writer>(std::make_shared<spdlog::sinks::stderr_sink_mt>())} {}
Log::Log(Sink sink)
    : writer_{std::make_unique<Writer>(std::make_shared<FunctionSink>(std::move(sink)))} {}
Log::~Log() = default;

void Log::access(const AccessRecord& record) {
  Members members{"request"};
  members("request_id").string(record.id);
  members("method").string(record.method);
  members("path").string(record.path);
  members("status").integer(static_cast<std::uint64_t>(record.status));
  members("bytes").integer(record.bytes);
  members("duration_ms").number(record.duration_ms);
  if (record.cl) {
    members("cl_sha256").string(record.cl->sha256);
    members("cl_bytes").integer(record.cl->bytes);
  }
  writer_->write(spdlog::level::info, members);
}

void Log::defect(const std::string& id, std::string_view what) {
  Members members{"defect"};
  members("request_id").string(id);
  members("what").string(what);
  writer_->write(spdlog::level::err, members);
}

void Log::info(std::string_view event, std::initializer_list<LogField> fields) {
  Members members{event};
  add_fields(members, fields);
  writer_->write(spdlog::level::info, members);
}

void Log::error(std::string_view event, std::initializer_list<LogField> fields) {
  Members members{event};
  add_fields(members, fields);
  writer_->write(spdlog::level::err, members);
}

}  // namespace pentapost::server
