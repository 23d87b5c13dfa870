#include "pentapost/nc/fanuc_family.hpp"

#include "pentapost/nc/fanuc_writer.hpp"
#include "pentapost/nc/walk.hpp"

namespace pentapost::nc {

Status write_fanuc_family(const path::Motion& motion, const path::ProgramHeader& header,
                          const FanucSettings& settings, std::string& out) {
  reserve_text(out, motion, settings.common.block_numbers.on ? 8 : 0);
  FanucWriter writer{motion, settings, out};
  writer.start(header);
  if (!walk(motion, writer)) return *writer.problem();
  writer.finish();
  return ok();
}

}  // namespace pentapost::nc
