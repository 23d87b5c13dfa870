// How fast CL data becomes a proven NC program, stage by stage, beside the floor that only reads
// and prints the same count of numbers. Ends with the ratios that the project holds itself to.

#include "five_axis_cl.hpp"
#include "heap_count.hpp"
#include "number_floor.hpp"
#include "stages.hpp"

#include "pentapost/cl/reader.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

namespace {

using namespace pentapost;
using namespace pentapost::bench;

constexpr std::int64_t small = 100'000;
constexpr std::int64_t large = 1'000'000;

/// The CL text of a size, made once.
const std::string& cl_of(std::int64_t points) {
  static std::map<std::int64_t, std::string> texts;
  auto& text = texts[points];
  if (text.empty()) text = five_axis_cl(static_cast<std::size_t>(points));
  return text;
}

/// Runs `call` for the times, after one run for the memory. `call` gives the bytes of the text that
/// it made, which do not count.
template <class Call>
void measure(benchmark::State& state, const Call& call) {
  const auto points = static_cast<double>(state.range(0));
  std::size_t text_bytes = 0;
  const std::size_t peak = heap_peak_of([&] { text_bytes = call(); });
  for (auto _ : state) call();
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["peak_bytes_per_point"] =
      (static_cast<double>(peak) - static_cast<double>(text_bytes)) / points;
}

void floor_of_numbers(benchmark::State& state) {
  const std::string& cl = cl_of(state.range(0));
  measure(state, [&] {
    std::string out;
    out.reserve(cl.size());
    benchmark::DoNotOptimize(number_floor(cl, out));
    return out.capacity();
  });
}

void read_cl(benchmark::State& state) {
  const std::string& cl = cl_of(state.range(0));
  measure(state, [&] {
    const auto result = cl::read(cl);
    benchmark::DoNotOptimize(result.points);
    return std::size_t{0};
  });
}

void inverse(benchmark::State& state) {
  const path::ToolPath path = bench_path(cl_of(state.range(0)));
  const kinematics::Model model{bench_machine().chain};
  measure(state, [&] {
    benchmark::DoNotOptimize(invert_all(model, path));
    return std::size_t{0};
  });
}

void whole_post(benchmark::State& state) {
  const jobs::PostJob job = bench_job(cl_of(state.range(0)));
  std::string problem;
  measure(state, [&] {
    const auto report = jobs::post(job);
    if (!report) {
      problem = report.error().message;
      return std::size_t{0};
    }
    return report->nc.size();
  });
  if (!problem.empty()) state.SkipWithError(problem.c_str());
}

BENCHMARK(floor_of_numbers)->Arg(small)->Arg(large);
BENCHMARK(read_cl)->Arg(small)->Arg(large);
BENCHMARK(inverse)->Arg(small)->Arg(large);
BENCHMARK(whole_post)->Arg(small)->Arg(large);

/// Prints as usual and keeps the fastest run of each benchmark: the machine may be busy.
class Summary : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const std::string name = run.run_name.function_name + '/' + run.run_name.args;
      const double time_s = run.cpu_accumulated_time / static_cast<double>(run.iterations);
      const auto [row, is_new] = fastest_s_.try_emplace(name, time_s);
      row->second = std::min(row->second, time_s);
      peak_[name] = run.counters.at("peak_bytes_per_point");
    }
  }

  void print() const {
    std::printf("\nfastest run of each:\n");
    for (const auto& [name, time_s] : fastest_s_) {
      const double points = std::stod(name.substr(name.find('/') + 1));
      std::printf("  %-28s %8.1f ns/point  %8.2f x floor  %8.1f bytes/point\n", name.c_str(),
                  1e9 * time_s / points, time_s / time_of("floor_of_numbers", name),
                  peak_.at(name));
    }
    std::printf("\nwhole post of 10^6 points / 10^5 points: %.2f (at most 11)\n",
                fastest("whole_post/1000000") / fastest("whole_post/100000"));
  }

 private:
  double fastest(const std::string& name) const {
    const auto row = fastest_s_.find(name);
    return row == fastest_s_.end() ? 0.0 : row->second;
  }
  /// Time of `function` with the argument of the benchmark `name`.
  double time_of(const std::string& function, const std::string& name) const {
    return fastest(function + name.substr(name.find('/')));
  }
  std::map<std::string, double> fastest_s_, peak_;
};

}  // namespace

int main(int argument_count, char** arguments) {
  benchmark::Initialize(&argument_count, arguments);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) return 2;
  Summary summary;
  benchmark::RunSpecifiedBenchmarks(&summary);
  summary.print();
  return 0;
}
