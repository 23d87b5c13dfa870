#pragma once

#include "pentapost/core/number_text.hpp"
#include "pentapost/nc/common_options.hpp"
#include "pentapost/nc/words.hpp"
#include "pentapost/path/motion.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pentapost::nc {

/// Room for the text of `motion`, a little more than most programs need.
/// @param around_block  characters of a block that are not axis words.
inline void reserve_text(std::string& out, const path::Motion& motion, std::size_t around_block) {
  constexpr std::size_t longest_usual_word = 10;
  constexpr std::size_t around_blocks = 2000;
  out.reserve(out.size() + around_blocks +
              motion.blocks.size() * (motion.letters.size() * longest_usual_word + around_block));
}

/// Appends the blocks of an NC program with their numbers and block ends.
class ProgramText {
 public:
  /// @param largest_number  block numbers start again after it.
  /// @param block_end  "*" on controls that want one, otherwise empty.
  ProgramText(std::string& out, const BlockNumbers& numbers, std::int64_t largest_number,
              std::string_view block_end)
      : out_{out},
        numbers_{numbers},
        largest_number_{largest_number},
        block_end_{block_end},
        number_{numbers.start} {}

  /// Starts a block: its words are appended to what this returns, each with a blank behind it.
  std::string& begin_block() {
    if (numbers_.on) {
      if (numbers_.letter)
        append_whole_word(out_, 'N', number_);
      else
        append_bare_number();
      number_ += numbers_.step;
      if (number_ > largest_number_) number_ = numbers_.start;
    }
    return out_;
  }
  void end_block() {
    if (block_end_.empty()) {
      out_.back() = '\n';
    } else {
      out_ += block_end_;
      out_ += '\n';
    }
  }
  /// A whole block.
  void block(std::string_view words) {
    begin_block().append(words).push_back(' ');
    end_block();
  }
  void blocks(std::span<const std::string> all) {
    for (const std::string& words : all) block(words);
  }
  /// A line without number and block end.
  void line(std::string_view text) { out_.append(text).push_back('\n'); }

 private:
  void append_bare_number() {
    std::array<char, decimal_room + 1> text;
    const std::size_t end = write_decimal(text.data(), number_, 0, {});
    text[end] = ' ';
    out_.append(text.data(), end + 1);
  }

  std::string& out_;
  BlockNumbers numbers_;
  std::int64_t largest_number_;
  std::string_view block_end_;
  std::int64_t number_;
};

}  // namespace pentapost::nc
