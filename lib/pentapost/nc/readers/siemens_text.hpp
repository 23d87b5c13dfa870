#pragma once

#include "pentapost/nc/readers/decimal.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/siemens_vocabulary.hpp"
#include "pentapost/nc/readers/words.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace pentapost::nc::readers::siemens {

/// A call of CYCLE81 to CYCLE86. A parameter left out is 0, as for the control.
struct CycleCall {
  static constexpr std::size_t most_parameters = 24;

  int number = 0;  ///< 81 to 86
  std::array<double, most_parameters> parameter{};
};

/// The words of one block. G codes are whole numbers here.
struct Block {
  Words words;
  // letters whose value stands in AC(), IC(), DC(), ACP(), ACN()
  std::uint32_t absolute = 0, incremental = 0, shortest = 0, upward = 0, downward = 0;
  std::optional<double> radius, turns;
  std::optional<CycleCall> cycle;
  bool orientation_on = false;
  bool orientation_off = false;
  bool machine_frame = false;
  bool modal_call = false;
  bool shift = false;       ///< axis words are a shift's
  bool bare_shift = false;  ///< there must be no axis words
  bool spindle_stop = false;
  bool program_end = false;
  bool has_statement = false;  ///< one of the above

  bool is_empty() const { return words.is_empty() && !has_statement; }
  void clear(std::uint32_t text_line);
};

/// Splits a program into blocks, one a line. Words are addresses with a number, or names; upper and
/// lower case are the same.
class Text {
 public:
  enum class Found : std::uint8_t { block, end_of_text, problem };

  Text(std::string_view text, ItemStream& items);

  /// The next block that has words; sets the stream's line to it.
  Found next(Block& block);
  /// After the program's end only comments and blank lines may follow.
  void set_ended() { ended_ = true; }

 private:
  enum class Step : std::uint8_t { go_on, line_ends, problem };

  // siemens_text.cpp
  Step one(Block& block);
  bool word(Block& block);
  bool address(Block& block, char letter);
  bool store(Block& block, char letter, const Decimal& number);
  bool store_code(Block& block, char letter, const Decimal& number);
  bool block_number(const Decimal& number);
  bool program_mark();
  void line_feed();
  void skip_blanks();
  bool fail(std::string_view what, const char* at, Code code = Code::not_in_dialect);

  // siemens_values.cpp
  bool indexed_address(Block& block, char letter, const Decimal& index);
  bool value(Block& block, char letter);
  bool dimension(Block& block, char letter, std::string_view name);
  bool tool_name(Block& block);
  bool number_of(Decimal& number);
  bool nothing_to_evaluate();

  // siemens_names.cpp
  bool name(Block& block);
  bool statement(Block& block, Meaning meaning, std::string_view name);
  bool cycle(Block& block, std::string_view name);
  bool high_speed_cycle();
  bool feed_group();
  bool orientation_on(Block& block);
  bool number_behind(std::optional<double>& number);
  bool zero_behind();
  bool skip_value();
  bool skip_call();
  bool no_call();
  bool label();
  std::string_view read_name();

  static constexpr std::size_t longest_name = 32;

  const char* at_;
  const char* line_begin_;
  const char* word_begin_;
  const char* end_;
  ItemStream& items_;
  std::array<char, longest_name> name_{};
  std::uint32_t line_ = 1;
  bool started_ = false;       ///< a block was read
  bool line_started_ = false;  ///< something was read on this line
  bool numbered_ = false;      ///< ... its number, that is
  bool ended_ = false;
};

}  // namespace pentapost::nc::readers::siemens
