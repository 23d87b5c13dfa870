#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "server/app.hpp"
#include "server/commands.hpp"
#include "server/http/transport.hpp"
#include "server/log.hpp"
#include "server/machine_folder.hpp"
#include "server/request_ids.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <iostream>
#include <thread>
#include <utility>

namespace pentapost::server {
namespace {

sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  return signals;
}

int running_jobs(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Serves until a signal, then answers what is under way; a second signal ends the process at once.
void serve_until_signal(Transport& transport, Log& log) {
  const auto signals = ending_signals();
  std::atomic<bool> draining = false;
  std::thread server{[&] {
    transport.run();
    if (!draining) ::kill(::getpid(), SIGTERM);  // the port was lost: ends the wait below
  }};
  int signal = 0;
  sigwait(&signals, &signal);
  draining = true;
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  log.info("draining", {{"signal", std::int64_t{signal}}});
  transport.stop();
  server.join();
}

}  // namespace

ExitCode run(const ServeOptions& options) {
  const auto signals = ending_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // before any thread, so that all inherit it

  const auto folder = machine_folder(options.machines);
  auto machines = load_library(folder, options.skip_bad_machines);
  if (!machines) return exit_input_output;
  const auto machine_count = static_cast<std::int64_t>(machines->names().size());
  if (options.check) {
    std::cout << machine_count << " machines in " << folder.string() << '\n';
    return exit_ok;
  }
  Log log;
  App app{{.machines = std::move(*machines),
           .post = jobs::post,
           .analyse = jobs::analyse,
           .reorient = jobs::reorient,
           .compare = jobs::compare,
           .next_request_id = random_request_ids()},
          {.running_jobs = running_jobs(options.threads), .waiting_jobs = options.queue}};
  TransportLimits limits;
  limits.body_bytes = options.body_limit_mib << 20;
  limits.connection_threads = options.connections;
  Transport transport{app, log, limits};
  const auto port = transport.bind(options.host, options.port);
  if (!port) {
    log.error("not_listening", {{"reason", port.error().message}});
    return exit_input_output;
  }
  log.info("listening", {{"host", options.host},
                         {"port", std::int64_t{*port}},
                         {"machines", folder.string()},
                         {"machine_count", machine_count},
                         {"body_limit_mib", static_cast<std::int64_t>(options.body_limit_mib)},
                         {"running_jobs", std::int64_t{running_jobs(options.threads)}},
                         {"waiting_jobs", std::int64_t{options.queue}},
                         {"connections", std::int64_t{options.connections}}});
  serve_until_signal(transport, log);
  log.info("ended");
  return exit_ok;
}

}  // namespace pentapost::server
