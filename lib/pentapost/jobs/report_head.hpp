#pragma once

#include <cstdint>
#include <string>

namespace pentapost::jobs {

/// What a report is about: the machine's definition and the path's source.
struct ReportHead {
  std::string machine_name, machine_version, machine_sha256;
  std::string cl_sha256;   ///< of the CL text; empty for points
  std::string cl_dialect;  ///< as detected; empty for points
  std::string cl_units;    ///< "mm" or "inch"
  std::uint64_t cl_lines = 0, cl_points = 0;
};

}  // namespace pentapost::jobs
