#pragma once

#include "pentapost/nc/lint.hpp"

namespace pentapost::nc::lint_rules {

extern const Lint fanuc_30i_lint, haas_ngc_lint, linuxcnc_lint;

}  // namespace pentapost::nc::lint_rules
