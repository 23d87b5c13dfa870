#pragma once

#include "pentapost/kinematics/model.hpp"
#include "pentapost/path/segment.hpp"

#include <cstdint>

namespace pentapost::analysis {

/// Where a program has the machine between two blocks.
struct JointPosture {
  /// Joints as the words command them. Where the words are the tip's (TCP) the linear ones are not
  /// read: they follow from the tip.
  kinematics::Joints joints;
  Vec3 tip_mm = Vec3::Zero();  ///< frame of the tool path, in the table's orientation
  bool words_are_tip = true;
};

/// A block from the posture before it.
struct JointMove {
  enum class Kind : std::uint8_t { rapid, cut };
  /// What F counts.
  enum class Feed : std::uint8_t {
    tip,           ///< mm/min along the tip's path
    axes,          ///< mm and degrees alike, per minute, along the way of all axes
    inverse_time,  ///< 1/min of the whole block
  };
  Kind kind = Kind::cut;
  JointPosture to;
  const path::Segment* arc = nullptr;  ///< way of the tip; nullptr: straight, as the words run
  Feed feed_rule = Feed::tip;
  double feed = 0.0;        ///< <= 0: none
  std::uint32_t block = 0;  ///< motion blocks of the program, from 0
  std::uint32_t line = 0;   ///< of the program's text
};

}  // namespace pentapost::analysis
