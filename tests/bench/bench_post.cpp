// How fast CL data becomes a proven NC program, stage by stage, and how fast it is analysed,
// reoriented and compared, beside the floor that only reads and prints the same count of numbers.
// Ends with the ratios that the project holds itself to.

#include "five_axis_cl.hpp"
#include "heap_count.hpp"
#include "number_floor.hpp"
#include "stages.hpp"
#include "summary.hpp"

#include "pentapost/cl/reader.hpp"
#include "pentapost/jobs/compare.hpp"
#include "pentapost/jobs/reorient.hpp"

#include <benchmark/benchmark.h>

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace pentapost;
using namespace pentapost::bench;

constexpr std::size_t sizes[]{10'000, 100'000, 1'000'000};
/// Of the map that a reorientation is measured with.
constexpr double map_step_deg = 2.0;

/// The CL text of a size, made once.
const std::string& cl_of(std::size_t points) {
  static std::map<std::size_t, std::string> texts;
  auto& text = texts[points];
  if (text.empty()) text = five_axis_cl(points);
  return text;
}

/// Runs `call` for the times, after one run for the memory. `call` gives the bytes of the text that
/// it made, which do not count.
template <class Call>
void measure(benchmark::State& state, std::size_t points, int words, const Call& call) {
  const auto count = static_cast<double>(points);
  std::size_t text_bytes = 0;
  const std::size_t peak = heap_peak_of([&] { text_bytes = call(); });
  for (auto _ : state) call();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points));
  state.counters["points"] = count;
  state.counters["words"] = words;
  state.counters["peak_bytes_per_point"] =
      (static_cast<double>(peak) - static_cast<double>(text_bytes)) / count;
}

/// @param call  (points): makes what is to be measured ready and gives the call for measure().
template <class MakeCall>
void add(const std::string& name, std::size_t points, int words, const MakeCall& make_call) {
  benchmark::RegisterBenchmark(
      (name + '/' + std::to_string(points)).c_str(),
      [=](benchmark::State& state) { measure(state, points, words, make_call(points)); })
      ->Unit(benchmark::kMillisecond);
}

void add_floor(std::size_t points, int words) {
  add("floor/" + std::to_string(words) + "_words", points, words, [words](std::size_t size) {
    return [&cl = cl_of(size), words] {
      std::string out;
      out.reserve(cl.size());
      benchmark::DoNotOptimize(number_floor(cl, words, out));
      return out.capacity();
    };
  });
}

void add_read(std::size_t points, int words) {
  add("read", points, words, [](std::size_t size) {
    return [&cl = cl_of(size)] {
      const auto result = cl::read(cl);
      benchmark::DoNotOptimize(result.points);
      return std::size_t{0};
    };
  });
}

using Stage = std::size_t (Stages::*)() const;

void add_stage(const std::string& name, std::size_t points, const Target& target, Stage stage) {
  add(name, points, target.words, [target, stage](std::size_t size) {
    return [stages = std::make_shared<Stages>(cl_of(size), target), stage] {
      benchmark::DoNotOptimize((*stages.*stage)());
      return std::size_t{0};
    };
  });
}

std::shared_ptr<Stages> planned(std::size_t points, const Target& target) {
  auto stages = std::make_shared<Stages>(cl_of(points), target);
  stages->make_motion();
  return stages;
}

void add_format(std::size_t points, const Target& target) {
  add("format/" + name_of(target), points, target.words, [target](std::size_t size) {
    return [stages = planned(size, target)] {
      std::string nc;
      stages->format(nc);
      return nc.size();
    };
  });
}

void add_prove(std::size_t points, const Target& target) {
  add("prove/" + name_of(target), points, target.words, [target](std::size_t size) {
    auto stages = planned(size, target);
    auto nc = std::make_shared<std::string>();
    stages->format(*nc);
    return [stages, nc] {
      benchmark::DoNotOptimize(stages->prove(*nc));
      return std::size_t{0};
    };
  });
}

void add_whole_post(std::size_t points, const Target& target) {
  add("whole_post/" + name_of(target), points, target.words, [target](std::size_t size) {
    return [job = std::make_shared<jobs::PostJob>(bench_job(cl_of(size), target))] {
      const auto report = jobs::post(*job);
      if (!report) throw std::logic_error{report.error().message};
      return report->nc.size();
    };
  });
}

void add_whole_analysis(std::size_t points, const Target& target) {
  add("whole_analysis", points, target.words, [target](std::size_t size) {
    return [stages = std::make_shared<Stages>(cl_of(size), target), &cl = cl_of(size)] {
      benchmark::DoNotOptimize(stages->read_and_analyse(cl));
      return std::size_t{0};
    };
  });
}

void add_whole_reorient(std::size_t points, const Target& target, std::optional<double> step_deg) {
  const std::string name = step_deg ? "whole_reorient/map" : "whole_reorient";
  add(name, points, target.words, [target, step_deg](std::size_t size) {
    return [job = std::make_shared<jobs::ReorientJob>(jobs::ReorientJob{
                .job = bench_job(cl_of(size), target), .map_step_deg = step_deg})] {
      const auto report = jobs::reorient(*job);
      if (!report) throw std::logic_error{report.error().message};
      return std::size_t{0};
    };
  });
}

void add_whole_compare(std::size_t points, const Target& target) {
  constexpr std::size_t machines = 4;
  add("whole_compare/" + std::to_string(machines) + "_machines", points, target.words,
      [target](std::size_t size) {
        return [job = std::make_shared<jobs::CompareJob>(jobs::CompareJob{
                    .job = bench_job(cl_of(size), target),
                    .machines = std::vector<machine::Definition>(machines, bench_machine())})] {
          const auto report = jobs::compare(*job);
          if (!report) throw std::logic_error{report.error().message};
          return std::size_t{0};
        };
      });
}

void add_all() {
  for (const std::size_t points : sizes) {
    for (const int words : {5, 6, 7}) add_floor(points, words);
    const Target& usual = targets[0];
    add_read(points, usual.words);
    add_stage("inverse", points, usual, &Stages::invert);
    add_stage("choice", points, usual, &Stages::choose);
    add_stage("choice/all_solutions", points, usual, &Stages::search_branches);
    add_whole_analysis(points, usual);
    add_whole_reorient(points, usual, std::nullopt);
    add_whole_reorient(points, usual, map_step_deg);
    add_whole_compare(points, usual);
    for (const Target& target : targets) {
      add_stage("plan/" + name_of(target), points, target, &Stages::plan);
      add_format(points, target);
      add_prove(points, target);
      add_whole_post(points, target);
    }
  }
}

}  // namespace

int main(int argument_count, char** arguments) {
  benchmark::Initialize(&argument_count, arguments);
  if (benchmark::ReportUnrecognizedArguments(argument_count, arguments)) return 2;
  add_all();
  Summary summary;
  benchmark::RunSpecifiedBenchmarks(&summary);
  summary.print();
  return 0;
}
