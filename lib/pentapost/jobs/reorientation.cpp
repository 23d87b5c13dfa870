#include "pentapost/jobs/reorientation.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/jobs/path_loads.hpp"
#include "pentapost/path/turn.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace pentapost::jobs {
namespace {

using reorient::Goal;
using reorient::SetupDomain;
using reorient::SetupPoint;
using reorient::Trial;

constexpr double fine_tilt_deg = 0.005;      ///< to which the smallest tilt is found
constexpr std::size_t many_points = 20'000;  ///< of a path that takes its time
constexpr double steps_per_unit = 1000.0;    ///< of deg and mm in the setups that are answered

Goal goal_of(Objective objective) {
  switch (objective) {
    case Objective::time:
      return Goal::time;
    case Objective::rotary_travel:
      return Goal::travel;
    case Objective::peak_ratio:
      break;
  }
  return Goal::peak_ratio;
}

/// What a value of the search is in the unit of the report.
double in_unit(Objective objective, double value) {
  return objective == Objective::rotary_travel ? value * deg_per_rad : value;
}

std::vector<double> evenly(double most_deg, double step_deg) {
  constexpr double rounding = 1e-9;
  std::vector<double> values;
  const int steps = static_cast<int>(std::floor(most_deg / step_deg + rounding));
  for (int i = -steps; i <= steps; ++i) values.push_back(i * step_deg);
  return values;
}

/// Values of a coordinate, at most so many.
std::vector<double> spread_over(const reorient::Coordinate& coordinate, int most) {
  const auto whole = coordinate.whole();
  std::vector<double> values;
  for (int i = 0; i < most; ++i) {
    const double share = most > 1 ? static_cast<double>(i) / (most - 1) : 0.5;
    const double value =
        coordinate.nearest(whole, whole.lower + share * (whole.upper - whole.lower));
    if (values.empty() || value != values.back()) values.push_back(value);
  }
  return values;
}

void sort_by_value(std::vector<Trial>& trials) {
  std::stable_sort(trials.begin(), trials.end(), [](const Trial& x, const Trial& y) {
    // The last digits don't tell one setup from another.
    const auto order = [](const Trial& trial) {
      return std::tuple{static_cast<float>(trial.value), std::abs(trial.setup.theta_x_deg),
                        std::abs(trial.setup.theta_z_deg)};
    };
    return order(x) < order(y);
  });
}

double objective_of(Objective objective, const SetupReport& report) {
  switch (objective) {
    case Objective::time:
      return report.predicted_time_s;
    case Objective::rotary_travel:
      return report.rotary_travel_deg;
    case Objective::peak_ratio:
      break;
  }
  return report.peak_ratio.value_or(HUGE_VAL);
}

/// The domain up to a tilt; nullopt: nothing is left.
std::optional<SetupDomain> up_to(const SetupDomain& domain, double tilt_deg) {
  SetupDomain part = domain;
  reorient::Coordinate& tilts = part.coordinates[0];
  if (!tilts.is_list()) {
    tilts = reorient::Coordinate::interval(std::max(tilts.whole().lower, -tilt_deg),
                                           std::min(tilts.whole().upper, tilt_deg));
    return part;
  }
  std::vector<double> values = tilts.values();
  std::erase_if(values, [&](double each) { return std::abs(each) > tilt_deg; });
  if (values.empty()) return std::nullopt;
  tilts = reorient::Coordinate::list(std::move(values));
  return part;
}

}  // namespace

Reorientation::Reorientation(const ReorientJob& job, const PreparedJob& prepared,
                             SetupDomain domain, std::optional<clearance::Check> clearance)
    : job_{job},
      prepared_{prepared},
      domain_{std::move(domain)},
      clearance_{std::move(clearance)},
      origin_known_{job.origin_mm.has_value() || job.job.setup.origin_mm.has_value()},
      has_limits_{has_speed_limit(prepared)},
      has_twins_{!job.origin_mm &&
                 reorient::has_twins(prepared.model, prepared.ranges, prepared.settings.origin_mm)},
      setups_{prepared_, origin_known_},
      loads_{path_loads(prepared,
                        origin_known_ && !missing_gauge_length(job.job, prepared.read.tool_path))},
      points_{prepared.read.tool_path.size()},
      baseline_{job.job.setup.theta_x_deg, job.job.setup.theta_z_deg, prepared.settings.origin_mm} {
}

