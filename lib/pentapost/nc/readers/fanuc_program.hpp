#pragma once

#include "pentapost/nc/readers/arc.hpp"
#include "pentapost/nc/readers/axis_columns.hpp"
#include "pentapost/nc/readers/fanuc_codes.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/open_words.hpp"

#include <array>
#include <optional>

namespace pentapost::nc::readers::fanuc {

/// The modal state of a Fanuc control. What depends on parameters at power-on is nullopt until the
/// program sets it. Codes are in tenths.
struct Modes {
  std::optional<int> motion, plane, distance, unit, feed_mode;
  std::optional<double> feed;  ///< mm/min, deg/min, 1/min or mm per revolution, by feed_mode
  bool feed_is_inch = false;   ///< feed counts inches where a linear axis moves
  int length = 490;            ///< G43, G43.4 or G49
  std::optional<int> length_register;
  int work_offset = 54;
  bool return_to_initial = true;  ///< G98
  std::optional<int> tool;        ///< T, waiting for M06
  ReadSpindle spindle = {};
};

/// A canned cycle in force. Levels are absolute, mm.
struct Cycle {
  int code = 800;  ///< G80: none
  std::optional<double> initial_z, clearance_z, bottom_z;
  double peck_mm = 0.0;
  double dwell_s = 0.0;
};

/// Executes blocks in the order of the control and hands on what they do.
class Program {
 public:
  Program(AxisColumns columns, ItemStream& items) : columns_{columns}, items_{items} {}

  /// @return false: the stream has the Problem.
  bool execute(const Words& words);
  bool has_ended() const { return ended_; }

 private:
  static constexpr std::size_t group_count = static_cast<std::size_t>(Group::cancelled) + 1;

  // fanuc_program.cpp
  bool sort_codes();
  std::optional<int> asked(Group group) const;
  bool set_modes();
  bool set_feed();
  bool set_work_offset();
  bool set_length();
  bool before_motion();
  bool change_tool();
  bool after_motion();
  bool one_shot(int code);
  bool nothing_left();
  bool is_tcp() const { return modes_.length == 434; }

  // fanuc_motion.cpp
  bool move();
  bool arc(ReadMotion& motion);
  bool arc_centre(ArcBlock& arc_block);
  bool machine_move();
  bool reference_return();
  void forget_after_machine_move(std::uint8_t stated);
  bool target(std::size_t column, double& value);
  bool fill_feed(ReadMotion& motion);
  ReadMotion started_motion(ReadMotion::Kind kind) const;

  // fanuc_cycles.cpp
  bool cycle_block();
  bool cycle_data();
  bool cycle_levels();
  bool hole();
  void cancel_cycle() { cycle_ = {}; }

  bool take_integer(char letter, std::optional<int>& value);
  bool length_of(char letter, double& length_mm);
  bool angle_of(char letter, double& angle_deg);

  AxisColumns columns_;
  ItemStream& items_;
  Modes modes_;
  Cycle cycle_;
  bool ended_ = false;

  // the block in execution
  OpenWords words_;
  std::array<int, group_count> asked_{};
  std::uint32_t groups_ = 0;  ///< bits of the groups that the block states
};

}  // namespace pentapost::nc::readers::fanuc
