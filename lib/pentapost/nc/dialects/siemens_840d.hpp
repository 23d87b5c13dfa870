#pragma once

#include "pentapost/nc/dialect.hpp"

namespace pentapost::nc {

extern const Dialect siemens_840d;

}  // namespace pentapost::nc
