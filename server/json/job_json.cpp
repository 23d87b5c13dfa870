#include "server/json/job_json.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/json/strict_reader.hpp"
#include "server/json/job_source.hpp"
#include "server/json/machine_choice.hpp"
#include "server/json/name_text.hpp"
#include "server/json/point_path_json.hpp"
#include "server/json/reorient_options_json.hpp"

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
constexpr auto zone_share_key = "zone_share"sv, nc_dialect_key = "nc_dialect"sv;

enum class Operation { post, analyse, reorient, compare };

/// The words that an operation has for itself.
constexpr std::array analysis_words{zone_share_key, nc_dialect_key};
constexpr std::array compare_words{zone_share_key, "machines"sv, "reorient"sv};
struct OwnWords {
  Operation operation;
  std::span<const std::string_view> words;
};
constexpr std::array own_words{OwnWords{Operation::analyse, analysis_words},
                               OwnWords{Operation::reorient, reorient_words},
                               OwnWords{Operation::compare, compare_words}};

std::vector<std::string_view> words_of_others(Operation operation) {
  std::vector<std::string_view> others;
  for (const auto& [owner, words] : own_words)
    if (owner != operation) others.insert(others.end(), words.begin(), words.end());
  for (const auto& [owner, words] : own_words)
    if (owner == operation)
      std::erase_if(others, [&words = words](std::string_view other) {
        return std::ranges::find(words, other) != words.end();
      });
  return others;
}

struct PlainJob {
  jobs::PostJob job;
};

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

  /// @param Job  holds a PostJob as `job`, and what the operation has beside it.
  template <class Job>
  Result<Job> read();

 private:
  std::optional<std::string> dialect(std::string_view name, const std::optional<Object>& object);
  bool takes_nc() const { return operation_ == Operation::analyse; }
  bool has_nc(const Object& job) const { return parts_.nc || (takes_nc() && job.has("nc")); }
  void read_source(const Object& job, jobs::PostJob& result, std::optional<jobs::NcProgram>* nc);
  void read_nc(const Object& job, std::optional<jobs::NcProgram>& result);
  void read_path(const Object& job, jobs::PostJob& result);
  void read_cl(const Object& job, jobs::PostJob& result);
  void read_setup(const Object& job, jobs::Setup& setup);
  void read_tools(const Object& job, jobs::PostJob& result);
  void read_tolerances(const Object& job, jobs::Tolerances& tolerances);
  void read_post(const Object& job, jobs::PostOptions& post);
  void read_prefer(const Object& prefer, jobs::PostOptions& post);
  void read_limits(const Object& job, std::span<const machine::Definition> machines,
                   jobs::PostJob& result);
  void read_own(const Object&, PlainJob&) {}
  void read_own(const Object& job, jobs::AnalyseJob& result);
  void read_own(const Object& job, jobs::ReorientJob& result);
  void read_own(const Object& job, jobs::CompareJob& result);

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

std::optional<jobs::NcProgram>* nc_of(jobs::AnalyseJob& job) { return &job.nc; }
template <class Job>
std::optional<jobs::NcProgram>* nc_of(Job&) {
  return nullptr;
}

/// @param nc  nullptr: the operation takes none.
void JobReader::read_source(const Object& job, jobs::PostJob& result,
                            std::optional<jobs::NcProgram>* nc) {
  if (nc != nullptr)
    for (const auto key : {"nc"sv, nc_dialect_key}) job.optional_value(key);
  else if (parts_.nc)
    source_.fail(Code::unknown_key, "/nc", "an NC program is a path of /analyse alone");
  if (nc != nullptr && has_nc(job)) return read_nc(job, *nc);
  read_path(job, result);
  const bool has_nc_dialect =
      job.has(nc_dialect_key) || find_field(parts_.words, nc_dialect_key) != nullptr;
  if (nc != nullptr && has_nc_dialect)
    source_.fail(Code::conflicting_keys, "/nc_dialect", "it belongs to nc, and the job has none");
}

void JobReader::read_nc(const Object& job, std::optional<jobs::NcProgram>& result) {
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
  result = jobs::NcProgram{.text = {}, .dialect = dialect(nc_dialect_key, job)};
  if (!parts_.nc) result->text = job.take_string("nc");
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
    result.path = read_point_path(*path);
    return;
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
  post.line_map = object->optional_boolean("line_map").value_or(false);
  post.flank = object->optional_boolean("flank").value_or(false);
  post.pole_axis_deg = object->optional_number("pole_axis_deg", pole_axis_domain).value_or(0.0);
  if (const auto prefer = object->optional_object("prefer")) read_prefer(*prefer, post);
  object->finish();
}

