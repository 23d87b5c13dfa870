#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace pentapost::bench {

/// Prints as Google Benchmark does and keeps the fastest run of each benchmark, for the machine may
/// be busy; at the end it holds all of them against the floor.
class Summary : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;
  /// The table, and the bounds that the project holds itself to.
  void print() const;

 private:
  struct Row {
    double points = 0.0;
    double time_s = 0.0;  ///< CPU time of one run
    double bytes_per_point = 0.0;
    int floor_words = 0;  ///< 0: no floor of its own
  };
  double floor_time_s(const Row& row) const;
  void print_bounds() const;

  std::vector<std::string> order_;  ///< of the first run
  std::map<std::string, Row> rows_;
};

}  // namespace pentapost::bench
