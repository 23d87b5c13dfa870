#include "pentapost/jobs/compare_rows.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <tuple>
#include <utility>

namespace pentapost::jobs {
namespace {

template <class Value>
using Work = std::function<Result<Value>(const machine::Definition&)>;

template <class Value>
Result<Value> guarded(const Work<Value>& work, const machine::Definition& machine) {
  try {
    return work(machine);
  } catch (const std::exception& exception) {
    return Problem{.code = Code::defect, .message = exception.what()};
  }
}

/// Whether another setup can take away what the machine cannot do.
bool is_of_the_setup(Code code) {
  return code == Code::out_of_reach || code == Code::rotary_range || code == Code::linear_range ||
         code == Code::linear_singular;
}

/// Rounded: the last digits of two machines' sums differ for the same way.
double in_steps(double value, double steps) { return std::round(value * steps); }

struct Rank {
  bool impossible = false, not_within = false;
  LimitsKnown limits_known = LimitsKnown::all;
  double time_ms = 0.0;
  std::uint64_t retracts = 0;
  double ratio = 0.0;
};

Rank rank_of(const CompareRow& row) {
  if (!row.figures) return {.impossible = true};
  const CompareFigures& figures = *row.figures;
  const double ratio = figures.peak ? figures.peak->peak_ratio.value_or(0.0)
                                    : std::numeric_limits<double>::infinity();
  return {.impossible = false,
          .not_within = !figures.within_limits || figures.limits_known == LimitsKnown::none,
          .limits_known = figures.limits_known,
          .time_ms = in_steps(figures.predicted_time_s, 1e3),
          .retracts = figures.retracts,
          .ratio = in_steps(ratio, 1e6)};
}

bool comes_before(const CompareRow& one, const CompareRow& other) {
  const auto key = [](const CompareRow& row, const Rank& rank) {
    return std::tie(rank.impossible, rank.not_within, rank.limits_known, rank.time_ms,
                    rank.retracts, rank.ratio, row.name, row.version, row.index);
  };
  const Rank first = rank_of(one), second = rank_of(other);
  return key(one, first) < key(other, second);
}

}  // namespace

std::vector<CompareRow> compare_rows(const CompareJob& job, const RowWork& work) {
  std::vector<CompareRow> rows;
  rows.reserve(job.machines.size());
  for (std::size_t index = 0; index < job.machines.size(); ++index) {
    const machine::Definition& machine = job.machines[index];
    CompareRow row{.index = index,
                   .name = machine.name,
                   .version = machine.version,
                   .title = machine.title,
                   .sha256 = machine.sha256,
                   .dialect = job.job.post.dialect.value_or(machine.controller.dialect),
                   .output = job.job.post.output.value_or(machine.controller.output),
                   .figures = guarded(work.figures, machine)};
    if (work.reorientation && (row.figures || is_of_the_setup(row.figures.error().code)))
      row.reorientation = guarded(work.reorientation, machine);
    rows.push_back(std::move(row));
  }
  std::sort(rows.begin(), rows.end(), comes_before);
  return rows;
}

}  // namespace pentapost::jobs
