#include "pentapost/jobs/post.hpp"
#include "pentapost/nc/dialect.hpp"
#include "server/commands.hpp"
#include "server/dialect_names.hpp"
#include "server/json/job_json.hpp"
#include "server/json/problem_json.hpp"
#include "server/json/report_json.hpp"
#include "server/machine_folder.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>

namespace pentapost::server {
namespace {

std::optional<std::string> read_stream(std::istream& stream) {
  std::string text{std::istreambuf_iterator<char>{stream}, {}};
  if (stream.bad()) return std::nullopt;
  return text;
}

/// The bytes of a file ("-": standard input); nullopt: not readable, said on stderr.
std::optional<std::string> read_file(const std::string& name) {
  if (name == "-") return read_stream(std::cin);
  std::ifstream file{name, std::ios::binary};
  std::error_code error;
  const auto size = std::filesystem::file_size(name, error);
  std::string text;
  if (file && !error) {
    text.resize(size);
    file.read(text.data(), static_cast<std::streamsize>(size));
  } else if (file && !std::filesystem::is_directory(name, error)) {  // a pipe has no size
    auto piped = read_stream(file);
    if (piped) return piped;
  } else {
    file.setstate(std::ios::failbit);
  }
  if (file) return text;
  std::cerr << "pentapost: cannot read " << name << '\n';
  return std::nullopt;
}

bool write_to(const std::filesystem::path& name, std::string_view text) {
  std::ofstream file{name, std::ios::binary | std::ios::trunc};
  file << text << std::flush;
  return static_cast<bool>(file);
}

/// Writes a whole file or none: the text goes beside it first. What is no file, such as a pipe or
/// /dev/null, is written to; a symbolic link stays one.
bool write_file(const std::string& name, std::string_view text) {
  std::error_code error;
  const auto place = std::filesystem::weakly_canonical(name, error);
  bool written = !error;
  if (written && std::filesystem::exists(place, error) &&
      !std::filesystem::is_regular_file(place, error)) {
    written = write_to(place, text);
  } else if (written) {
    const std::filesystem::path part = place.string() + ".part";
    written = write_to(part, text);
    if (written) std::filesystem::rename(part, place, error);
    written = written && !error;
    if (!written) std::filesystem::remove(part, error);
  }
  if (!written) std::cerr << "pentapost: cannot write " << name << '\n';
  return written;
}

/// Writes to a file, or to `stream` where it has no name.
bool write_text(const std::string& name, std::ostream& stream, std::string_view text) {
  if (!name.empty()) return write_file(name, text);
  stream << text << std::flush;
  if (!stream) std::cerr << "pentapost: cannot write to standard output\n";
  return static_cast<bool>(stream);
}

std::optional<JobParts> parts_of(const PostFileOptions& options) {
  JobParts parts;
  if (!options.job.empty() && !(parts.json = read_file(options.job))) return std::nullopt;
  if (!options.file.empty() && !(parts.cl = read_file(options.file))) return std::nullopt;
  const auto add = [&parts](const char* name, const std::optional<std::string>& value) {
    if (value) parts.words.emplace_back(name, *value);
  };
  add("machine", options.machine);
  add("output", options.output);
  add("dialect", options.dialect);
  add("tip_mm", options.tip_mm);
  add("axis_deg", options.axis_deg);
  add("cl_units", options.cl_units);
  add("program_name", options.program_name);
  return parts;
}

ExitCode exit_code_of(Code code) {
  const int status = status_of(code);
  if (status >= 500) return exit_defect;
  return status == 422 ? exit_not_possible : exit_bad_input;
}

/// Says on stderr, or in the report's file, why there is no program.
ExitCode fail(const Problem& problem, const std::string& report) {
  const auto text = problem_response(problem, "").body + '\n';
  if (!write_text(report, std::cerr, text)) return exit_input_output;
  if (!report.empty()) std::cerr << "pentapost: " << problem.message << '\n';
  return exit_code_of(problem.code);
}

std::string text_of(const machine::OptionValue& value) {
  std::ostringstream text;
  if (const auto* flag = std::get_if<bool>(&value)) text << (*flag ? "true" : "false");
  if (const auto* number = std::get_if<double>(&value)) text << *number;
  if (const auto* word = std::get_if<std::string>(&value)) text << '"' << *word << '"';
  if (const auto* lines = std::get_if<std::vector<std::string>>(&value))
    for (const auto& line : *lines) text << '"' << line << "\" ";
  return text.str();
}

}  // namespace

ExitCode run(const PostFileOptions& options) {
  auto parts = parts_of(options);
  if (!parts) return exit_input_output;
  const auto machines = load_library(machine_folder(options.machines), options.skip_bad_machines);
  if (!machines) return exit_input_output;
  const auto dialects = dialect_names();
  const auto job = read_job(std::move(*parts), {.machines = *machines, .dialects = dialects});
  if (!job) return fail(job.error(), options.report);
  const auto report = jobs::post(*job);
  if (!report) return fail(report.error(), options.report);
  const bool written = write_text(options.out, std::cout, report->nc) &&
                       write_text(options.report, std::cerr, report_json(*report) + '\n');
  return written ? exit_ok : exit_input_output;
}

ExitCode run(const MachinesOptions& options) {
  const auto machines = load_library(machine_folder(options.machines), false);
  if (!machines) return exit_input_output;
  for (const auto& name : machines->names()) {
    const auto& definition = machines->find(name)->definition;
    std::cout << name << '@' << definition.version << '\t' << definition.controller.dialect << '\t'
              << definition.title << '\n';
  }
  return exit_ok;
}

ExitCode run(const DialectsOptions&) {
  for (const auto* dialect : nc::dialects()) {
    std::cout << dialect->name << '\t' << dialect->title << '\n';
    for (const auto& option : dialect->options) {
      std::cout << "  " << option.name << " = " << text_of(option.default_value) << '\n'
                << "      " << option.description << '\n';
    }
  }
  return exit_ok;
}

ExitCode run(const VersionOptions&) {
  std::cout << "pentapost " << PENTAPOST_VERSION << '\n';
  return exit_ok;
}

}  // namespace pentapost::server
