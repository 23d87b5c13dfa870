#include "server/json/job_json.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/json/definition_json.hpp"
#include "pentapost/json/strict_reader.hpp"
#include "server/json/job_source.hpp"
#include "server/json/name_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

namespace pentapost::server {
namespace {

using json::Domain;
using json::Object;
using namespace std::string_view_literals;

constexpr std::array output_words{"tcp"sv, "axes"sv};
constexpr std::array unit_words{"mm"sv, "inch"sv};
constexpr std::array tilt_words{"positive"sv, "negative"sv};
constexpr std::int64_t largest_tool_number = 999'999'999;
constexpr double largest_length_mm = 1e6;  // as far as a tool path may reach
constexpr Domain tip_domain{
    .lower = 0.0, .upper = jobs::largest_tip_tolerance_mm, .lower_open = true};
constexpr Domain axis_domain{
    .lower = 0.0, .upper = jobs::largest_axis_tolerance_deg, .lower_open = true};
constexpr auto pole_axis_domain = Domain::between(0.0, jobs::largest_pole_axis_deg);
constexpr auto setup_angle_domain =
    Domain::between(-jobs::largest_setup_angle_deg, jobs::largest_setup_angle_deg);

constexpr std::size_t default_samples = 2000;
// Keys of POST /analyse alone.
constexpr auto zone_share_key = "zone_share"sv, nc_dialect_key = "nc_dialect"sv;
constexpr std::array analysis_words{zone_share_key, nc_dialect_key};

enum class Operation { post, analyse };

/// Reads one job. The first failure is kept; readers go on with defaults after it.
class JobReader {
 public:
  JobReader(json::Document& document, const JobParts& parts, const JobContext& context,
            Operation operation)
      : document_{document},
        source_{document, parts},
        parts_{parts},
        context_{context},
        operation_{operation} {}

  /// What the operation has no key for keeps its default.
  Result<jobs::AnalyseJob> read();

 private:
  std::optional<machine::Definition> machine_of(const Object& job);
  std::optional<std::string> dialect(std::string_view name, const std::optional<Object>& object);
  bool takes_nc() const { return operation_ == Operation::analyse; }
  bool has_nc(const Object& job) const { return parts_.nc || (takes_nc() && job.has("nc")); }
  void read_nc(const Object& job, jobs::AnalyseJob& result);
  void read_path(const Object& job, jobs::PostJob& result);
  void read_cl(const Object& job, jobs::PostJob& result);
  void read_points(const Object& path, jobs::PostJob& result);
  void read_setup(const Object& job, jobs::Setup& setup);
  void read_tools(const Object& job, jobs::PostJob& result);
  void read_tolerances(const Object& job, jobs::Tolerances& tolerances);
  void read_post(const Object& job, jobs::PostOptions& post);
  void read_prefer(const Object& prefer, jobs::PostOptions& post);
  void read_limits(const Object& job, jobs::PostJob& result);
  void read_analysis(const Object& job, jobs::AnalyseJob& result);

