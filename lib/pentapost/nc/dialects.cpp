#include "pentapost/nc/dialect.hpp"
#include "pentapost/nc/dialects/fanuc_30i.hpp"
#include "pentapost/nc/dialects/heidenhain_iso.hpp"
#include "pentapost/nc/dialects/heidenhain_klartext.hpp"
#include "pentapost/nc/dialects/siemens_840d.hpp"

#include <algorithm>
#include <array>

namespace pentapost::nc {
namespace {

constexpr std::array table{&fanuc_30i, &heidenhain_klartext, &heidenhain_iso, &siemens_840d};

}  // namespace

std::span<const Dialect* const> dialects() { return table; }

const Dialect* find_dialect(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Dialect::name);
  return found == table.end() ? nullptr : *found;
}

}  // namespace pentapost::nc
