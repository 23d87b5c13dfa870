#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/kinematics/turns.hpp"
#include "pentapost/path/motion.hpp"
#include "pentapost/path/segment.hpp"
#include "pentapost/plan/axis_path.hpp"
#include "pentapost/plan/branches.hpp"
#include "pentapost/plan/settings.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace pentapost::plan {

/// A posture at the digits printed: the words, and what the machine makes of them.
struct Posture {
  std::array<std::int64_t, 5> word{};  ///< in the order of WordColumns::letters
  RotaryPair printed;                  ///< rotary values of the words
  Vec3 linear_mm = Vec3::Zero();       ///< Output::axes: linear values of the words
  Vec3 tip_mm = Vec3::Zero();          ///< tool tip that results, frame of the tool path
  Vec3 axis = Vec3::UnitZ();           ///< tool axis that results
};

/// Which word letter belongs to which joint.
struct WordColumns {
  std::string letters;     ///< linear axes A to Z, then rotary axes A to Z
  std::size_t first = 3;   ///< column of the first rotary joint
  std::size_t second = 4;  ///< of the second
  int count = 5;
};
WordColumns word_columns(const kinematics::Model& model);

/// Turns poses into words and back.
class BlockMaker {
 public:
  /// @param gauge_length_mm  true gauge length of the tool; 0 where unknown.
  /// @param check_linear  the linear ranges are held, on the physical joints.
  BlockMaker(const kinematics::Model& model, const JointRanges& ranges, const Settings& settings,
             double gauge_length_mm, bool check_linear);

  /// The posture for a tool tip (frame of the tool path) at rotary values; linear words follow
  /// from the rotary words as printed.
  /// @return Problem rotary_range, linear_range or linear_singular with the CL line.
  Result<Posture> posture(const Vec3& tip_mm, const RotaryPair& rotary, std::uint32_t cl_line);

  /// The posture in the middle of the joint-linear block between two.
  Posture middle(const Posture& from, const Posture& to) const;

  /// A length as a count of the last digit printed.
  std::int64_t count_mm(double length_mm) const;

  const WordColumns& columns() const { return columns_; }
  double gauge_in_words_mm() const { return gauge_in_words_mm_; }

 private:
  Status check_ranges(const Vec3& tip_mm, const RotaryPair& rotary, std::uint32_t cl_line) const;

  const kinematics::Model& model_;
  const JointRanges& ranges_;
  const Settings& settings_;
  const double gauge_length_mm_;
  const double gauge_in_words_mm_;
  const Vec3 added_by_control_mm_;  ///< Output::axes: joint values less words
  const bool check_linear_;
  const WordColumns columns_;
  // the last rotary values: most points of real files keep them
  RotaryPair last_rotary_;
  Posture last_;
  std::optional<kinematics::Turns> last_turns_;  ///< of the words of last_; none: no last yet
};

}  // namespace pentapost::plan
