#pragma once

#include "pentapost/nc/dialect.hpp"

namespace pentapost::nc {

extern const Dialect fanuc_30i;

}  // namespace pentapost::nc
