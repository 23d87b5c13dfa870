#pragma once

#include "pentapost/nc/readers/decimal.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/words.hpp"

#include <optional>
#include <string_view>

namespace pentapost::nc::readers::heidenhain {

/// The words of one block, and what the TNC reads with more than an address and a number.
struct Block {
  Words words;
  std::optional<int> distance;  ///< 90 or 91, as it holds at the end of the block
  bool retracts_fully = false;  ///< M140 MB MAX
};

/// Splits TNC DIN/ISO program text into blocks. G90 and G91 act on the words behind them, in the
/// same block too (manual: "G02 G91 X+5 G90 Y-5").
class Text {
 public:
  enum class Found { block, end_of_text, problem };

  Text(std::string_view text, ItemStream& items);

  /// Reads the program line "%NAME G71 *". @return false: the stream has the Problem.
  bool read_program_line();
  bool is_inch() const { return is_inch_; }

  /// The next block that has words; sets the stream's line to it.
  Found next(Block& block);
  /// M30 was executed: only remarks and the closing line may follow.
  void set_ended() { ended_ = true; }
  /// The closing line "N99999999 %NAME G71 *" was read.
  bool is_closed() const { return closed_; }

 private:
  enum class Step { go_on, block_ends, problem };

  void start_block(Block& block);
  Step one(Block& block);
  Step word(Block& block);
  bool number_of(Decimal& number, const char* begin);
  bool store(Block& block, char letter, const Decimal& number, const char* begin);
  bool store_code(Block& block, char letter, const Decimal& number, const char* begin);
  bool tolerance_words();
  bool retract_words(Block& block);
  Step block_end();
  Step program_mark();
  Step to_line_end();
  bool unit_of_line();
  void skip_blanks();
  bool at_line_end() const { return at_ == end_ || *at_ == '\n'; }
  bool fail(std::string_view what, const char* at, Code code = Code::not_in_dialect);

  const char* at_;
  const char* line_begin_;
  const char* end_;
  ItemStream& items_;
  std::uint32_t line_ = 1;
  std::optional<int> distance_;
  std::string_view name_;
  bool is_inch_ = false;
  bool line_started_ = false;  ///< something other than a block number was read on this line
  bool has_words_ = false;     ///< ... words, that is
  bool after_m128_ = false;    ///< an F belongs to the compensating movements
  bool ended_ = false;
  bool closed_ = false;
};

}  // namespace pentapost::nc::readers::heidenhain