ReorientReport Reorientation::run() {
  ReorientReport report;
  static_cast<ReportHead&>(report) = report_head(job_.job, prepared_.read);
  report.objective = job_.objective;
  report.baseline = evaluated(baseline_);
  for (const SetupAngles& each : job_.candidates)
    report.candidates.push_back(
        evaluated({each.theta_x_deg, each.theta_z_deg, baseline_.origin_mm}));
  if (job_.map_step_deg) report.map = map();
  find_best(report);
  find_smallest_tilt(report);
  find_pareto(report);
  if (!report.best)
    report.obstacle = obstacle_of_all();
  else if (!report.best->within_limits)
    report.obstacle = report.best->obstacle;
  report.setups_evaluated = evaluated_;
  report.setups_colliding = colliding_;
  return report;
}

bool Reorientation::is_clear(const SetupPoint& setup) {
  if (!clearance_) return true;
  const Mat3 turn =
      path::setup_turn(setup.theta_x_deg * rad_per_deg, setup.theta_z_deg * rad_per_deg);
  const auto collision = clearance_->first_collision(turn, setup.origin_mm);
  if (!collision) return true;
  ++colliding_;
  obstacle_ =
      Obstacle{.kind = Obstacle::Kind::collision,
               .axis = {},
               .message = collision->what + " comes within " +
                          number_text(collision->distance_mm, 2) + " mm of " + collision->with,
               .cl_line = collision->cl_line,
               .code = {}};
  return false;
}

std::optional<double> Reorientation::confirm(const SetupPoint& setup, Goal goal, double value) {
  analysis::AnalysisOptions options;
  if (goal == Goal::peak_ratio && std::isfinite(value) && value > 0.0) {
    // Moves far below the expected peak need no following.
    constexpr double expected_share = 0.9;
    options.share = expected_share * value;
    options.zones_only = true;
  }
  auto analysed = setups_.analyse(setup, options);
  if (analysed && options.zones_only && peak_ratio_of(*analysed) < options.share)
    analysed = setups_.analyse(setup, {});
  if (!analysed) {
    obstacle_ = obstacle_of(analysed.error());
    return std::nullopt;
  }
  switch (goal) {
    case Goal::time:
      return std::max(value, analysed->predicted_time_s);
    case Goal::travel: {
      const auto& travel = analysed->spans.travel();
      return std::max(value, travel[analysis::first_axis] + travel[analysis::second_axis]);
    }
    case Goal::peak_ratio:
      break;
  }
  return std::max(value, peak_ratio_of(*analysed));
}

reorient::SetupValues Reorientation::values(Goal goal) const {
  return {prepared_.model, loads_, goal, job_.setup_accuracy_deg * rad_per_deg};
}

reorient::SetupChecks Reorientation::checks(Goal goal) {
  return {.is_clear = [this](const SetupPoint& setup) { return is_clear(setup); },
          .confirm = [this, goal](const SetupPoint& setup,
                                  double value) { return confirm(setup, goal, value); }};
}

/// So many cells that the search takes about as long as some analyses of a long path.
reorient::SearchOptions Reorientation::options(Goal goal) const {
  // A sum takes every part of the path for every cell, a peak few of them.
  const bool is_sum = goal != Goal::peak_ratio;
  const double work = is_sum ? 8e6 : 1e8, fewest = is_sum ? 50.0 : 300.0;
  const double most = is_sum ? 8000.0 : 12000.0;
  const double cells = work / static_cast<double>(std::max<std::size_t>(1, points_));
  return {.most_cells = static_cast<std::size_t>(std::clamp(cells, fewest, most)),
          .steps_per_unit = job_.setup_accuracy_deg > 0.0 ? steps_per_unit : 0.0};
}

/// Where nothing tells one place of the workpiece from another, it stays where it is wanted.
SetupDomain Reorientation::domain(Goal goal) const {
  SetupDomain domain = domain_;
  if (clearance_ || loads_.has_linear_ranges() ||
      (goal != Goal::travel && loads_.has_linear_speeds()))
    return domain;
  for (std::size_t i = 2; i < SetupDomain::dimensions; ++i) {
    const reorient::Coordinate& places = domain_.coordinates[i];
    const double wanted_mm = prepared_.settings.origin_mm[static_cast<Eigen::Index>(i) - 2];
    domain.coordinates[i] = reorient::Coordinate::list({places.nearest(places.whole(), wanted_mm)});
  }
  return domain;
}

