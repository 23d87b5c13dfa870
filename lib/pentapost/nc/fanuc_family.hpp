#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/nc/common_options.hpp"
#include "pentapost/path/motion.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::nc {

/// What controls that speak Fanuc's language differ in, beside the options that all controls share.
struct FanucSettings {
  enum class Dwell : std::uint8_t {
    p_milliseconds,  ///< "G4 P1500"
    x_seconds,       ///< "G4 X1.5"
  };

  CommonSettings common;
  std::string program_line;  ///< "O0001 (NAME)"; empty: the control has none
  bool tape_marks = true;    ///< "%" around the program
  bool modal_words = true;   ///< leave out axis words that do not change
  Dwell dwell = Dwell::p_milliseconds;
  std::vector<std::string> rigid_tapping;  ///< before a tapping cycle; {speed}: the S word
  double largest_inverse_time = 0.0;       ///< 1/min, > 0
  int inverse_time_decimals = 3;
  int whole_digits = 6;  ///< most digits of an axis word before the point
  std::int64_t largest_block_number = 99'999;
};

/// Writes `motion` in Fanuc's language; see Dialect::write. A drilling cycle, an arc or inverse
/// time that this family cannot have is a std::logic_error: the planning knows the abilities.
///
/// @return Problem not_in_dialect where a code is missing, out_of_domain where a number has more
///         digits than the control takes; both with the CL line.
Status write_fanuc_family(const path::Motion& motion, const path::ProgramHeader& header,
                          const FanucSettings& settings, std::string& out);

/// A comment as this family writes it: upper case, without brackets.
std::string fanuc_comment(std::string_view text);

}  // namespace pentapost::nc
