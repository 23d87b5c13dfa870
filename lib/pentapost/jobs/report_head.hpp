#pragma once

#include <cstdint>
#include <string>

namespace pentapost::jobs {

/// What a report is about: the machine's definition and the path's source.
struct ReportHead {
  std::string machine_name, machine_version, machine_sha256;
  std::string cl_sha256 = {};   ///< of the CL text; empty for points
  std::string cl_dialect = {};  ///< as detected; empty for points
  std::string cl_units = {};    ///< "mm" or "inch"
  std::uint64_t cl_lines = 0, cl_points = 0;
  std::string nc_sha256 = {};   ///< of the NC program that is the path; empty: CL data are
  std::string nc_dialect = {};  ///< that it was read in
  std::uint64_t nc_lines = 0, nc_blocks = 0;  ///< of the text; motion blocks
};

}  // namespace pentapost::jobs
