#pragma once

#include "pentapost/core/output.hpp"
#include "pentapost/kinematics/model.hpp"
#include "pentapost/nc/reader.hpp"
#include "pentapost/verify/axis_columns.hpp"
#include "pentapost/verify/block_curve.hpp"

#include <cstdint>
#include <optional>

namespace pentapost::verify {

/// What the linear words of a block are.
enum class Meaning : std::uint8_t {
  unknown,  ///< nothing that this output provides for
  tip,      ///< tool tip in the CL frame: TCP is on, or all rotary axes are at zero
  joints,   ///< joint values
};

/// Where the control has the tool between two blocks.
struct Stop {
  std::uint8_t known = 0;  ///< bit i: words[i] holds
  Meaning meaning = Meaning::unknown;
  bool placed = false;           ///< joints and station hold
  bool length_is_added = false;  ///< the control adds the tool length on a machine whose head turns
  Words words{};
  kinematics::Joints joints;
  Station station;
};

/// Follows the tool through the words of a program.
class ToolPosition {
 public:
  /// @param origin_mm  CL origin in the table frame.
  ToolPosition(const ChainShape& shape, const AxisColumns& columns, Output output,
               const Vec3& origin_mm);

  /// Goes to the end of the block; a hole ends at its bottom.
  /// @param gauge_length_mm  nullopt: not known.
  void go(const nc::ReadMotion& motion, std::optional<double> gauge_length_mm);
  /// The words of these columns no longer hold.
  void lose(std::uint8_t columns);
  /// Goes on from a place of place_with().
  void set(const Stop& stop) { now_ = stop; }

  const Stop& before() const { return before_; }  ///< start of the last block
  const Stop& now() const { return now_; }
  /// As now(), with another word in one column. Only where now() is placed.
  Stop place_with(std::size_t column, double word, double gauge_length_mm) const;

 private:
  Meaning meaning_of(const nc::ReadMotion& motion) const;
  bool rotary_words_are_zero(const Words& words) const;
  bool place(Stop& stop, std::optional<double> gauge_length_mm) const;

  const ChainShape& shape_;
  const AxisColumns& columns_;
  Output output_;
  Vec3 origin_mm_;
  Vec3 length_direction_;  ///< in which a control adds a tool length
  bool plain_ =
      false;  ///< with all rotary joints at zero the linear words are the tip's coordinates
  bool tcp_ = false;
  Stop before_, now_;
};

}  // namespace pentapost::verify