/// The first joint of that name; nullptr: no machine has one.
const machine::Joint* find_joint(std::span<const machine::Definition> machines,
                                 std::string_view name) {
  for (const auto& machine : machines) {
    for (const auto joints : {machine.chain.table(), machine.chain.head()}) {
      const auto joint = std::ranges::find(joints, name, &machine::Joint::name);
      if (joint != joints.end()) return &*joint;
    }
  }
  return nullptr;
}

void JobReader::read_limits(const Object& job, std::span<const machine::Definition> machines,
                            jobs::PostJob& result) {
  const auto limits = job.optional_object("limits");
  if (!limits) return;
  for (const auto& name : limits->keys()) {
    const auto object = limits->object(name);
    const auto* const joint = find_joint(machines, name);
    if (joint == nullptr)
      return limits->fail_at(name, Code::out_of_domain,
                             machines.size() == 1 ? "the machine has no axis of that name"
                                                  : "no machine has an axis of that name");
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

void JobReader::read_own(const Object& job, jobs::AnalyseJob& result) {
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

void JobReader::read_own(const Object& job, jobs::ReorientJob& result) {
  read_reorient_bounds(source_, job, result);
  read_reorient_answer(job, result);
}

void JobReader::read_own(const Object& job, jobs::CompareJob& result) {
  result.zone_share =
      source_.number(zone_share_key, job, Domain::positive()).value_or(result.zone_share);
  result.reorient = read_reorient_choice(source_, job, result.job.machine);
}

void keep_machines(jobs::CompareJob& job, std::vector<machine::Definition> machines) {
  job.machines = std::move(machines);
}
template <class Job>
void keep_machines(Job&, const std::vector<machine::Definition>&) {}

template <class Job>
Result<Job> JobReader::read() {
  const auto job = document_.object();
  if (document_.problem()) return *document_.problem();
  source_.check_words(words_of_others(operation_));
  const MachineChoice choice{source_, context_, parts_.json ? *parts_.json : std::string_view{}};
  auto machines = operation_ == Operation::compare ? choice.several(job) : choice.one(job);
  if (auto first = source_.first_problem()) return *first;

  Job answer{.job = {.machine = machines.front(), .path = {}}};
  jobs::PostJob& result = answer.job;
  read_source(job, result, nc_of(answer));
  read_setup(job, result.setup);
  read_tools(job, result);
  read_tolerances(job, result.tolerances);
  read_post(job, result.post);
  read_limits(job, machines, result);
  keep_machines(answer, std::move(machines));
  read_own(job, answer);
  job.finish();
  if (!parts_.cl && !job.has("cl") && !job.has("path") && !has_nc(job))
    source_.fail(Code::missing_key, "/cl",
                 takes_nc() ? "a job has exactly one of cl, path and nc"
                            : "a job has exactly one of cl and path");
  if (auto first = source_.first_problem()) return *first;
  return answer;
}

template <class Job>
Result<Job> read_job(JobParts& parts, const JobContext& context, Operation operation) {
  auto document = json::Document::parse(parts.json ? *parts.json : "{}"sv);
  if (!document) return std::move(document).error();
  auto answer = JobReader{*document, parts, context, operation}.read<Job>();
  if (!answer) return answer;
  answer->job.post.default_program_name = file_stem(parts.cl_file_name);
  if (parts.cl) std::get<jobs::ClText>(answer->job.path).text = std::move(*parts.cl);
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

Result<jobs::PostJob> read_post_job(JobParts parts, const JobContext& context) {
  auto answer = read_job<PlainJob>(parts, context, Operation::post);
  if (!answer) return std::move(answer).error();
  return std::move(answer->job);
}

Result<jobs::AnalyseJob> read_analyse_job(JobParts parts, const JobContext& context) {
  auto answer = read_job<jobs::AnalyseJob>(parts, context, Operation::analyse);
  if (answer && parts.nc) answer->nc->text = std::move(*parts.nc);
  return answer;
}

Result<jobs::CompareJob> read_compare_job(JobParts parts, const JobContext& context) {
  return read_job<jobs::CompareJob>(parts, context, Operation::compare);
}

Result<jobs::ReorientJob> read_reorient_job(JobParts parts, const JobContext& context) {
  return read_job<jobs::ReorientJob>(parts, context, Operation::reorient);
}

}  // namespace pentapost::server
