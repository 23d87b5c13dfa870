#include "pentapost/nc/program_header.hpp"

namespace pentapost::nc {

std::vector<std::string> header_comments(const path::ProgramHeader& header,
                                         const path::Motion& motion) {
  std::vector<std::string> comments;
  const auto add = [&](const char* what, const std::string& value) {
    if (!value.empty()) comments.push_back(what + value);
  };
  add("PROGRAM ", header.program_name);
  add("MACHINE ", header.machine);
  add("DEFINITION ", header.machine_hash);
  comments.emplace_back("UNITS MM");
  comments.emplace_back(motion.output == Output::tcp ? "OUTPUT TCP" : "OUTPUT AXES");
  comments.insert(comments.end(), header.comments.begin(), header.comments.end());
  return comments;
}

}  // namespace pentapost::nc
