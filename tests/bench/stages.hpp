#pragma once

#include "pentapost/jobs/post.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/motion.hpp"
#include "pentapost/path/tool_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/candidates.hpp"
#include "pentapost/plan/settings.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace pentapost::bench {

/// A language and an output of the benchmarks' programs.
struct Target {
  std::string_view dialect;
  Output output;
  int words;  ///< numbers of a block: block number, X Y Z A C, and F where it changes every time
};

inline constexpr Target targets[]{
    {"heidenhain-iso", Output::tcp, 6},
    {"heidenhain-iso", Output::axes, 7},
    {"fanuc-30i", Output::tcp, 5},
    {"fanuc-30i", Output::axes, 6},
};

/// "heidenhain-iso/tcp".
std::string name_of(const Target& target);

/// The A/C table of Cripps et al. 2017.
machine::Definition bench_machine();

/// The CL text as a job for that machine.
jobs::PostJob bench_job(std::string cl, const Target& target);

/// One post taken apart: what every stage needs from the stages before it. What fails throws
/// std::logic_error.
class Stages {
 public:
  Stages(const std::string& cl, const Target& target);

  /// Both rotary solutions of every point and the linear values of the first.
  /// @return the count of solutions.
  std::size_t invert() const;
  /// The rotary values of the whole path, as the planning finds them. @return the count of points.
  std::size_t choose() const;
  /// The same by the search through all solutions, for paths that are not plain.
  std::size_t search_branches() const;
  /// Choice, linearisation and feeds. @return the count of blocks.
  std::size_t plan() const;
  /// Reads the CL text and analyses its path. @return the count of zones.
  std::size_t read_and_analyse(const std::string& cl) const;
  /// The program's text into `out`.
  void format(std::string& out) const;
  /// Reads the program's text and proves it. @return the count of blocks.
  std::size_t prove(const std::string& nc) const;

  /// What format() and prove() work on.
  void make_motion();

 private:
  Target target_;
  machine::Definition machine_;
  kinematics::Model model_;
  path::ToolPath path_;
  plan::Settings settings_;
  plan::JointRanges joint_ranges_;
  plan::PointRange range_;
  plan::PoleZone zone_;
  path::Motion motion_;
};

}  // namespace pentapost::bench
