#include "pentapost/analysis/samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pentapost::analysis {

Samples::Samples(std::size_t most) : most_rows_{most - 2 * axis_count} {}

void Samples::take(const SurveyedMove& move, const std::vector<Place>& places) {
  if (std::exchange(is_interrupted_, false)) ++course_;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Place& place = places[k];
    // Stretches that follow each other meet in one place, but their rates may differ there.
    Row row{count_++, course_, {}};
    Sample& sample = row.sample;
    sample.at = move.place(place);
    sample.feed_mm_min = move.feed_mm_min();
    sample.joints = place.demand.joints;
    sample.opening_sine = place.demand.opening_sine;
    sample.axis = place.demand.axis;
    sample.has_acceleration = place.acceleration.has_value();
    for (std::size_t i = 0; i < axis_count; ++i) {
      sample.speed[i] = place.demand.rate[i] / move.time_s;
      if (place.acceleration)
        sample.acceleration[i] = (*place.acceleration)[i] / (move.time_s * move.time_s);
    }
    keep_extremes(row);
    rows_.push_back(row);
    if (rows_.size() > most_rows_) thin();
  }
}

void Samples::keep_extremes(const Row& row) {
  for (std::size_t i = 0; i < axis_count; ++i) {
    auto& [least, most] = ends_[i];
    const double joint = row.sample.joints[i];
    if (!least || joint < least->sample.joints[i]) least = row;
    if (!most || joint > most->sample.joints[i]) most = row;
  }
}

/// Doubles the runs until half of the rows are free again: a run keeps at most one row more than
/// there are axes.
void Samples::thin() {
  keep_of_runs();
  while (rows_.size() > most_rows_ / 2) {
    run_length_ *= 2;
    keep_of_runs();
  }
}

void Samples::keep_of_runs() {
  std::vector<Row> kept;
  for (std::size_t begin = 0; begin < rows_.size();) {
    const std::uint64_t run = rows_[begin].number / run_length_;
    std::size_t end = begin;
    std::array<std::size_t, axis_count> fastest;
    fastest.fill(begin);
    for (; end < rows_.size() && rows_[end].number / run_length_ == run; ++end)
      for (std::size_t i = 0; i < axis_count; ++i)
        if (std::abs(rows_[end].sample.speed[i]) > std::abs(rows_[fastest[i]].sample.speed[i]))
          fastest[i] = end;
    for (std::size_t row = begin; row < end; ++row)
      if (row == begin || std::find(fastest.begin(), fastest.end(), row) != fastest.end())
        kept.push_back(rows_[row]);
    begin = end;
  }
  rows_ = std::move(kept);
}

std::vector<Sample> Samples::finish() && {
  for (const auto& ends : ends_)
    for (const auto& row : ends)
      if (row) rows_.push_back(*row);
  std::sort(rows_.begin(), rows_.end(),
            [](const Row& x, const Row& y) { return x.number < y.number; });
  std::vector<Sample> samples;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    if (k > 0 && rows_[k].number == rows_[k - 1].number) continue;
    rows_[k].sample.goes_on = k > 0 && rows_[k].course == rows_[k - 1].course;
    samples.push_back(rows_[k].sample);
  }
  return samples;
}

}  // namespace pentapost::analysis
