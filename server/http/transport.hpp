#pragma once

#include "pentapost/core/result.hpp"
#include "server/app.hpp"
#include "server/http/connection.hpp"
#include "server/log.hpp"

#include <memory>
#include <string>

namespace pentapost::server {

/// Carries the App over HTTP/1.1 on one port.
class Transport {
 public:
  /// `app` and `log` must outlive it.
  Transport(App& app, Log& log, const TransportLimits& limits);
  ~Transport();

  /// Takes a port, alone: a second process on the same one is refused.
  /// @param port  0: any free one.
  /// @return the port; Problem out_of_domain where it can't be had.
  Result<int> bind(const std::string& host, int port);
  /// Serves until stop(). Call it once, after bind().
  void run();
  /// Takes no further connections; run() returns when all that is under way is answered. From any
  /// thread.
  void stop();

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace pentapost::server
