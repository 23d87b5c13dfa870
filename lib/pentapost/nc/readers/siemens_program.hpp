#pragma once

#include "pentapost/nc/readers/arc.hpp"
#include "pentapost/nc/readers/axis_columns.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/open_words.hpp"
#include "pentapost/nc/readers/siemens_text.hpp"

#include <cstdint>
#include <optional>

namespace pentapost::nc::readers::siemens {

/// What the tool's length is to the control.
struct Edge {
  std::optional<int> number;  ///< D; nullopt: the program has not said it
  bool is_open = false;       ///< a tool change left it to machine data
  bool adds_length() const { return number.value_or(0) > 0; }
  /// Whether the length may be another one than the tool's.
  bool is_doubtful() const { return is_open || number == 0; }
};

/// The modal state of the control. What depends on machine data at the start of a program is
/// nullopt until the program sets it.
struct Modes {
  enum class Unit : std::uint8_t { metric, inch_lengths, inch };

  std::optional<int> motion, plane, feed_mode;
  std::optional<bool> absolute;  ///< G90
  std::optional<Unit> unit;
  std::optional<double> feed;  ///< mm/min, deg/min, 1/min or mm per revolution, by feed_mode
  bool feed_is_inch = false;   ///< feed counts inches where a linear axis moves
  bool tcp = false;            ///< TRAORI
  int work_offset = 0;         ///< 54 to 57, 505 to 599; 0: G500, or not said
  Edge edge;
  std::optional<int> tool, tool_edge;  ///< T waiting for M6, and the D of its block
  ReadSpindle spindle = {};
};

/// A drilling cycle as its parameters say. Levels are absolute, mm.
struct Drilling {
  double retraction_z = 0.0, clearance_z = 0.0, bottom_z = 0.0;
  double peck_mm = 0.0, dwell_s = 0.0;
  double feed_mm_min = 0.0;  ///< 0: the one that is active
  double pitch_mm = 0.0;     ///< 0: no tap
  ReadMotion::Hole hole = ReadMotion::Hole::drill;
  std::string_view cycle;
  std::optional<ReadSpindle::State> spindle_before, spindle_after;  ///< nullopt: as it is
};

/// Executes blocks in the order of the control and hands on what they do.
class Program {
 public:
  /// @param edge_after_change  D that a tool change without D selects; nullopt: not known.
  Program(AxisColumns columns, ItemStream& items, std::optional<int> edge_after_change)
      : columns_{columns}, items_{items}, edge_after_change_{edge_after_change} {}

  /// @return false: the stream has the Problem.
  bool execute(const Block& block);
  bool has_ended() const { return ended_; }

 private:
  // siemens_program.cpp
  bool sort_codes();
  bool sort_code(int code);
  bool state(std::uint32_t group, int code);
  bool set_unit(Modes::Unit unit);
  bool set_work_offset(int code);
  bool dwell();
  bool set_feed();
  bool before_motion();
  bool start_functions();
  bool start_function(int code);
  bool set_edge();
  bool change_tool();
  bool orientation();
  bool shift();
  bool after_motion();
  bool end_function(int code);
  bool turn_spindle(ReadSpindle::State state);
  bool take_integer(char letter, int largest, std::optional<int>& number);

  // siemens_motion.cpp
  bool move();
  bool machine_move();
  bool take_targets(std::uint8_t stated, ReadMotion& motion);
  bool target(std::size_t column, double& position);
  bool rotary_way(std::size_t column, const ReadMotion& motion);
  bool is_cutting() const { return modes_.motion != 0; }
  bool length_is_certain(std::uint8_t stated);
  bool arc(ReadMotion& motion);
  bool arc_centre(ArcBlock& arc_block);
  bool centre_part(char letter, double start_mm, double& part_mm);
  bool fill_feed(ReadMotion& motion);
  bool value_of(char letter, bool is_length, double& value);
  ReadMotion started_motion(ReadMotion::Kind kind) const;
  bool has_arc_words() const;

  // siemens_cycles.cpp
  bool call_cycle();
  bool read_cycle(const CycleCall& call, Drilling& drilling);
  bool levels(const CycleCall& call, Drilling& drilling);
  bool deep_hole(const CycleCall& call, Drilling& drilling);
  bool tapping(const CycleCall& call, Drilling& drilling);
  bool boring(const CycleCall& call, Drilling& drilling);
  bool nothing_behind(const CycleCall& call, std::size_t count);
  bool drill(const Drilling& drilling);
  bool move_and_drill();
  bool goes_across() const;

  AxisColumns columns_;
  ItemStream& items_;
  std::optional<int> edge_after_change_;
  Modes modes_;
  std::optional<Drilling> modal_cycle_;  ///< MCALL: drilled behind every block that moves
  bool ended_ = false;

  // the block in execution
  const Block* block_ = nullptr;
  OpenWords words_;
  std::uint32_t groups_ = 0;  ///< bits of the groups of G codes that the block states
  bool is_dwell_ = false, is_machine_frame_ = false;
};

}  // namespace pentapost::nc::readers::siemens
