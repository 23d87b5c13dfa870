#include "pentapost/analysis/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::analysis {

Recorder::Recorder(const kinematics::Model& model, const plan::Settings& settings,
                   const AnalysisOptions& options)
    : allowance_{speed_limits(model, settings), options.share},
      survey_{kinematics::singularities(model), allowance_},
      windows_{options.windows} {
  analysis_.singularities = kinematics::singularities(model);
  if (options.most_samples) samples_.emplace(*options.most_samples);
}

void Recorder::begin_operation(int tool_number, const std::string& name) {
  operation_ = {.tool_number = tool_number, .operation = name};
  has_cut_ = false;
}

void Recorder::take_places(const SurveyedMove& move) {
  survey_.take(move, places_);
  analysis_.spans.take(places_);
  windows_.take(move, places_);
  if (samples_) samples_->take(move, places_);
}

void Recorder::account(const SurveyedMove& move) {
  if (!std::exchange(has_cut_, true)) analysis_.operations.push_back(operation_);
  OperationTime& operation = analysis_.operations.back();
  operation.length_mm += move.length_mm;
  operation.programmed_time_s += move.time_s;
  operation.predicted_time_s += survey_.predicted_time_s() - accounted_s_;
  accounted_s_ = survey_.predicted_time_s();
  analysis_.length_mm += move.length_mm;
  analysis_.programmed_time_s += move.time_s;
}

void Recorder::reposition(Repositioning::Kind kind, const PathPlace& at,
                          const std::optional<PerAxis>& from_joints,
                          const std::optional<PerAxis>& to_joints) {
  interrupt();
  Repositioning move{kind, at, std::nullopt};
  if (from_joints && to_joints) move.time_s = time_s(*from_joints, *to_joints);
  analysis_.repositionings.push_back(move);
  for (const auto& joints : {from_joints, to_joints})
    if (joints) analysis_.spans.take(*joints);
}

void Recorder::interrupt() {
  survey_.interrupt();
  if (samples_) samples_->interrupt();
}

std::optional<double> Recorder::time_s(const PerAxis& from, const PerAxis& to) const {
  std::optional<double> time;
  constexpr double no_way = 1e-9;
  for (std::size_t i = 0; i < axis_count; ++i) {
    const double way = std::abs(to[i] - from[i]);
    if (way > no_way && allowance_.time_per_way_s[i] > 0.0)
      time = std::max(time.value_or(0.0), way * allowance_.time_per_way_s[i]);
  }
  return time;
}

PathAnalysis Recorder::finish() && {
  analysis_.approaches = survey_.approaches();
  analysis_.peaks = survey_.peaks();
  analysis_.peak_accelerations = survey_.peak_accelerations();
  analysis_.zones = survey_.singular_zones();
  analysis_.over_demands = survey_.plain_zones();
  analysis_.predicted_time_s = survey_.predicted_time_s();
  analysis_.window_loads = windows_.loads();
  if (samples_) analysis_.samples = std::move(*samples_).finish();
  return std::move(analysis_);
}

SpeedLimits speed_limits(const kinematics::Model& model, const plan::Settings& settings) {
  SpeedLimits limits;
  const auto limit_of = [&](const std::string& name) -> std::optional<double> {
    const auto found = settings.limits.find(name);
    return found == settings.limits.end() ? std::nullopt : found->second.max_speed;
  };
  for (std::size_t i = 0; i < first_axis; ++i) limits[i] = limit_of(model.linear_names[i]);
  for (int i = 0; i < model.rotary_count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    limits[first_axis + index] = limit_of(model.rotary_names[index]);
  }
  return limits;
}

}  // namespace pentapost::analysis
