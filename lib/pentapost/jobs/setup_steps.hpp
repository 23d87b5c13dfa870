#pragma once

#include "pentapost/jobs/post.hpp"

#include <string>
#include <vector>

namespace pentapost::jobs {

/// How to clamp a part for a setup, in steps that a person can follow: turn about Z, tilt about X,
/// datum. The machine's axes at zero; "right-handed": the thumb of the right hand points along the
/// positive axis, the fingers show the way.
std::vector<std::string> setup_steps(const Setup& setup);

}  // namespace pentapost::jobs
