#pragma once

#include "pentapost/nc/lint.hpp"

namespace pentapost::nc::lint_rules {

extern const Lint siemens_840d_lint;

}  // namespace pentapost::nc::lint_rules
