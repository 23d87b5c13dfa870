// Any bytes as an NC program, read in every dialect and analysed: no crash, no hang, and what is
// reported is finite.

#include "machines/bundled.hpp"
#include "pentapost/jobs/analyse.hpp"
#include "pentapost/nc/reader.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

using namespace pentapost;

void check(bool holds) {
  if (!holds) std::abort();
}

void check_report(const jobs::AnalyseReport& report) {
  check(std::isfinite(report.predicted_time_s) && std::isfinite(report.length_mm));
  check(report.predicted_time_s >= report.programmed_time_s * (1.0 - 1e-9));
  for (const auto& axis : report.axes) check(std::isfinite(axis.peak_speed));
  for (const auto& zone : report.zones.zones) check(zone.to.s_mm >= zone.from.s_mm);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::array machines{sample::bundled_machine("hermle-c600u"),
                                   sample::bundled_machine("dmu-50-evolution"),
                                   sample::bundled_machine("generic-ca-head")};
  const std::string text{reinterpret_cast<const char*>(data), size};
  for (const auto& reader : nc::readers_of_dialects()) {
    for (const auto& machine : machines) {
      const auto report =
          jobs::analyse({.job = {.machine = machine, .path = {}},
                         .nc = jobs::NcProgram{.text = text, .dialect = std::string{reader.name}},
                         .samples = analysis::Samples::fewest});
      if (report)
        check_report(*report);
      else
        check(!report.error().message.empty());
    }
  }
  return 0;
}
