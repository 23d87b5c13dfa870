#pragma once

#include "pentapost/jobs/analyse.hpp"
#include "pentapost/jobs/compare.hpp"
#include "pentapost/jobs/post.hpp"
#include "pentapost/jobs/reorient.hpp"
#include "pentapost/machine/library.hpp"

#include <functional>
#include <string>

namespace pentapost::server {

/// What the endpoints work with. Tests put their own in.
struct Services {
  machine::Library machines;
  std::function<Result<jobs::PostReport>(const jobs::PostJob&)> post;
  std::function<Result<jobs::AnalyseReport>(const jobs::AnalyseJob&)> analyse;
  std::function<Result<jobs::ReorientReport>(const jobs::ReorientJob&)> reorient;
  std::function<Result<jobs::CompareReport>(const jobs::CompareJob&)> compare;
  std::function<std::string()> next_request_id;  ///< called from several threads
};

}  // namespace pentapost::server
