#pragma once

#include "pentapost/jobs/reorient.hpp"
#include "pentapost/json/strict_reader.hpp"
#include "server/json/job_source.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace pentapost::server {

/// The keys of a reorientation that can be words too.
inline constexpr std::array<std::string_view, 3> reorient_words{"objective", "max_tilt_deg",
                                                                "setup_accuracy_deg"};

/// Reads by what a setup is chosen, and from which: objective, max_tilt_deg, step_deg, allowed_deg,
/// forbidden_deg, setup_accuracy_deg, origin_bounds_mm, clearance. What is not given keeps its
/// default.
///
/// Failures are kept by `source`: wrong_type, out_of_domain, missing_key, conflicting_keys.
void read_reorient_bounds(JobSource& source, const json::Object& object, jobs::ReorientJob& result);

/// Reads what is to be answered besides: candidates, map. The map is answered unless it is refused.
void read_reorient_answer(const json::Object& object, jobs::ReorientJob& result);

/// Reads whether the best setup is asked for besides something else: the key reorient, true or an
/// object with the keys of read_reorient_bounds(), or the word of that name, true or false.
///
/// @return without a path; nullopt: not asked for, or the failure is kept.
std::optional<jobs::ReorientJob> read_reorient_choice(JobSource& source, const json::Object& job,
                                                      const machine::Definition& machine);

}  // namespace pentapost::server
