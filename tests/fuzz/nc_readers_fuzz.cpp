// Any bytes, through every NC reader: no crash, no hang, and what comes out is finite.

#include "pentapost/nc/reader.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

using pentapost::nc::ReadItem;
using pentapost::nc::ReadMotion;

void check(bool holds) {
  if (!holds) std::abort();
}

void check_motion(const ReadMotion& motion, std::size_t columns) {
  check((motion.stated >> columns) == 0 && (motion.known >> columns) == 0);
  for (const double position : motion.position) check(std::isfinite(position));
  for (const double shift : motion.datum_shift) check(std::isfinite(shift));
  check(std::isfinite(motion.feed) && motion.feed >= 0.0);
  check((motion.kind == ReadMotion::Kind::rapid) == (motion.feed_mode == ReadMotion::Feed::none));
  check(motion.kind == ReadMotion::Kind::rapid || motion.feed > 0.0);
  check(std::isfinite(motion.centre_x_mm) && std::isfinite(motion.centre_y_mm));
  check(std::isfinite(motion.clearance_z_mm) && std::isfinite(motion.retract_z_mm));
  check(motion.cycle.empty() == (motion.kind != ReadMotion::Kind::drill));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  for (const auto& reader : pentapost::nc::readers_of_dialects()) {
    for (const std::string_view letters : {"XYZAC", "XYZBC", "XYZ"}) {
      std::uint32_t line = 0;
      bool ended = false;
      const auto status = reader.read(
          text, {.letters = std::string{letters}}, [&](const ReadItem& item) -> pentapost::Status {
            check(item.text_line >= line && item.text_line > 0);
            check(!ended);
            line = item.text_line;
            if (const auto* motion = std::get_if<ReadMotion>(&item.what))
              check_motion(*motion, letters.size());
            ended = std::holds_alternative<pentapost::nc::ReadEnd>(item.what);
            return pentapost::ok();
          });
      check(status.has_value() ? ended : !status.error().message.empty());
    }
  }
  return 0;
}
