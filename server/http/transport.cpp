#include "server/http/transport.hpp"

#include "server/json/problem_json.hpp"

#include <httplib.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <exception>
#include <thread>
#include <utility>
#include <variant>

// cpp-httplib accepts, runs the threads, parses vetted heads and writes answers. All that 0.11.4
// leaves open (sizes, times, framing, queueing) is decided before it sees a byte: `Connection`
// reads and bounds, `parse_head` refuses, and httplib gets a bare head of a line or two.
namespace pentapost::server {
namespace {

using Clock = std::chrono::steady_clock;

/// "Sun, 06 Nov 1994 08:49:37 GMT" (RFC 9110, 5.6.7), whatever the locale.
std::string http_date(std::time_t time) {
  constexpr std::array days{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
  constexpr std::array months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                              "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  std::tm utc{};
  ::gmtime_r(&time, &utc);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%s, %02d %s %04d %02d:%02d:%02d GMT",
                days[static_cast<std::size_t>(utc.tm_wday)], utc.tm_mday,
                months[static_cast<std::size_t>(utc.tm_mon)], utc.tm_year + 1900, utc.tm_hour,
                utc.tm_min, utc.tm_sec);
  return text.data();
}

/// The threads of httplib's server, which also tells how many connections wait for one.
class CountedThreads : public httplib::TaskQueue {
 public:
  CountedThreads(int threads, std::atomic<int>& waiting)
      : pool_{static_cast<std::size_t>(threads)}, waiting_{waiting} {}
  void enqueue(std::function<void()> task) override {
    ++waiting_;
    pool_.enqueue([this, task = std::move(task)] {
      --waiting_;
      task();
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  httplib::ThreadPool pool_;
  std::atomic<int>& waiting_;
};

/// What httplib sees of a connection: the head made for it, and where its answer goes.
class AnswerStream : public httplib::Stream {
 public:
  AnswerStream(std::string head, Connection& connection, int socket)
      : head_{std::move(head)}, connection_{connection}, socket_{socket} {}

  bool is_readable() const override { return read_ < head_.size(); }
  bool is_writable() const override { return true; }
  ssize_t read(char* target, size_t size) override {
    const auto count = head_.copy(target, size, read_);
    read_ += count;
    return static_cast<ssize_t>(count);
  }
  /// Small pieces go out as one.
  ssize_t write(const char* bytes, size_t size) override {
    constexpr std::size_t held = 65'536;
    if (held_.size() + size <= held) {
      held_.append(bytes, size);
      return static_cast<ssize_t>(size);
    }
    const bool written = flush() && connection_.write({bytes, size});
    return written ? static_cast<ssize_t>(size) : -1;
  }
  bool flush() { return connection_.write(std::exchange(held_, {})); }

  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return socket_; }

 private:
  std::string head_;
  std::size_t read_ = 0;
  std::string held_;
  Connection& connection_;
  int socket_;
};

/// One request and its answer.
struct Exchange {
  Connection& connection;
  std::variant<Head, Problem> head;  ///< a Problem: the head was refused
  Clock::time_point start = Clock::now();
  Request request = {};
  Response response = {};
  std::uint64_t bytes = 0;  ///< of the answer's content
  bool answered = false;
  bool unread = true;  ///< the client may still be sending
  bool close = true;   ///< the connection can't be used again
};

/// Carried by httplib::Request::progress, which its server side has no use for: the way from its
/// request to ours.
struct ExchangeLink {
  Exchange* exchange;
  bool operator()(std::uint64_t, std::uint64_t) const { return true; }
};

/// A head for httplib that says what the vetted one says and nothing that httplib gets wrong: no
/// length (the body is read by the connection), no Range, no Accept-Encoding, no Expect.
std::string head_for_httplib(const Exchange& exchange) {
  const auto* const head = std::get_if<Head>(&exchange.head);
  const std::string target = head == nullptr || head->target == "*" ? "/" : head->target;
  return "GET " + target + " HTTP/1.1\r\n\r\n";
}

}  // namespace

class Transport::Server : public httplib::Server {
 public:
  Server(App& app, Log& log, const TransportLimits& limits);
  Result<int> bind(const std::string& host, int port);
  void run();
  void drain();

