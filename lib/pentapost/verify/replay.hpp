#pragma once

#include "pentapost/verify/axis_columns.hpp"
#include "pentapost/verify/block_deviation.hpp"
#include "pentapost/verify/cl_state.hpp"
#include "pentapost/verify/excursion.hpp"
#include "pentapost/verify/proof.hpp"
#include "pentapost/verify/tool_position.hpp"
#include "pentapost/verify/witness.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace pentapost::verify {

/// Walks through a program item by item and holds each block against the CL path. Keeps the state
/// of the machine, not the blocks.
class Replay {
 public:
  /// The claim must outlive the replay.
  Replay(const Claim& claim, const AxisColumns& columns);
  Replay(const Replay&) = delete;
  Replay& operator=(const Replay&) = delete;

  Status take(const nc::ReadItem& item);
  /// After the last item.
  Result<Proof> finish();

 private:
  // Those that give a bool give false where the proof has failed; problem_ says why.

  // replay.cpp: the program
  bool take_motion(const nc::ReadMotion& motion);
  bool is_sane(const nc::ReadMotion& motion);
  bool keeps_datum(const nc::ReadMotion& motion);
  bool keeps_length_register(const nc::ReadMotion& motion);
  void leave_by_machine_words(std::uint8_t columns);
  void count_spans(const nc::ReadMotion& motion);
  void widen(std::size_t column, double word);
  bool fail(const std::string& what);

  // replay_path.cpp: blocks on the path
  bool on_path(const nc::ReadMotion& motion, const Covered& covered);
  bool reach_point(const nc::ReadMotion& motion, const Covered& covered);
  bool cut(const nc::ReadMotion& motion, const Covered& covered);
  bool cut_line(const nc::ReadMotion& motion, const Covered& covered);
  bool cut_arc(const nc::ReadMotion& motion, const Covered& covered);
  bool drill(const nc::ReadMotion& motion, const Covered& covered);
  bool feed_is_right(const nc::ReadMotion& motion, const Covered& covered);
  bool settings_are_right();
  bool prove(const Deviation& found);
  bool search(const BlockCurve& curve, const MovePart& part);
  bool needs_place(const Stop& stop, const char* which);
  BlockCurve curve() const;
  const path::Segment& move_to(std::uint32_t point);
  Vec3 move_start_mm(std::uint32_t point) const;
  std::optional<Vec3> last_place_mm(std::uint32_t point) const;
  double move_length_mm(std::uint32_t point);
  std::optional<double> gauge_length_mm() const;

  // replay_excursion.cpp: blocks off the path
  bool off_path(const nc::ReadMotion& motion, const path::Block& block);
  bool turns_in_place(const ToolPlace& left);
  bool come_back();
  void leave_path();

  const Claim& claim_;
  const AxisColumns& columns_;
  ChainShape shape_;
  ToolPosition position_;
  Coverage coverage_;
  ClState cl_;
  Excursion excursion_;
  /// What is allowed, and what was found at most.
  struct Held {
    Deviation limit, proven;
  };
  const Held& held() const { return near_pole_ ? held_near_pole_ : held_; }
  Held held_;
  Held held_near_pole_;         ///< feed blocks where the CL axis was changed
  bool near_pole_ = false;      ///< the block in hand is one of them
  double tip_resolution_mm_;    ///< half the last digit, over three axes
  double axis_resolution_rad_;  ///< half the last digit, over two axes
  Proof proof_;
  Problem problem_{.code = Code::proof_failed, .message = {}};

  // of the program
  std::uint32_t text_line_ = 0;
  std::uint32_t cl_line_ = 0;  ///< of the block in hand; 0: none
  bool ended_ = false;
  std::uint8_t spanned_ = 0;  ///< columns whose span has begun
  std::optional<int> tool_;
  nc::ReadSpindle spindle_;
  int length_register_ = 0;  ///< since the tool was called; 0: none yet
  std::optional<int> work_offset_;
  Words datum_shift_{};

  // of the path
  bool entered_ = false;
  bool settings_are_new_ = true;
  std::optional<path::Segment> move_;
  std::uint32_t move_point_ = 0;         ///< whose move move_ is
  std::optional<Vec3> hole_retract_mm_;  ///< where the last hole left the tool; nullopt: not a hole
};

}  // namespace pentapost::verify
