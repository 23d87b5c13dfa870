#pragma once

#include <cstdint>

namespace pentapost {

/// What X Y Z mean in the NC program.
enum class Output : std::uint8_t {
  tcp,   ///< tool tip in the frame of the clamped workpiece; the control keeps the tip
  axes,  ///< joint values
};

}  // namespace pentapost