  json::Document& document_;
  JobSource source_;
  const JobParts& parts_;
  const JobContext& context_;
  Operation operation_;
};

/// The name of a controller dialect.
std::optional<std::string> JobReader::dialect(std::string_view name,
                                              const std::optional<Object>& object) {
  auto found = source_.text(name, object);
  if (found && std::ranges::find(context_.dialects, *found) == context_.dialects.end())
    source_.fail(Code::unknown_dialect, word_pointer(name),
                 "found " + quoted(*found) + ", expected one of " +
                     joined({context_.dialects.begin(), context_.dialects.end()}));
  return found;
}

std::optional<machine::Definition> JobReader::machine_of(const Object& job) {
  std::optional<std::string> name;
  if (const auto* found = source_.word("machine", job, "machine")) {
    name = *found;
  } else {
    const auto inline_or_name = job.value("machine");
    if (inline_or_name.is_object()) {
      auto definition = json::definition_from_text(inline_or_name.object().text_in(*parts_.json),
                                                   context_.dialects, "/machine");
      if (definition) return std::move(definition).value();
      source_.fail(std::move(definition).error());
      return std::nullopt;
    }
    if (document_.problem()) return std::nullopt;
    if (!inline_or_name.is_string())
      inline_or_name.fail(Code::wrong_type,
                          "expected a string, name or name@version, or an object, a definition");
    name = inline_or_name.string();
  }
  if (document_.problem()) return std::nullopt;
  const auto entry = find_machine(context_.machines, *name);
  if (entry) return (*entry)->definition;
  source_.fail(entry.error().code, "/machine", entry.error().message);
  return std::nullopt;
}

void JobReader::read_nc(const Object& job, jobs::AnalyseJob& result) {
  const auto exclude = [&](std::string_view key, bool is_given) {
    if (is_given)
      source_.fail(Code::conflicting_keys, std::string{"/"}.append(key),
                   "the job has nc, which excludes it");
  };
  exclude("cl", parts_.cl.has_value());
  for (const auto key : {"cl"sv, "path"sv, "cl_units"sv, "cl_dialect"sv})
    exclude(key, job.optional_value(key) || find_field(parts_.words, key) != nullptr);
  if (parts_.nc && job.has("nc"))
    return source_.fail(Code::conflicting_keys, "/nc", "it stands in the job and beside it");
  result.nc = jobs::NcProgram{.text = {}, .dialect = dialect(nc_dialect_key, job)};
  if (!parts_.nc) result.nc->text = job.take_string("nc");
}

void JobReader::read_path(const Object& job, jobs::PostJob& result) {
  // null counts as not given, with either form of the path.
  for (const auto key : {"cl"sv, "cl_units"sv, "cl_dialect"sv}) job.optional_value(key);
  const bool apart = parts_.cl.has_value();
  const int count = (apart ? 1 : 0) + (job.has("cl") ? 1 : 0) + (job.has("path") ? 1 : 0);
  if (count > 1)
    return source_.fail(Code::conflicting_keys, job.has("path") ? "/path" : "/cl",
                        "a job has exactly one of cl and path");
  const auto path = job.optional_object("path");
  if (path) {
    for (const auto key : {"cl_units"sv, "cl_dialect"sv}) {
      if (job.has(key))
        source_.fail(Code::conflicting_keys, std::string{"/"}.append(key),
                     "it belongs to cl, and the job has path");
    }
    if (find_field(parts_.words, "cl_units") != nullptr)
      source_.fail(Code::conflicting_keys, "/cl_units", "it belongs to cl, and the job has path");
    return read_points(*path, result);
  }
  read_cl(job, result);
}

void JobReader::read_cl(const Object& job, jobs::PostJob& result) {
  jobs::ClText cl;
  if (const auto unit = source_.choice("cl_units", job, "cl_units", unit_words))
    cl.units = *unit == 0 ? jobs::ClUnits::mm : jobs::ClUnits::inch;
  cl.dialect = job.optional_string("cl_dialect");
  if (!parts_.cl && job.has("cl")) cl.text = job.take_string("cl");
  result.path = std::move(cl);
}

void JobReader::read_points(const Object& path, jobs::PostJob& result) {
  jobs::PointPath points;
  points.feed_mm_min = path.number("feed_mm_min", Domain::positive());
  const auto rows = path.array("points");
  path.finish();
  if (document_.problem()) return;
  if (rows.size() == 0) return rows.fail(Code::no_motion, "there is no point");
  points.tip_mm.reserve(rows.size());
  points.axis.reserve(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = rows.at(i);
    const auto numbers = row.array().numbers(6);
    if (document_.problem()) return;
    points.tip_mm.emplace_back(numbers[0], numbers[1], numbers[2]);
    points.axis.emplace_back(numbers[3], numbers[4], numbers[5]);
    if (points.axis.back().isZero(0.0))
      return row.fail(Code::zero_tool_axis, "the tool axis is 0, 0, 0");
  }
  result.path = std::move(points);
}

void JobReader::read_setup(const Object& job, jobs::Setup& setup) {
  const auto object = job.optional_object("setup");
  if (!object) return;
  setup.origin_mm = object->optional_vector3("origin_mm");
  if (setup.origin_mm && setup.origin_mm->cwiseAbs().maxCoeff() > largest_length_mm)
    object->fail_at("origin_mm", Code::out_of_domain,
                    "found a coordinate beyond the largest, 1000000 mm");
  setup.theta_x_deg = object->optional_number("theta_x_deg", setup_angle_domain).value_or(0.0);
  setup.theta_z_deg = object->optional_number("theta_z_deg", setup_angle_domain).value_or(0.0);
  object->finish();
}

void JobReader::read_tools(const Object& job, jobs::PostJob& result) {
  const auto tools = job.optional_object("tools");
  if (!tools) return;
  for (const auto& key : tools->keys()) {
    const auto tool = tools->object(key);
    int number = 0;
    const char* const end = key.data() + key.size();
    const auto [stop, error] = std::from_chars(key.data(), end, number);
    if (error != std::errc{} || stop != end || number < 0 || number > largest_tool_number ||
        std::to_string(number) != key) {
      return tools->fail_at(key, Code::out_of_domain,
                            "a tool's key is its number, 0 to 999999999, without leading zeros");
    }
    if (const auto length =
            tool.optional_number("gauge_length_mm", Domain::between(0.0, largest_length_mm)))
      result.gauge_length_mm.emplace(number, *length);
    tool.finish();
  }
}

void JobReader::read_tolerances(const Object& job, jobs::Tolerances& tolerances) {
  const auto object = job.optional_object("tolerances");
  tolerances.tip_mm = source_.number("tip_mm", object, tip_domain).value_or(tolerances.tip_mm);
  tolerances.axis_deg =
      source_.number("axis_deg", object, axis_domain).value_or(tolerances.axis_deg);
  if (object) object->finish();
}

void JobReader::read_prefer(const Object& prefer, jobs::PostOptions& post) {
  machine::Preferences preferences;
  if (const auto tilt = prefer.optional_choice("tilt", tilt_words)) {
    preferences.tilt =
        *tilt == 0 ? machine::Preferences::Tilt::positive : machine::Preferences::Tilt::negative;
  }
  if (const auto window = prefer.optional_range("first_turn_deg")) {
    preferences.first_turn = Range<Angle>{.lower = Angle::degrees(window->lower),
                                          .upper = Angle::degrees(window->upper)};
  }
  prefer.finish();
  post.prefer = preferences;
}

void JobReader::read_post(const Object& job, jobs::PostOptions& post) {
  const auto object = job.optional_object("post");
  if (const auto output = source_.choice("output", object, "output", output_words))
    post.output = *output == 0 ? Output::tcp : Output::axes;
  post.dialect = dialect("dialect", object);
  post.program_name = source_.text("program_name", object);
  if (!object) return;
  post.zone_comments = object->optional_boolean("zone_comments").value_or(false);
  post.flank = object->optional_boolean("flank").value_or(false);
  post.pole_axis_deg = object->optional_number("pole_axis_deg", pole_axis_domain).value_or(0.0);
  if (const auto prefer = object->optional_object("prefer")) read_prefer(*prefer, post);
  object->finish();
}

/// The joint of that name; nullptr: the chain has none.
const machine::Joint* find_joint(const machine::Chain& chain, std::string_view name) {
  for (const auto joints : {chain.table(), chain.head()}) {
    const auto joint = std::ranges::find(joints, name, &machine::Joint::name);
    if (joint != joints.end()) return &*joint;
  }
  return nullptr;
}

void JobReader::read_limits(const Object& job, jobs::PostJob& result) {
  const auto limits = job.optional_object("limits");
  if (!limits) return;
  for (const auto& name : limits->keys()) {
    const auto object = limits->object(name);
    const auto* const joint = find_joint(result.machine.chain, name);
    if (joint == nullptr)
      return limits->fail_at(name, Code::out_of_domain, "the machine has no axis of that name");
    const std::string unit = joint->is_rotary() ? "deg" : "mm";
    const double factor = joint->is_rotary() ? rad_per_deg : 1.0;
    const auto limit = [&](const std::string& key) -> std::optional<double> {
      const auto number = object.optional_number(key, Domain::positive());
      return number ? std::optional{*number * factor} : std::nullopt;
    };
    result.limits.emplace(name, machine::AxisLimits{
                                    .max_speed = limit("max_speed_" + unit + "_s"),
                                    .max_acceleration = limit("max_acceleration_" + unit + "_s2"),
                                    .max_jerk = limit("max_jerk_" + unit + "_s3"),
                                });
    object.finish();
  }
}

void JobReader::read_analysis(const Object& job, jobs::AnalyseJob& result) {
  result.zone_share =
      source_.number(zone_share_key, job, Domain::positive()).value_or(result.zone_share);
  const bool wanted = job.optional_boolean("samples").value_or(false);
  const auto most =
      job.optional_integer("max_samples", static_cast<std::int64_t>(analysis::Samples::fewest),
                           static_cast<std::int64_t>(jobs::AnalyseJob::most_samples));
  if (most && !wanted)
    source_.fail(Code::conflicting_keys, "/max_samples",
                 "it belongs to samples, and none are asked for");
  if (wanted) result.samples = most ? static_cast<std::size_t>(*most) : default_samples;
}

Result<jobs::AnalyseJob> JobReader::read() {
  const auto job = document_.object();
  if (document_.problem()) return *document_.problem();
  source_.check_words(operation_ == Operation::analyse ? std::span<const std::string_view>{}
                                                       : analysis_words);
  auto definition = machine_of(job);
  if (auto first = source_.first_problem()) return *first;

  jobs::AnalyseJob answer{.job = {.machine = std::move(*definition), .path = {}}};
  jobs::PostJob& result = answer.job;
  if (takes_nc())
    for (const auto key : {"nc"sv, nc_dialect_key}) job.optional_value(key);
  if (parts_.nc && !takes_nc())
    source_.fail(Code::unknown_key, "/nc", "an NC program is a path of /analyse alone");
  if (has_nc(job))
    read_nc(job, answer);
  else
    read_path(job, result);
  const bool has_nc_dialect =
      job.has(nc_dialect_key) || find_field(parts_.words, nc_dialect_key) != nullptr;
  if (takes_nc() && !has_nc(job) && has_nc_dialect)
    source_.fail(Code::conflicting_keys, "/nc_dialect", "it belongs to nc, and the job has none");
  read_setup(job, result.setup);
  read_tools(job, result);
  read_tolerances(job, result.tolerances);
  read_post(job, result.post);
  read_limits(job, result);
  if (operation_ == Operation::analyse) read_analysis(job, answer);
  job.finish();
  if (!parts_.cl && !job.has("cl") && !job.has("path") && !has_nc(job))
    source_.fail(Code::missing_key, "/cl",
                 takes_nc() ? "a job has exactly one of cl, path and nc"
                            : "a job has exactly one of cl and path");
  if (auto first = source_.first_problem()) return *first;
  return answer;
}

Result<jobs::AnalyseJob> read_job(JobParts parts, const JobContext& context, Operation operation) {
  auto document = json::Document::parse(parts.json ? *parts.json : "{}"sv);
  if (!document) return std::move(document).error();
  auto answer = JobReader{*document, parts, context, operation}.read();
  if (!answer) return answer;
  answer->job.post.default_program_name = file_stem(parts.cl_file_name);
  if (parts.cl) std::get<jobs::ClText>(answer->job.path).text = std::move(*parts.cl);
  if (parts.nc) answer->nc->text = std::move(*parts.nc);
  return answer;
}

}  // namespace

std::string pointer_to_key(std::string_view key) { return json::pointer_step(key); }

std::string file_stem(std::string_view file_name) {
  file_name.remove_prefix(file_name.find_last_of("/\\") + 1);  // none: npos + 1 is 0
  const auto dot = file_name.rfind('.');
  constexpr std::size_t longest = 80;  // a client may call its file anything
  return std::string{
      file_name.substr(0, dot == 0 ? std::string_view::npos : dot).substr(0, longest)};
}

Problem placed_in_request(Problem problem, const jobs::PostJob& job,
                          const machine::Library& machines) {
  const auto* const entry = machines.find(job.machine.name, job.machine.version);
  const bool named = entry != nullptr && entry->definition.sha256 == job.machine.sha256;
  if (named && problem.pointer.starts_with("/machine/")) problem.pointer = "/machine";
  return problem;
}

Problem missing_machine(const machine::Library& machines, std::string_view name,
                        std::string_view version) {
  if (machines.find(name) == nullptr) {
    const auto near = machines.near_names(name);
    const std::string hint = near.empty() ? "" : "; near: " + joined(near);
    return Problem{.code = Code::unknown_machine,
                   .message = "there is no machine " + quoted(name) + hint};
  }
  return Problem{.code = Code::unknown_version,
                 .message = "there is no version " + quoted(version) + " of " + quoted(name) +
                            "; there are: " + joined(machines.versions(name))};
}

Result<const machine::LibraryEntry*> find_machine(const machine::Library& machines,
                                                  std::string_view name_and_version) {
  const auto at = name_and_version.find('@');
  const auto name = name_and_version.substr(0, at);
  const bool newest = at == std::string_view::npos;
  const auto version = newest ? std::string_view{} : name_and_version.substr(at + 1);
  const auto* const entry = newest ? machines.find(name) : machines.find(name, version);
  if (entry != nullptr) return entry;
  return missing_machine(machines, name, version);
}

Result<jobs::PostJob> read_post_job(JobParts parts, const JobContext& context) {
  auto answer = read_job(std::move(parts), context, Operation::post);
  if (!answer) return std::move(answer).error();
  return std::move(answer->job);
}

Result<jobs::AnalyseJob> read_analyse_job(JobParts parts, const JobContext& context) {
  return read_job(std::move(parts), context, Operation::analyse);
}

}  // namespace pentapost::server
