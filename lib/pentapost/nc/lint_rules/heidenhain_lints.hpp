#pragma once

#include "pentapost/nc/lint.hpp"

namespace pentapost::nc::lint_rules {

extern const Lint heidenhain_lint, heidenhain_iso_lint;

}  // namespace pentapost::nc::lint_rules
