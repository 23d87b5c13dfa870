#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pentapost::server {

/// What a process ends with.
enum ExitCode : int {
  exit_ok = 0,
  exit_usage = 1,
  exit_bad_input = 2,     ///< the CL data or the job
  exit_not_possible = 3,  ///< on this machine
  exit_defect = 4,
  exit_input_output = 5,
};

struct ServeOptions {
  std::string host = "127.0.0.1";
  int port = 8080;            ///< 0: any free one
  std::string machines = {};  ///< folder; empty: the one of this installation
  std::uint64_t body_limit_mib = 256;
  int threads = 0;       ///< jobs that compute at once; 0: one a processor
  int queue = 16;        ///< jobs admitted beyond these
  int connections = 64;  ///< served at once
  bool skip_bad_machines = false;
  bool check = false;  ///< only load the machines
};

/// A job on the command line.
struct JobFileOptions {
  std::string file;  ///< "-": standard input
  std::string machines = {};
  bool skip_bad_machines = false;
  std::optional<std::string> machine = {}, tip_mm = {}, axis_deg = {}, cl_units = {};
  std::string job = {};  ///< file with the JSON job; empty: none
};

struct PostFileOptions : JobFileOptions {
  std::optional<std::string> output = {}, dialect = {}, program_name = {};
  std::string report = {};  ///< empty: standard error
  std::string out = {};     ///< empty: standard output
};

struct AnalyseFileOptions : JobFileOptions {
  std::optional<std::string> zone_share = {}, nc_dialect = {};
  bool nc = false;  ///< the file is an NC program
};

struct ReorientFileOptions : JobFileOptions {
  std::optional<std::string> objective = {}, max_tilt_deg = {}, setup_accuracy_deg = {};
};

struct CompareFileOptions : JobFileOptions {
  std::vector<std::string> compared = {};  ///< NAME or NAME@VERSION; empty: all, or as the job
  std::optional<std::string> zone_share = {};
  bool reorient = false;
};

struct MachinesOptions {
  std::string machines = {};
};
struct DialectsOptions {};
struct VersionOptions {};

using Command = std::variant<ServeOptions, PostFileOptions, AnalyseFileOptions, ReorientFileOptions,
                             CompareFileOptions, MachinesOptions, DialectsOptions, VersionOptions>;

/// Reads the command line and the PENTAPOST_... environment.
///
/// @return the command; or the exit code, where there is none to run (help, or wrong usage, both
///         printed).
std::variant<Command, ExitCode> read_options(int argument_count, const char* const* arguments);

}  // namespace pentapost::server