const SetupReport& Reorientation::evaluated(const SetupPoint& setup) {
  for (const auto& [known, report] : reports_)
    if (known == setup) return report;
  SetupReport report = setups_.report(setup);
  if (report.possible && !is_clear(setup)) {
    report.possible = report.within_limits = false;
    report.obstacle = obstacle_;
  }
  if (report.possible && report.peak_ratio && job_.setup_accuracy_deg > 0.0)
    add_accuracy(setup, report);
  return reports_.emplace_back(setup, std::move(report)).second;
}

void Reorientation::add_accuracy(const SetupPoint& setup, SetupReport& report) {
  reorient::Hints none;
  const double ratio =
      values(Goal::peak_ratio).evaluate(setup, none, reorient::exact_tolerance).value;
  const bool was_within = report.within_limits;
  report.peak_unbounded = std::isinf(ratio);
  if (report.peak_unbounded)
    report.peak_ratio.reset();
  else
    report.peak_ratio = std::max(ratio, *report.peak_ratio);
  report.within_limits = !report.peak_unbounded && is_within_limits(report.peak_ratio);
  if (!was_within || report.within_limits) return;
  report.obstacle =
      Obstacle{.kind = Obstacle::Kind::speed,
               .axis = report.peak_axis.value_or(""),
               .message = report.peak_unbounded
                              ? "the singularity itself lies within the accuracy of the setup"
                              : "within the accuracy of the setup an axis needs up to " +
                                    number_text(*report.peak_ratio, 3) + " times its speed limit",
               .cl_line = 0,
               .code = {}};
}

std::vector<Trial> Reorientation::trials(const std::vector<double>& theta_x_deg,
                                         const std::vector<double>& theta_z_deg,
                                         const Vec3& origin_mm) {
  const reorient::SetupValues by_rates = values(goal_of(job_.objective));
  reorient::Hints hints;
  std::vector<Trial> trials;
  for (const double x_deg : theta_x_deg)
    for (const double z_deg : theta_z_deg) {
      const SetupPoint setup{x_deg, z_deg, origin_mm};
      trials.push_back({setup, by_rates.evaluate(setup, hints, reorient::coarse_tolerance).value});
      ++evaluated_;
    }
  return trials;
}

SetupMap Reorientation::map() {
  const reorient::Coordinate& turns = domain_.coordinates[1];
  const double most_turn_deg = turns.is_list() ? 180.0 : turns.whole().upper;
  SetupMap map{.theta_x_deg = evenly(job_.max_tilt_deg, *job_.map_step_deg),
               .theta_z_deg = evenly(most_turn_deg, *job_.map_step_deg),
               .value = {}};
  trials_ = trials(map.theta_x_deg, map.theta_z_deg, baseline_.origin_mm);
  const bool is_coarse = job_.objective == Objective::peak_ratio;
  for (std::size_t i = 0; i < trials_.size(); ++i) {
    if (i % map.theta_z_deg.size() == 0) map.value.emplace_back();
    // In the middle of what it may be.
    const double value =
        trials_[i].value * (is_coarse ? 1.0 + 0.5 * reorient::coarse_tolerance : 1.0);
    map.value.back().push_back(std::isfinite(value) ? std::optional{in_unit(job_.objective, value)}
                                                    : std::nullopt);
  }
  return map;
}

/// The setup or its twin, or else the nearest one that the jig can hold.
SetupPoint Reorientation::within_bounds(const SetupPoint& setup) const {
  SetupPoint same = setup;
  same.theta_z_deg = std::remainder(setup.theta_z_deg, 360.0);
  SetupPoint nearest = domain_.nearest(same);
  if (nearest == same || !has_twins_) return nearest;
  const double turned_deg = same.theta_z_deg > 0.0 ? -180.0 : 180.0;
  const SetupPoint twin{-same.theta_x_deg, same.theta_z_deg + turned_deg, same.origin_mm};
  return domain_.nearest(twin) == twin ? twin : nearest;
}

/// What the search starts with: the setups that are named, and the best ones of a grid.
std::vector<Trial> Reorientation::first_trials(double most_tilt_deg) const {
  constexpr std::size_t most_of_grid = 16;
  std::vector<Trial> best = trials_;
  std::erase_if(best, [&](const Trial& trial) {
    return !std::isfinite(trial.value) || std::abs(trial.setup.theta_x_deg) > most_tilt_deg;
  });
  sort_by_value(best);
  std::vector<Trial> first{{within_bounds(baseline_), 0.0},
                           {within_bounds({0.0, 0.0, baseline_.origin_mm}), 0.0}};
  for (const SetupAngles& each : job_.candidates)
    first.push_back(
        {within_bounds({each.theta_x_deg, each.theta_z_deg, baseline_.origin_mm}), 0.0});
  std::erase_if(
      first, [&](const Trial& trial) { return std::abs(trial.setup.theta_x_deg) > most_tilt_deg; });
  // Which of the grid collide or are out of range is not known yet.
  const bool may_be_refused = clearance_.has_value() || prepared_.ranges.rotary_rad[0].has_value();
  if (!may_be_refused && best.size() > most_of_grid) best.resize(most_of_grid);
  first.insert(first.begin(), best.begin(), best.end());
  return first;
}

