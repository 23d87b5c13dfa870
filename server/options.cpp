#include "server/options.hpp"

#include <CLI/CLI.hpp>

#include <iostream>
#include <string>
#include <string_view>

namespace pentapost::server {
namespace {

constexpr auto exit_codes =
    "Exit codes: 0 done; 1 wrong usage; 2 the CL data or the job are wrong; 3 this machine can't\n"
    "do it; 4 a defect of the program; 5 a file or a port can't be used.";

void add_machines(CLI::App& command, std::string& machines) {
  command
      .add_option("--machines", machines,
                  "Folder of machine definitions [default: share/pentapost/machines beside the "
                  "program's folder, or the source tree's]")
      ->type_name("DIR")
      ->envname("PENTAPOST_MACHINES");
}

void add_skip(CLI::App& command, bool& skip) {
  command
      .add_flag(
          "--skip-bad-machines", skip,
          "Go on without definitions that are not usable [default: off, they end the program]")
      ->envname("PENTAPOST_SKIP_BAD_MACHINES");
}

CLI::App* add_serve(CLI::App& app, ServeOptions& options) {
  auto* const command = app.add_subcommand("serve", "Serve HTTP until SIGTERM or SIGINT");
  command->add_option("--host", options.host, "Address to listen on")
      ->envname("PENTAPOST_HOST")
      ->capture_default_str();
  command->add_option("--port", options.port, "Port to listen on; 0: any free one, see the log")
      ->envname("PENTAPOST_PORT")
      ->check(CLI::Range(0, 65'535))
      ->capture_default_str();
  add_machines(*command, options.machines);
  command->add_option("--body-limit-mib", options.body_limit_mib, "Largest request body, in MiB")
      ->envname("PENTAPOST_BODY_LIMIT_MIB")
      ->check(CLI::Range(1, 65'536))
      ->capture_default_str();
  command->add_option("--threads", options.threads, "Jobs that compute at once; 0: one a processor")
      ->envname("PENTAPOST_THREADS")
      ->check(CLI::Range(0, 1'024))
      ->capture_default_str();
  command->add_option("--queue", options.queue, "Jobs admitted beyond these; more get 503")
      ->envname("PENTAPOST_QUEUE")
      ->check(CLI::Range(0, 100'000))
      ->capture_default_str();
  command->add_option("--connections", options.connections, "Connections served at once")
      ->envname("PENTAPOST_CONNECTIONS")
      ->check(CLI::Range(1, 4'096))
      ->capture_default_str();
  add_skip(*command, options.skip_bad_machines);
  command->add_flag("--check", options.check,
                    "Load the machines, say what is wrong with them, and end [default: off]");
  command->footer(exit_codes);
  return command;
}

void add_one_machine(CLI::App& command, JobFileOptions& options) {
  command
      .add_option("--machine", options.machine,
                  "NAME or NAME@VERSION. Needed unless the job has it")
      ->envname("PENTAPOST_MACHINE");
}

/// All but the machine.
void add_job(CLI::App& command, JobFileOptions& options) {
  command.add_option("FILE", options.file,
                     "CL file; -: standard input. Needed unless the job has its own path");
  add_machines(command, options.machines);
  add_skip(command, options.skip_bad_machines);
  command.add_option("--tip-mm", options.tip_mm,
                     "Tolerance of the tool tip, at most 1 [default: 0.01]");
  command.add_option("--axis-deg", options.axis_deg,
                     "Tolerance of the tool axis, at most 5 [default: 0.05]");
  command.add_option("--cl-units", options.cl_units, "mm or inch [default: as the file]");
  command.add_option("--job", options.job, "The other keys of a job, as JSON [default: none]")
      ->type_name("JOB.json");
  command.footer(exit_codes);
}

CLI::App* add_post(CLI::App& app, PostFileOptions& options) {
  auto* const command =
      app.add_subcommand("post", "Post one CL file: NC program on stdout, report on stderr");
  add_job(*command, options);
  add_one_machine(*command, options);
  command->add_option("--output", options.output, "tcp or axes [default: as the machine]");
  command->add_option("--dialect", options.dialect, "Controller dialect [default: as the machine]");
  command->add_option("--program-name", options.program_name,
                      "[default: from PARTNO, else FILE without its ending]");
  command->add_option("--report", options.report, "File for the report [default: stderr]")
      ->type_name("FILE");
  command->add_option("--out", options.out, "File for the NC program [default: stdout]")
      ->type_name("FILE");
  return command;
}

CLI::App* add_analyse(CLI::App& app, AnalyseFileOptions& options) {
  auto* const command = app.add_subcommand(
      "analyse",
      "Analyse one CL file, or NC program, on a machine: singular zones, axis speeds, times, as "
      "JSON");
  add_job(*command, options);
  add_one_machine(*command, options);
  command->add_option("--zone-share", options.zone_share,
                      "Share of a speed limit from which a stretch is a zone [default: 1]");
  auto* const nc =
      command->add_flag("--nc", options.nc, "FILE is an NC program [default: off, CL data]");
  command
      ->add_option("--nc-dialect", options.nc_dialect,
                   "Controller dialect of the NC program [default: as the machine]")
      ->needs(nc);
  return command;
}

CLI::App* add_reorient(CLI::App& app, ReorientFileOptions& options) {
  auto* const command = app.add_subcommand(
      "reorient", "Find how to clamp the part so that singularities are out of the way, as JSON");
  add_job(*command, options);
  add_one_machine(*command, options);
  command->add_option("--objective", options.objective,
                      "peak_ratio, time or rotary_travel [default: peak_ratio]");
  command->add_option("--max-tilt-deg", options.max_tilt_deg,
                      "Largest tilt of the part, at most 180 [default: 30]");
  command->add_option("--setup-accuracy-deg", options.setup_accuracy_deg,
                      "How exactly the part can be clamped, at most 5 [default: 0.02]");
  return command;
}

CLI::App* add_compare(CLI::App& app, CompareFileOptions& options) {
  auto* const command = app.add_subcommand(
      "compare", "Compare machines for one CL file: possible or why not, times, limits, as JSON");
  add_job(*command, options);
  command
      ->add_option("--machine", options.compared,
                   "NAME or NAME@VERSION, several with commas between [default: as the job, else "
                   "all]")
      ->delimiter(',');
  command->add_option("--zone-share", options.zone_share,
                      "Share of a speed limit from which a stretch is a zone [default: 1]");
  command->add_flag("--reorient", options.reorient,
                    "Find the best setup on each machine too [default: off, or as the job]");
  return command;
}

std::string subcommand_names(const CLI::App& app) {
  std::string names;
  for (const auto* const command : app.get_subcommands(nullptr))
    names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

}  // namespace

std::variant<Command, ExitCode> read_options(int argument_count, const char* const* arguments) {
  CLI::App app{"Pentapost: five-axis CL data in, proven NC programs out.", "pentapost"};
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Help of all commands");
  app.footer(exit_codes);
  ServeOptions serve;
  PostFileOptions post;
  AnalyseFileOptions analyse;
  ReorientFileOptions reorient;
  CompareFileOptions compare;
  MachinesOptions machines;
  const auto* const serve_command = add_serve(app, serve);
  const auto* const post_command = add_post(app, post);
  const auto* const analyse_command = add_analyse(app, analyse);
  const auto* const reorient_command = add_reorient(app, reorient);
  const auto* const compare_command = add_compare(app, compare);
  auto* const machines_command = app.add_subcommand("machines", "List the machines");
  add_machines(*machines_command, machines.machines);
  const auto* const dialects_command =
      app.add_subcommand("dialects", "List the controller dialects and their options");
  app.add_subcommand("version", "Print the version");
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::ParseError& error) {
    if (app.exit(error, std::cout, std::cerr) == 0) return exit_ok;
    const std::string_view first = argument_count > 1 ? arguments[1] : "";
    if (app.get_subcommands().empty() && !first.empty() && !first.starts_with('-'))
      std::cerr << first << " is no subcommand.\n";
    if (app.get_subcommands().empty())
      std::cerr << "The subcommands are: " << subcommand_names(app) << '\n';
    return exit_usage;
  }
  if (serve_command->parsed()) return Command{serve};
  if (post_command->parsed()) return Command{post};
  if (analyse_command->parsed()) return Command{analyse};
  if (reorient_command->parsed()) return Command{reorient};
  if (compare_command->parsed()) return Command{compare};
  if (machines_command->parsed()) return Command{machines};
  if (dialects_command->parsed()) return Command{DialectsOptions{}};
  return Command{VersionOptions{}};
}

}  // namespace pentapost::server
