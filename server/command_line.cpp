#include "pentapost/jobs/analyse.hpp"
#include "pentapost/jobs/compare.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "pentapost/nc/dialect.hpp"
#include "server/commands.hpp"
#include "server/dialect_names.hpp"
#include "server/json/analysis_json.hpp"
#include "server/json/compare_json.hpp"
#include "server/json/job_json.hpp"
#include "server/json/name_text.hpp"
#include "server/json/problem_json.hpp"
#include "server/json/reorient_json.hpp"
#include "server/json/report_json.hpp"
#include "server/machine_folder.hpp"
#include "server/text_files.hpp"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pentapost::server {
namespace {

using Word = std::pair<const char*, const std::optional<std::string>&>;

/// @param own_words  that the command has beside those of every job.
std::optional<JobParts> parts_of(const JobFileOptions& options,
                                 std::initializer_list<Word> own_words) {
  JobParts parts;
  if (!options.job.empty() && !(parts.json = read_file(options.job))) return std::nullopt;
  if (!options.file.empty() && !(parts.cl = read_file(options.file))) return std::nullopt;
  if (options.file != "-") parts.cl_file_name = options.file;
  const auto add = [&parts](const Word& word) {
    if (word.second) parts.words.emplace_back(word.first, *word.second);
  };
  add({"machine", options.machine});
  add({"tip_mm", options.tip_mm});
  add({"axis_deg", options.axis_deg});
  add({"cl_units", options.cl_units});
  for (const Word& word : own_words) add(word);
  return parts;
}

/// What is wrong with the inputs of a command; empty: nothing.
std::string misuse_of_inputs(const JobFileOptions& options) {
  if (options.file.empty() && options.job.empty()) return "give FILE or - for standard input";
  if (options.file == "-" && options.job == "-")
    return "FILE and --job cannot both be standard input";
  return {};
}

/// The same of a command for one machine.
std::string misuse_of(const JobFileOptions& options) {
  if (options.file.empty() && options.job.empty()) return misuse_of_inputs(options);
  if (!options.machine && options.job.empty())
    return "give --machine NAME; the command pentapost machines lists them";
  return misuse_of_inputs(options);
}

/// The word for a flag; nullopt: not set.
std::optional<std::string> word_of(bool flag) {
  return flag ? std::optional<std::string>{"true"} : std::nullopt;
}

/// The word for a list; nullopt: empty.
std::optional<std::string> word_of(const std::vector<std::string>& names) {
  return names.empty() ? std::nullopt : std::optional{joined(names)};
}

std::string misuse_of(const PostFileOptions& options) {
  if (auto misuse = misuse_of(static_cast<const JobFileOptions&>(options)); !misuse.empty())
    return misuse;
  const auto standard = [](const std::string& name) { return name == "-" ? std::string{} : name; };
  const std::array<std::pair<std::string_view, std::string>, 4> files{
      {{"FILE", standard(options.file)},
       {"--job", standard(options.job)},
       {"--out", options.out},
       {"--report", options.report}}};
  constexpr std::size_t first_output = 2;
  for (std::size_t output = first_output; output < files.size(); ++output)
    for (std::size_t other = 0; other < output; ++other)
      if (is_same_file(files[output].second, files[other].second))
        return std::string{files[output].first}.append(" and ").append(files[other].first) +
               " are the same file, " + files[output].second;
  return {};
}

ExitCode exit_code_of(Code code) {
  const int status = status_of(code);
  if (status >= 500) return exit_defect;
  return status == 422 ? exit_not_possible : exit_bad_input;
}

/// Says on stderr, or in the report's file, why there is no answer.
ExitCode fail(const Problem& problem, const std::string& report) {
  TextOutput output{report, std::cerr, problem_response(problem, "").body + '\n'};
  if (!output.prepare() || !output.finish()) return exit_input_output;
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
  if (const auto misuse = misuse_of(options); !misuse.empty()) {
    std::cerr << "pentapost post: " << misuse << '\n';
    return exit_usage;
  }
  auto parts = parts_of(options, {{"output", options.output},
                                  {"dialect", options.dialect},
                                  {"program_name", options.program_name}});
  if (!parts) return exit_input_output;
  const auto machines = load_library(machine_folder(options.machines), options.skip_bad_machines);
  if (!machines) return exit_input_output;
  const auto dialects = dialect_names();
  auto job = read_post_job(std::move(*parts), {.machines = *machines, .dialects = dialects});
  if (!job) return fail(job.error(), options.report);
  job->post.lint = true;
  auto report = jobs::post(*job);
  if (!report) return fail(placed_in_request(report.error(), *job, *machines), options.report);
  TextOutput report_output{options.report, std::cerr, report_json(*report) + '\n'};
  TextOutput program_output{options.out, std::cout, std::move(report->nc)};
  const bool written = report_output.prepare() && program_output.prepare() &&
                       program_output.finish() && report_output.finish();
  return written ? exit_ok : exit_input_output;
}

ExitCode run(const AnalyseFileOptions& options) {
  if (const auto misuse = misuse_of(options); !misuse.empty()) {
    std::cerr << "pentapost analyse: " << misuse << '\n';
    return exit_usage;
  }
  auto parts =
      parts_of(options, {{"zone_share", options.zone_share}, {"nc_dialect", options.nc_dialect}});
  if (!parts) return exit_input_output;
  if (options.nc) parts->nc = std::exchange(parts->cl, std::nullopt);
  const auto machines = load_library(machine_folder(options.machines), options.skip_bad_machines);
  if (!machines) return exit_input_output;
  const auto dialects = dialect_names();
  const auto job =
      read_analyse_job(std::move(*parts), {.machines = *machines, .dialects = dialects});
  if (!job) return fail(job.error(), {});
  const auto report = jobs::analyse(*job);
  if (!report) return fail(placed_in_request(report.error(), job->job, *machines), {});
  TextOutput output{{}, std::cout, analysis_json(*report) + '\n'};
  return output.prepare() && output.finish() ? exit_ok : exit_input_output;
}

ExitCode run(const ReorientFileOptions& options) {
  if (const auto misuse = misuse_of(options); !misuse.empty()) {
    std::cerr << "pentapost reorient: " << misuse << '\n';
    return exit_usage;
  }
  auto parts = parts_of(options, {{"objective", options.objective},
                                  {"max_tilt_deg", options.max_tilt_deg},
                                  {"setup_accuracy_deg", options.setup_accuracy_deg}});
  if (!parts) return exit_input_output;
  const auto machines = load_library(machine_folder(options.machines), options.skip_bad_machines);
  if (!machines) return exit_input_output;
  const auto dialects = dialect_names();
  const auto job =
      read_reorient_job(std::move(*parts), {.machines = *machines, .dialects = dialects});
  if (!job) return fail(job.error(), {});
  const auto report = jobs::reorient(*job);
  if (!report) return fail(placed_in_request(report.error(), job->job, *machines), {});
  TextOutput output{{}, std::cout, reorient_json(*report) + '\n'};
  return output.prepare() && output.finish() ? exit_ok : exit_input_output;
}

ExitCode run(const CompareFileOptions& options) {
  if (const auto misuse = misuse_of_inputs(options); !misuse.empty()) {
    std::cerr << "pentapost compare: " << misuse << '\n';
    return exit_usage;
  }
  const auto compared = word_of(options.compared);
  const auto reorient = word_of(options.reorient);
  auto parts = parts_of(
      options,
      {{"machines", compared}, {"zone_share", options.zone_share}, {"reorient", reorient}});
  if (!parts) return exit_input_output;
  const auto machines = load_library(machine_folder(options.machines), options.skip_bad_machines);
  if (!machines) return exit_input_output;
  const auto dialects = dialect_names();
  const auto job =
      read_compare_job(std::move(*parts), {.machines = *machines, .dialects = dialects});
  if (!job) return fail(job.error(), {});
  const auto report = jobs::compare(*job);
  if (!report) return fail(placed_in_request(report.error(), job->job, *machines), {});
  TextOutput output{{}, std::cout, compare_json(*report, *machines) + '\n'};
  if (!output.prepare() || !output.finish()) return exit_input_output;
  const auto defects = defects_of(*report);
  if (defects.empty()) return exit_ok;
  std::cerr << "pentapost: " << defects << '\n';
  return exit_defect;
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