void Reorientation::find_best(ReorientReport& report) {
  const Goal goal = goal_of(job_.objective);
  // The map is no matter of what the jig can hold.
  std::erase_if(trials_, [&](const Trial& trial) { return !domain_.allows(trial.setup); });
  if (trials_.empty()) {
    // Of sums every one goes along the whole path.
    const bool is_slow = goal != Goal::peak_ratio && points_ > many_points;
    trials_ = trials(spread_over(domain_.coordinates[0], is_slow ? 3 : 13),
                     spread_over(domain_.coordinates[1], is_slow ? 4 : 13),
                     domain_.nearest(baseline_).origin_mm);
  }
  const auto found = reorient::find_best(
      values(goal), domain(goal), first_trials(job_.max_tilt_deg), checks(goal), options(goal));
  evaluated_ += found.evaluated;
  if (!found.best) return;
  const SetupReport& best = evaluated(found.best->setup);
  obstacle_ = best.obstacle;
  if (!best.possible) return;
  report.best = best;
  if (std::isfinite(found.best->value))
    report.optimality_gap =
        in_unit(job_.objective, std::max(0.0, found.best->value - found.least_value));
}

void Reorientation::find_smallest_tilt(ReorientReport& report) {
  if (!has_limits_) return;
  const auto found = reorient::find_smallest_tilt(
      values(Goal::peak_ratio), domain(Goal::peak_ratio), fine_tilt_deg, checks(Goal::peak_ratio),
      options(Goal::peak_ratio));
  evaluated_ += found.evaluated;
  if (!found.best) return;
  const SetupReport& smallest = evaluated(found.best->setup);
  if (!smallest.possible) return;
  report.smallest_tilt = smallest;
  report.smallest_tilt_gap_deg = found.best->value - found.least_value;
}

/// Between no tilt and that of the best setup a few more, each better than those of less tilt.
void Reorientation::find_pareto(ReorientReport& report) {
  constexpr int levels = 4;
  constexpr double least_gain = 0.005;
  if (!report.best) return;
  const Goal goal = goal_of(job_.objective);
  const double most_deg = report.best->tilt_deg;
  reorient::SearchOptions quick = options(goal);
  quick.most_cells = 0;
  quick.goes_downhill = points_ < many_points;
  const auto is_better = [&](double value) {
    return report.pareto.empty() ||
           value < (1.0 - least_gain) * objective_of(job_.objective, report.pareto.back());
  };
  const auto add = [&](const SetupReport& setup) {
    if (setup.possible && is_better(objective_of(job_.objective, setup)))
      report.pareto.push_back(setup);
  };
  for (int level = 0; level < levels; ++level) {
    const double tilt_deg = most_deg * level / levels;
    const auto part = up_to(domain(goal), tilt_deg);
    if (!part || most_deg == 0.0) continue;
    const auto found =
        reorient::find_best(values(goal), *part, first_trials(tilt_deg), checks(goal), quick);
    evaluated_ += found.evaluated;
    if (found.best && is_better(in_unit(job_.objective, found.best->value)))
      add(evaluated(found.best->setup));
  }
  add(*report.best);
}

/// What stands in the way where no setup is possible.
std::optional<Obstacle> Reorientation::obstacle_of_all() {
  if (obstacle_) return obstacle_;
  std::vector<SetupPoint> any{reorient::middle(domain_, reorient::whole(domain_))};
  for (const Trial& trial : trials_) any.push_back(trial.setup);
  const auto allowed = std::find_if(any.begin(), any.end(),
                                    [&](const SetupPoint& setup) { return domain_.allows(setup); });
  if (allowed != any.end())
    if (auto obstacle = setups_.report(*allowed).obstacle) return obstacle;
  return Obstacle{.kind = Obstacle::Kind::problem,
                  .axis = {},
                  .message = "no setup within the bounds is possible",
                  .cl_line = 0,
                  .code = {}};
}

}  // namespace pentapost::jobs
