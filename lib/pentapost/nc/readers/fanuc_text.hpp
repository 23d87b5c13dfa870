#pragma once

#include "pentapost/nc/readers/decimal.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/words.hpp"

#include <string_view>

namespace pentapost::nc::readers {

/// Splits Fanuc program text into blocks: tape marks, program number, comments, words.
class FanucText {
 public:
  enum class Found { block, end_of_text, problem };

  FanucText(std::string_view text, ItemStream& items);

  /// The next block that has words; sets the stream's line to it.
  Found next(Words& words);
  /// After the program's end only the tape mark, comments and blank blocks may follow.
  void set_ended() { ended_ = true; }

 private:
  enum class Step { go_on, block_ends, problem };

  Step one(Words& words);
  Step word(Words& words);
  Step comment();
  Step program_number();
  Step tape_mark();
  bool store(Words& words, char letter, const char* begin);
  bool store_code(Words& words, char letter, const Decimal& number, const char* begin);
  void line_feed();
  bool fail(std::string_view what, const char* at, Code code = Code::not_in_dialect);

  const char* at_;
  const char* line_begin_;
  const char* end_;
  ItemStream& items_;
  std::uint32_t line_ = 1;
  bool started_ = false;        ///< a block or the program number was read
  bool block_started_ = false;  ///< a word of this block was read
  bool marked_ = false;         ///< the leading tape mark was read
  bool tape_ended_ = false;     ///< the closing tape mark was read
  bool ended_ = false;
};

}  // namespace pentapost::nc::readers
