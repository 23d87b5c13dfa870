#include "server/json/reorient_options_json.hpp"

#include "pentapost/core/number_text.hpp"
#include "server/json/clearance_json.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

namespace pentapost::server {
namespace {

using json::Domain;
using json::Object;
using namespace std::string_view_literals;

constexpr std::array objective_words{"peak_ratio"sv, "time"sv, "rotary_travel"sv};
constexpr std::array objectives{jobs::Objective::peak_ratio, jobs::Objective::time,
                                jobs::Objective::rotary_travel};
constexpr auto theta_x_key = "theta_x_deg"sv, theta_z_key = "theta_z_deg"sv;
constexpr auto tilt_domain = Domain::between(0.0, 180.0);
constexpr auto accuracy_domain = Domain::between(0.0, jobs::largest_setup_accuracy_deg);
constexpr auto angle_domain =
    Domain::between(-jobs::largest_setup_angle_deg, jobs::largest_setup_angle_deg);
constexpr auto step_domain =
    Domain::between(jobs::smallest_angle_step_deg, jobs::largest_setup_angle_deg);
constexpr auto map_step_domain =
    Domain::between(jobs::smallest_map_step_deg, jobs::largest_map_step_deg);
constexpr double default_map_step_deg = 2.0;
constexpr double largest_length_mm = 1e6;  // as far as a tool path may reach

void refuse_beyond(const json::Array& array, std::size_t most) {
  if (array.size() > most)
    array.fail(Code::out_of_domain, "found " + std::to_string(array.size()) +
                                        " elements, expected at most " + std::to_string(most));
}

void read_steps(const Object& object, jobs::ReorientJob& result) {
  const auto step = object.optional_value("step_deg");
  if (!step) return;
  if (step->is_object()) {
    const auto steps = step->object();
    result.theta_x.step_deg = steps.optional_number(theta_x_key, step_domain);
    result.theta_z.step_deg = steps.optional_number(theta_z_key, step_domain);
    return steps.finish();
  }
  if (!step->is_number())
    return step->fail(Code::wrong_type,
                      "expected a number, the step of both angles, or an object, that of each");
  result.theta_x.step_deg = result.theta_z.step_deg = step->number(step_domain);
}

void read_allowed_angle(const Object& allowed, std::string_view key, jobs::AngleChoice& choice) {
  const auto angles = allowed.optional_array(key);
  if (!angles) return;
  if (choice.step_deg)
    return angles->fail(Code::conflicting_keys, "step_deg has a step for this angle");
  refuse_beyond(*angles, jobs::ReorientJob::most_allowed);
  const auto numbers = angles->numbers();
  for (const double angle_deg : numbers) {
    if (!angle_domain.contains(angle_deg))
      return angles->fail(Code::out_of_domain,
                          "found " + number_text(angle_deg) + ", expected -360 to 360");
  }
  if (angles->size() == 0)
    return angles->fail(Code::out_of_domain, "no angle is allowed: there is no setup");
  choice.allowed_deg.assign(numbers.begin(), numbers.end());
}

void read_allowed(const Object& object, jobs::ReorientJob& result) {
  const auto allowed = object.optional_object("allowed_deg");
  if (!allowed) return;
  read_allowed_angle(*allowed, theta_x_key, result.theta_x);
  read_allowed_angle(*allowed, theta_z_key, result.theta_z);
  allowed->finish();
}

/// Both ends may be the same angle.
std::optional<Range<double>> angle_range(const Object& object, std::string_view key) {
  const auto ends = object.optional_array(key);
  if (!ends) return std::nullopt;
  const auto numbers = ends->numbers(2);
  if (numbers.size() != 2) return std::nullopt;
  if (!angle_domain.contains(numbers[0]) || !angle_domain.contains(numbers[1]) ||
      numbers[0] > numbers[1]) {
    ends->fail(Code::out_of_domain, "found [" + number_text(numbers[0]) + ", " +
                                        number_text(numbers[1]) +
                                        "], expected [from, to] within -360 and 360");
  }
  return Range<double>{.lower = numbers[0], .upper = numbers[1]};
}

void read_forbidden(const Object& object, jobs::ReorientJob& result) {
  const auto all = object.optional_array("forbidden_deg");
  if (!all) return;
  refuse_beyond(*all, jobs::ReorientJob::most_forbidden);
  for (std::size_t i = 0; i < std::min(all->size(), jobs::ReorientJob::most_forbidden); ++i) {
    const auto each = all->at(i).object();
    const jobs::ForbiddenAngles angles{.theta_x_deg = angle_range(each, theta_x_key),
                                       .theta_z_deg = angle_range(each, theta_z_key)};
    each.finish();
    if (!angles.theta_x_deg && !angles.theta_z_deg)
      each.fail(Code::missing_key, "expected theta_x_deg, theta_z_deg or both");
    result.forbidden.push_back(angles);
  }
}

void read_origin_bounds(const Object& object, jobs::ReorientJob& result) {
  const auto bounds = object.optional_object("origin_bounds_mm");
  if (!bounds) return;
  const auto corner = [&](std::string_view key) {
    const Vec3 coordinates = bounds->vector3(key);
    if (coordinates.cwiseAbs().maxCoeff() > largest_length_mm)
      bounds->fail_at(key, Code::out_of_domain,
                      "found a coordinate beyond the largest, 1000000 mm");
    return coordinates;
  };
  const Vec3 lower = corner("min"), upper = corner("max");
  bounds->finish();
  if ((lower.array() > upper.array()).any())
    bounds->fail(Code::out_of_domain, "a coordinate of min is above that of max");
  result.origin_mm = {{{lower.x(), upper.x()}, {lower.y(), upper.y()}, {lower.z(), upper.z()}}};
}

void read_candidates(const Object& object, jobs::ReorientJob& result) {
  const auto all = object.optional_array("candidates");
  if (!all) return;
  refuse_beyond(*all, jobs::ReorientJob::most_candidates);
  for (std::size_t i = 0; i < std::min(all->size(), jobs::ReorientJob::most_candidates); ++i) {
    const auto each = all->at(i).object();
    result.candidates.push_back(
        {.theta_x_deg = each.optional_number(theta_x_key, angle_domain).value_or(0.0),
         .theta_z_deg = each.optional_number(theta_z_key, angle_domain).value_or(0.0)});
    each.finish();
  }
}

std::optional<double> map_step_deg(const Object& object) {
  const auto map = object.optional_value("map");
  if (!map) return default_map_step_deg;
  if (map->is_boolean()) return map->boolean() ? std::optional{default_map_step_deg} : std::nullopt;
  if (!map->is_object()) {
    map->fail(Code::wrong_type, "expected true, false, or an object with step_deg");
    return std::nullopt;
  }
  const auto options = map->object();
  const auto step_deg = options.optional_number("step_deg", map_step_domain);
  options.finish();
  return step_deg.value_or(default_map_step_deg);
}

}  // namespace

void read_reorient_bounds(JobSource& source, const Object& object, jobs::ReorientJob& result) {
  if (const auto index = source.choice("objective", object, "objective", objective_words))
    result.objective = objectives[*index];
  result.max_tilt_deg =
      source.number("max_tilt_deg", object, tilt_domain).value_or(result.max_tilt_deg);
  result.setup_accuracy_deg = source.number("setup_accuracy_deg", object, accuracy_domain)
                                  .value_or(result.setup_accuracy_deg);
  read_steps(object, result);
  read_allowed(object, result);
  read_forbidden(object, result);
  read_origin_bounds(object, result);
  result.clearance = read_clearance(object);
}

void read_reorient_answer(const Object& object, jobs::ReorientJob& result) {
  read_candidates(object, result);
  result.map_step_deg = map_step_deg(object);
}

std::optional<jobs::ReorientJob> read_reorient_choice(JobSource& source, const Object& job,
                                                      const machine::Definition& machine) {
  constexpr std::array truth_words{"false"sv, "true"sv};
  jobs::ReorientJob asked{.job = {.machine = machine, .path = {}}};
  if (source.word("reorient", job, "reorient") != nullptr)
    return source.choice("reorient", job, "reorient", truth_words) == 1U ? std::optional{asked}
                                                                         : std::nullopt;
  const auto value = job.optional_value("reorient");
  if (!value) return std::nullopt;
  if (value->is_boolean()) return value->boolean() ? std::optional{asked} : std::nullopt;
  if (!value->is_object()) {
    value->fail(Code::wrong_type, "expected true, false, or an object with the bounds of setups");
    return std::nullopt;
  }
  const auto bounds = value->object();
  read_reorient_bounds(source, bounds, asked);
  bounds.finish();
  return asked;
}

}  // namespace pentapost::server
