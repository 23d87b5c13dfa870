#include "pentapost/nc/lint.hpp"
#include "pentapost/nc/lint_rules/fanuc_lints.hpp"
#include "pentapost/nc/lint_rules/heidenhain_lints.hpp"
#include "pentapost/nc/lint_rules/siemens_lint.hpp"

#include <algorithm>
#include <array>

namespace pentapost::nc {
namespace {

constexpr std::array table{&lint_rules::fanuc_30i_lint,  &lint_rules::haas_ngc_lint,
                           &lint_rules::heidenhain_lint, &lint_rules::heidenhain_iso_lint,
                           &lint_rules::linuxcnc_lint,   &lint_rules::siemens_840d_lint};

}  // namespace

std::span<const Lint* const> lints() { return table; }

const Lint* find_lint(std::string_view dialect) {
  const auto found = std::ranges::find(table, dialect, &Lint::dialect);
  return found == table.end() ? nullptr : *found;
}

}  // namespace pentapost::nc
