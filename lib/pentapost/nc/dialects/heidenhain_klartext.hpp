#pragma once

#include "pentapost/nc/dialect.hpp"

namespace pentapost::nc {

extern const Dialect heidenhain_klartext;

}  // namespace pentapost::nc
