#include "pentapost/verify/proof.hpp"

#include "pentapost/verify/pole_allowance.hpp"
#include "pentapost/verify/replay.hpp"

#include <algorithm>
#include <cmath>

namespace pentapost::verify {
namespace {

Problem failed(std::string message) { return {Code::proof_failed, std::move(message)}; }

bool is_usable_tolerance(double tolerance) { return std::isfinite(tolerance) && tolerance >= 0.0; }

/// Checks what the replay takes for granted.
Status check(const Claim& claim) {
  const path::ToolPath& cl = claim.tool_path;
  if (cl.axis_wp.size() != cl.size() || cl.cl_line.size() != cl.size() ||
      cl.move.size() != cl.size())
    return failed("The columns of the CL path differ in length");
  if (claim.motion.letters != claim.reader_setup.letters)
    return failed("The program was written with the words \"" + claim.motion.letters +
                  "\" and is read with \"" + claim.reader_setup.letters + '"');
  if (!is_usable_tolerance(claim.tip_tolerance_mm) ||
      !is_usable_tolerance(claim.axis_tolerance_rad) || !claim.origin_mm.allFinite())
    return failed("A tolerance or the origin is not finite");
  const bool gauges_are_finite =
      std::all_of(claim.gauge_length_mm.begin(), claim.gauge_length_mm.end(),
                  [](const auto& tool) { return std::isfinite(tool.second); });
  if (!gauges_are_finite) return failed("A gauge length is not finite");
  return check_pole_allowance(claim);
}

}  // namespace

Result<Proof> prove(std::string_view nc, const nc::Reader& reader, const Claim& claim) {
  const Status usable = check(claim);
  if (!usable) return usable.error();
  const auto columns = AxisColumns::make(claim.motion.letters, claim.model);
  if (!columns) return columns.error();
  Replay replay{claim, *columns};
  const Status read = reader.read(
      nc, claim.reader_setup, [&replay](const nc::ReadItem& item) { return replay.take(item); });
  if (!read) {
    Problem problem = read.error();
    if (problem.code != Code::proof_failed)
      problem.message = "The program cannot be read back: " + problem.message;
    problem.code = Code::proof_failed;
    return problem;
  }
  return replay.finish();
}

}  // namespace pentapost::verify
