#pragma once

#include "pentapost/core/result.hpp"
#include "server/endpoints.hpp"
#include "server/http/admission.hpp"
#include "server/http/message.hpp"
#include "server/services.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pentapost::server {

struct AppLimits {
  int running_jobs = 2;   ///< that compute at once
  int waiting_jobs = 16;  ///< admitted beyond these
};

/// The service without its sockets. Safe to call from all threads.
class App {
 public:
  App(Services services, const AppLimits& limits);

  /// Permission to read a request's body and to answer it.
  struct Passage {
    const Endpoint* endpoint;
    std::vector<std::string> names;
    std::string_view media_type;
    std::optional<Admission::Ticket> ticket;  ///< of a job
  };

  /// Gives the request its id: the client's where it is usable, otherwise a new one.
  void identify(Request& request) const;
  /// Decides by the head alone: where the answer is a refusal, the body need not be read.
  std::variant<Passage, Response> enter(const Request& request);
  Response answer(Passage passage, Request request);
  /// The answer to a request that failed.
  Response refuse(const Problem& problem, const Request& request) const;

  /// All of it, for a request whose body is at hand.
  Response handle(Request request);

 private:
  Response finished(Response response, const Request& request) const;

  Services services_;
  Admission admission_;
};

}  // namespace pentapost::server
