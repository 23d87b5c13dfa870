#include "summary.hpp"

#include "number_floor.hpp"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace pentapost::bench {
namespace {

constexpr double largest_share_of_floor = 6.0;
constexpr double largest_analysis_share_of_floor = 2.5;
constexpr double largest_growth = 11.0;
constexpr double longest_reorient_s = 1.5;  ///< with a map, of 10^5 points
constexpr double largest_bytes_per_point = 400.0;
constexpr std::string_view small_size = "/100000", large_size = "/1000000";

const char* verdict(bool holds) { return holds ? "holds" : "MISSED"; }

}  // namespace

void Summary::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const std::string& name = run.run_name.function_name;
    const double time_s = run.cpu_accumulated_time / static_cast<double>(run.iterations);
    const auto [found, is_new] = rows_.try_emplace(name);
    Row& row = found->second;
    if (is_new) order_.push_back(name);
    row.time_s = is_new ? time_s : std::min(row.time_s, time_s);
    row.points = run.counters.at("points");
    row.bytes_per_point = run.counters.at("peak_bytes_per_point");
    row.floor_words = static_cast<int>(run.counters.at("words"));
  }
}

double Summary::floor_time_s(const Row& row) const {
  const auto size = static_cast<long long>(row.points);
  const auto found =
      rows_.find("floor/" + std::to_string(row.floor_words) + "_words/" + std::to_string(size));
  return found == rows_.end() ? 0.0 : found->second.time_s;
}

void Summary::print() const {
  std::printf("\n%s\n\n%-36s %10s %12s %9s %12s\n", std::string{what_the_floor_does()}.c_str(),
              "fastest run of each", "ns/point", "points/s", "x floor", "peak B/point");
  for (const std::string& name : order_) {
    const Row& row = rows_.at(name);
    const double floor_s = floor_time_s(row);
    std::printf("%-36s %10.1f %12.0f", name.c_str(), 1e9 * row.time_s / row.points,
                row.points / row.time_s);
    if (floor_s > 0.0)
      std::printf(" %9.2f", row.time_s / floor_s);
    else
      std::printf(" %9s", "-");
    std::printf(" %12.1f\n", row.bytes_per_point);
  }
  print_bounds();
}

void Summary::print_bounds() const {
  std::printf("\npeak memory is above the texts themselves, the CL data's and the program's\n");
  for (const std::string& name : order_) {
    if (name == "whole_reorient/map/100000") {
      const double time_s = rows_.at(name).time_s;
      std::printf("%-36s %6.3f s            at most %3.1f: %s\n", name.c_str(), time_s,
                  longest_reorient_s, verdict(time_s <= longest_reorient_s));
    }
    const bool is_analysis = name.starts_with("whole_analysis/");
    if (!is_analysis && !name.starts_with("whole_post/")) continue;
    const Row& row = rows_.at(name);
    const double floor_s = floor_time_s(row);
    const double largest = is_analysis ? largest_analysis_share_of_floor : largest_share_of_floor;
    if (floor_s > 0.0)
      std::printf("%-36s %6.2f x floor      at most %3.1f: %s\n", name.c_str(),
                  row.time_s / floor_s, largest, verdict(row.time_s <= largest * floor_s));
    std::printf("%-36s %6.1f bytes/point  at most %3.0f: %s\n", name.c_str(), row.bytes_per_point,
                largest_bytes_per_point, verdict(row.bytes_per_point <= largest_bytes_per_point));
    if (!name.ends_with(large_size)) continue;
    const auto small =
        rows_.find(name.substr(0, name.size() - large_size.size()) + std::string{small_size});
    if (small == rows_.end()) continue;
    const double growth = row.time_s / small->second.time_s;
    std::printf("%-36s %6.2f x 10^5        at most %3.0f: %s\n", name.c_str(), growth,
                largest_growth, verdict(growth <= largest_growth));
  }
}

}  // namespace pentapost::bench
