#pragma once

#include "pentapost/nc/readers/arc.hpp"
#include "pentapost/nc/readers/axis_columns.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/klartext_cycle.hpp"
#include "pentapost/nc/readers/klartext_scanner.hpp"
#include "pentapost/nc/readers/klartext_text.hpp"
#include "pentapost/nc/readers/open_words.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pentapost::nc::readers::klartext {

/// The modal state of a TNC. nullopt: the program has not set it.
struct Modes {
  std::optional<double> feed;       ///< mm/min or deg/min; mm/rev with M136
  std::optional<double> tool_feed;  ///< of TOOL CALL, for FAUTO
  std::optional<PlanePoint> pole;   ///< mm, absolute
  std::optional<Cycle> cycle;
  bool feed_per_revolution = false;  ///< M136
  bool tcp = false;                  ///< M128, FUNCTION TCPM
  bool shortest_way = false;         ///< M126
  bool rotary_feed_in_mm = false;    ///< M116
  bool tool_axis_is_z = false;
  bool spindle_was_coupled = false;             ///< a tap was cut: the spindle stands behind it
  std::optional<AxisColumns> before_tcp_ended;  ///< nothing has moved since TCP was on
  int tool = 0;                                 ///< 0: none, then no length is compensated
  int preset = 0;                               ///< of cycle 247
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
  bool has_ended() const { return ended_; }   ///< M30 or END PGM was read
  bool is_closed() const { return closed_; }  ///< END PGM was read

 private:
  // klartext_program.cpp
  bool words();
  bool at_block_start();
  bool start_function(int code);
  bool tcp_on();
  void tcp_off();
  bool stop_spindle();
  bool at_block_end();
  bool end_function(int code);
  void forget_turns();
  bool set_feed();
  bool retract();

  // klartext_motion.cpp
  bool set_pole();
  bool move();
  ReadMotion started_motion(std::uint8_t stated) const;
  bool machine_move(std::uint8_t stated, ReadMotion& motion);
  bool targets(std::uint8_t stated, ReadMotion& motion);
  bool polar_target(ReadMotion& motion);
  bool turns_are_certain(const ReadMotion& motion);
  bool arc(ReadMotion& motion);
  bool circle(ReadMotion& motion);
  bool circle_by_radius(ReadMotion& motion);
  bool polar_circle(ReadMotion& motion);
  bool fill_feed(ReadMotion& motion);
  bool value_of(char letter, bool is_length, double& value);
  bool in_range(double value, std::string_view name);
  bool send_motion(const ReadMotion& motion);
  bool call_cycle(std::uint8_t stated, ReadMotion motion);

  // klartext_statements.cpp
  bool statement();
  bool end_program();
  bool tool();
  bool call_tool(Scanner& scanner);
  bool tool_word(Scanner& scanner, std::optional<int>& number);
  bool tool_number(Scanner& scanner, std::optional<int>& number);
  bool function();
  bool function_tcpm(Scanner& scanner);
  bool plane();
  bool not_understood(std::string_view what);

  // klartext_definitions.cpp
  bool cycle_definition();
  bool short_definition(int number, int part, Scanner& scanner);
  bool long_definition(int number, Scanner& scanner);
  bool shift_datum(Scanner& scanner);
  bool last_number_is(Scanner& scanner, double wanted, std::string_view what);
  bool tilt_is_zero(Scanner& scanner);

  bool is_relative(char letter) const { return (words_->relative & letter_bit(letter)) != 0; }

  AxisColumns columns_;
  ItemStream& items_;
  bool is_inch_;
  Modes modes_;
  bool ended_ = false;
  bool closed_ = false;

  // the block in execution
  const Block* block_ = nullptr;
  OpenWords words_;
  int machine_datum_ = 0;     ///< 91 or 92 in a block with M91 or M92
  bool calls_cycle_ = false;  ///< M99, CYCL CALL
};

}  // namespace pentapost::nc::readers::klartext