 private:
  bool process_and_close_socket(socket_t socket) override;
  bool serve_next(Connection& connection, int socket, bool last);
  bool send(Exchange& exchange, int socket, bool last);
  void fill_request(Exchange& exchange, httplib::Request& vetted) const;
  void answer(Exchange& exchange);
  Response answer_or_throw(Exchange& exchange);
  void log_access(const Exchange& exchange);

  App& app_;
  Log& log_;
  TransportLimits limits_;
  std::atomic<int> waiting_ = 0;
  std::atomic<bool> draining_ = false, started_ = false, ended_ = false;
};

namespace {

/// Moves an answer into httplib's. HEAD and 304 tell the length of what they leave out.
void give(Exchange& exchange, httplib::Response& answer) {
  auto& response = exchange.response;
  answer.status = response.status;
  for (const auto& [name, value] : response.headers) answer.set_header(name, value);
  if (exchange.request.method == "HEAD") answer.set_header("Accept-Ranges", "none");
  answer.set_header("Date", http_date(std::time(nullptr)));
  if (!response.content_type.empty()) answer.set_header("Content-Type", response.content_type);
  if (exchange.request.method == "HEAD" || response.status == 304)
    answer.content_length_ = response.body.size();
  else
    answer.body = std::move(response.body);
}

}  // namespace

Transport::Server::Server(App& app, Log& log, const TransportLimits& limits)
    : app_{app}, log_{log}, limits_{limits} {
  new_task_queue = [this] { return new CountedThreads{limits_.connection_threads, waiting_}; };
  set_tcp_nodelay(true);
  // httplib's own options share the port with any second process.
  set_socket_options([](socket_t socket) {
    const int on = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  });
  set_pre_routing_handler([](const httplib::Request& vetted, httplib::Response& answer) {
    give(*vetted.progress.target<ExchangeLink>()->exchange, answer);
    return HandlerResponse::Handled;
  });
  set_keep_alive_timeout(
      std::chrono::duration_cast<std::chrono::seconds>(limits.idle_time).count());
  set_keep_alive_max_count(limits.requests_per_connection);
  // Exceptions end in answer(); without a handler httplib would show their text to the client.
  set_exception_handler([](const httplib::Request&, httplib::Response& answer, std::exception_ptr) {
    answer.status = 500;
  });
}

Result<int> Transport::Server::bind(const std::string& host, int port) {
  const int bound = port == 0 ? bind_to_any_port(host) : bind_to_port(host, port) ? port : -1;
  if (bound < 0 || ::listen(svr_sock_, limits_.backlog) != 0) {
    return Problem{.code = Code::out_of_domain,
                   .message = "cannot listen on " + host + ':' + std::to_string(port) +
                              ": in use, not permitted, or not an address of this host"};
  }
  return bound;
}

void Transport::Server::run() {
  started_ = true;
  if (!draining_) listen_after_bind();
  ended_ = true;
}

void Transport::Server::drain() {
  draining_ = true;
  // httplib's stop() does nothing to a server that is about to run.
  while (started_ && !is_running() && !ended_) std::this_thread::sleep_for(Milliseconds{1});
  stop();
}

bool Transport::Server::process_and_close_socket(socket_t socket) {
  Connection connection{socket,
                        limits_,
                        {.crowded = [this] { return waiting_ > 0; },
                         .draining = [this] { return draining_.load(); }}};
  std::size_t served = 0;
  while (serve_next(connection, socket, ++served == limits_.requests_per_connection)) {
  }
  return true;
}

bool Transport::Server::serve_next(Connection& connection, int socket, bool last) {
  std::string head_text;
  const auto refused = [&](Code code, std::string message) {
    Exchange exchange{.connection = connection,
                      .head = Problem{.code = code, .message = std::move(message)}};
    return send(exchange, socket, last);
  };
  switch (connection.read_head(head_text)) {
    case Connection::Arrival::nothing:
      return false;
    case Connection::Arrival::too_slow:
      return refused(Code::too_slow, "the request's head did not arrive in time");
    case Connection::Arrival::too_large:
      return refused(Code::head_too_large,
                     "the request's head is over " + std::to_string(limits_.head.bytes) + " bytes");
    case Connection::Arrival::head:
      break;
  }
  auto head = parse_head(head_text, limits_.head);
  if (!head) return refused(head.error().code, head.error().message);
  Exchange exchange{.connection = connection, .head = std::move(head).value()};
  return send(exchange, socket, last);
}

bool Transport::Server::send(Exchange& exchange, int socket, bool last) {
  AnswerStream stream{head_for_httplib(exchange), exchange.connection, socket};
  bool closed = false;
  const auto set_up = [&](httplib::Request& vetted) {
    fill_request(exchange, vetted);
    answer(exchange);
    exchange.close = exchange.close || last || draining_;
    vetted.method = exchange.request.method;
    vetted.headers.clear();
    if (exchange.close) vetted.set_header("Connection", "close");
    vetted.progress = ExchangeLink{&exchange};
  };
  const bool accepted = process_request(stream, false, closed, set_up);
  if (!exchange.answered) {  // httplib can't read the target; its own answer is dropped
    exchange.head = Problem{.code = Code::bad_request, .message = "the request target is damaged"};
    return send(exchange, socket, true);
  }
  const bool written = accepted && stream.flush();
  log_access(exchange);
  if (written && !exchange.close) return true;
  if (written && exchange.unread) exchange.connection.linger();
  return false;
}

void Transport::Server::fill_request(Exchange& exchange, httplib::Request& vetted) const {
  auto& request = exchange.request;
  const auto* const head = std::get_if<Head>(&exchange.head);
  if (head == nullptr) {
    request.method = "GET";
    return;
  }
  request.method = head->method;
  request.path = std::move(vetted.path);
  request.headers = head->headers;
  for (auto& [name, value] : vetted.params) request.query.emplace_back(name, value);
}

void Transport::Server::answer(Exchange& exchange) {
  exchange.answered = true;
  app_.identify(exchange.request);
  std::string what = "an exception that is not a std::exception";
  try {
    exchange.response = answer_or_throw(exchange);
    exchange.bytes = exchange.response.body.size();
    if (!exchange.response.defect.empty())
      log_.defect(exchange.request.id, exchange.response.defect);
    return;
  } catch (const std::exception& exception) {
    what = exception.what();
  } catch (...) {
  }
  log_.defect(exchange.request.id, what);
  exchange.close = true;
  exchange.response = app_.refuse(
      Problem{.code = Code::defect, .message = "the log has more under this request id"},
      exchange.request);
  exchange.bytes = exchange.response.body.size();
}

Response Transport::Server::answer_or_throw(Exchange& exchange) {
  const auto& request = exchange.request;
  exchange.unread = true;
  if (const auto* const problem = std::get_if<Problem>(&exchange.head))
    return app_.refuse(*problem, request);
  const auto& head = std::get<Head>(exchange.head);
  exchange.unread = head.has_body();
  auto entry = app_.enter(request);
  if (auto* const refusal = std::get_if<Response>(&entry)) {
    exchange.close = !head.keep_alive || exchange.unread;
    return std::move(*refusal);
  }
  auto& passage = std::get<App::Passage>(entry);
  Request whole = request;
  if (!passage.endpoint->consumes.empty()) {
    const auto status = exchange.connection.read_body(head, whole.body);
    if (!status) return app_.refuse(status.error(), request);
    exchange.unread = false;
  }
  exchange.close = !head.keep_alive || exchange.unread;
  return app_.answer(std::move(passage), std::move(whole));
}

void Transport::Server::log_access(const Exchange& exchange) {
  const std::chrono::duration<double, std::milli> duration = Clock::now() - exchange.start;
  log_.access({.id = exchange.request.id,
               .method = exchange.request.method,
               .path = exchange.request.path,
               .status = exchange.response.status,
               .bytes = exchange.bytes,
               .duration_ms = duration.count(),
               .cl = exchange.response.cl});
}

Transport::Transport(App& app, Log& log, const TransportLimits& limits)
    : server_{std::make_unique<Server>(app, log, limits)} {}
Transport::~Transport() = default;

Result<int> Transport::bind(const std::string& host, int port) { return server_->bind(host, port); }
void Transport::run() { server_->run(); }
void Transport::stop() { server_->drain(); }

}  // namespace pentapost::server
