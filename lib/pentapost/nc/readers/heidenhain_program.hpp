#pragma once

#include "pentapost/nc/readers/arc.hpp"
#include "pentapost/nc/readers/axis_columns.hpp"
#include "pentapost/nc/readers/heidenhain_text.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/open_words.hpp"

#include <array>
#include <optional>

namespace pentapost::nc::readers::heidenhain {

/// The modal state of a TNC. nullopt: the program has not set it.
struct Modes {
  std::optional<int> motion;                   ///< G00 to G03
  std::optional<int> plane;                    ///< 17 to 19
  std::optional<double> feed;                  ///< mm/min or deg/min
  std::optional<double> pole_x_mm, pole_y_mm;  ///< absolute
  bool tcp = false;                            ///< M128
  bool shortest_way = false;                   ///< M126
  bool rotary_feed_in_mm = false;              ///< M116
  int tool = 0;                                ///< 0: none, then no length is compensated
  ReadSpindle spindle = {};
  std::array<double, 5> datum_shift{};  ///< order of the columns
};

/// Executes blocks in the order of the control and hands on what they do.
class Program {
 public:
  Program(AxisColumns columns, bool is_inch, ItemStream& items)
      : columns_{columns}, items_{items}, is_inch_{is_inch} {}

  /// @return false: the stream has the Problem.
  bool execute(const Block& block);
  bool has_ended() const { return ended_; }

 private:
  // heidenhain_program.cpp
  bool sort_codes();
  bool sort_code(int code);
  bool preparatory_block();
  bool at_block_start();
  bool start_function(int code);
  bool at_block_end();
  bool end_function(int code);
  bool call_tool();
  bool shift_datum();
  bool set_feed();
  bool retract();

  // heidenhain_motion.cpp
  bool set_pole();
  bool move();
  bool machine_move(std::uint8_t stated, ReadMotion& motion);
  bool targets(std::uint8_t stated, ReadMotion& motion);
  bool turns_are_certain(const ReadMotion& motion);
  bool arc(ReadMotion& motion);
  bool arc_centre(ArcBlock& arc_block);
  bool fill_feed(ReadMotion& motion);
  bool value_of(char letter, bool is_length, double& value);

  bool is_relative(char letter) const { return (words_->relative & letter_bit(letter)) != 0; }

  AxisColumns columns_;
  ItemStream& items_;
  bool is_inch_;
  Modes modes_;
  bool ended_ = false;

  // the block in execution
  const Block* block_ = nullptr;
  OpenWords words_;
  int preparation_ = -1;    ///< G code that gives the words another meaning than a motion; -1: none
  bool new_speed_ = false;  ///< S in this block
  int machine_datum_ = 0;   ///< 91 or 92 in a block with M91 or M92
};

}  // namespace pentapost::nc::readers::heidenhain
