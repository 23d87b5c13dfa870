#pragma once

#include "pentapost/nc/readers/decimal.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/words.hpp"

#include <cstdint>
#include <optional>
#include <string_view>

namespace pentapost::nc::readers::klartext {

/// One block: either the words of a path function, or a statement with the text behind its keyword.
struct Block {
  enum class Kind : std::uint8_t {
    statement,
    line,              ///< L; a single axis; M functions alone
    polar_line,        ///< LP
    centre,            ///< CC
    circle,            ///< C
    circle_by_radius,  ///< CR
    polar_circle,      ///< CP
  };
  enum class Feed : std::uint8_t { unsaid, number, rapid, of_tool };
  enum class Turning : std::uint8_t { unsaid, clockwise, counterclockwise };

  Kind kind = Kind::line;
  Words words;  ///< of the axes, relative: with I; F where it is a number; R of CR
  Feed feed = Feed::unsaid;
  Turning turning = Turning::unsaid;       ///< DR
  std::optional<double> polar_radius;      ///< PR
  std::optional<double> polar_angle_deg;   ///< PA, IPA
  bool polar_angle_is_relative = false;    ///< IPA
  bool retracts_fully = false;             ///< M140 MB MAX
  bool calls_cycle = false;                ///< CYCL CALL
  std::uint32_t counted_below_a_turn = 0;  ///< letters behind M94; 0: all
  std::string_view keyword, rest;          ///< of a statement, with the lines that ~ joins to it
};

/// Splits conversational TNC program text into blocks.
class Text {
 public:
  enum class Found { block, end_of_text, problem };

  Text(std::string_view text, ItemStream& items);

  /// Reads "BEGIN PGM NAME MM". @return false: the stream has the Problem.
  bool read_program_line();
  bool is_inch() const { return is_inch_; }

  /// The next block; sets the stream's line to it.
  Found next(Block& block);

 private:
  enum class Step { go_on, block_found, problem };

  Step line(Block& block);
  bool block_number();
  std::string_view letters();
  Step keyword(Block& block);
  bool takes_call();
  bool statement(Block& block);
  Step words(Block& block, Block::Kind kind);
  bool word(Block& block);
  bool long_word(Block& block, std::string_view name, const char* begin);
  bool polar_word(Block& block, std::string_view name, const char* begin);
  bool feed_word(Block& block, const char* begin);
  bool compensation_or_radius(Block& block, const char* begin);
  bool turning_word(Block& block, const char* begin);
  bool function_word(Block& block, const char* begin);
  bool retract_words(Block& block, const char* begin);
  void letters_of_m94(Block& block);
  bool number_of(Decimal& number, const char* begin);
  bool axis_word(Block& block, char letter, bool is_relative, const char* begin);
  bool take(std::string_view what);
  void skip_blanks();
  void skip_line();
  bool at_line_end() const {
    if (at_ == end_ || *at_ == '\n') return true;
    return *at_ == '\r' && (at_ + 1 == end_ || at_[1] == '\n');
  }
  bool fail(std::string_view what, const char* at, Code code = Code::not_in_dialect);

  const char* at_;
  const char* line_begin_;
  const char* end_;
  ItemStream& items_;
  std::uint32_t line_ = 1;
  bool is_inch_ = false;
  bool feed_is_of_function_ = false;  ///< an F belongs to the M function before it
};

}  // namespace pentapost::nc::readers::klartext
