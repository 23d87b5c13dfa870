#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/nc/words.hpp"
#include "pentapost/path/motion.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace pentapost::nc {

/// Bit of a column in Block::stated.
constexpr std::uint8_t bit(std::size_t column) { return static_cast<std::uint8_t>(1U << column); }

/// The axis words of a program: their spelling, and where the axes are after each block.
class AxisWords {
 public:
  AxisWords(const path::Motion& motion, int whole_digits, const NumberStyle& style)
      : columns_{motion, whole_digits},
        whole_digits_{whole_digits},
        style_{style},
        x_{columns_.find('X')},
        y_{columns_.find('Y')},
        z_{columns_.find('Z')} {}

  const WordColumns& columns() const noexcept { return columns_; }
  const NumberStyle& style() const noexcept { return style_; }
  std::size_t x() const noexcept { return x_; }  ///< column, WordColumns::none: no such word
  std::size_t y() const noexcept { return y_; }
  std::size_t z() const noexcept { return z_; }
  std::int64_t at(std::size_t column) const { return word_[column]; }

  /// Problem out_of_domain where a stated word has more digits than the control takes.
  /// A block that states no word is a std::logic_error.
  std::optional<Problem> misfit(const path::Block& block) const;

  /// Problem not_in_dialect where the arc `block` moves a column that `also` does not allow beside
  /// X and Y. An arc without a known start point or without feed is a std::logic_error.
  std::optional<Problem> arc_misfit(const path::Block& block, std::uint8_t also) const;

  /// Appends the words of `block` that are in the bits `words`.
  void append(std::string& out, const path::Block& block, std::uint8_t words) const {
    for (const std::size_t column : columns_) {
      if ((words & bit(column)) != 0)
        append_word(out, columns_.letter(column), block.word[column], columns_.decimals(column),
                    style_);
    }
  }
  /// The stated words of `block` that the control does not hold already; all of them where there
  /// would be none, for a block without an axis word is no motion block.
  std::uint8_t changed(const path::Block& block) const {
    const auto stated = static_cast<std::uint8_t>(block.stated & columns_.all());
    unsigned differs = ~unsigned{known_};
    for (std::size_t column = 0; column < columns_.count(); ++column) {
      if (block.word[column] != word_[column]) differs |= bit(column);
    }
    const auto words = static_cast<std::uint8_t>(stated & differs);
    return words == 0 ? stated : words;
  }
  bool moves(const path::Block& block, std::size_t column) const {
    return (block.stated & bit(column)) != 0 &&
           ((placed_ & bit(column)) == 0 || block.word[column] != word_[column]);
  }
  /// The axes are where `block` ends.
  void place(const path::Block& block) {
    for (std::size_t column = 0; column < columns_.count(); ++column) {
      if ((block.stated & bit(column)) != 0) word_[column] = block.word[column];
    }
    known_ |= static_cast<std::uint8_t>(block.stated & columns_.all());
    placed_ |= static_cast<std::uint8_t>(block.stated & columns_.all());
  }

  /// All words have to be stated again; the axes stay where they are.
  void restate_all() { known_ = 0; }
  /// Nothing says where this axis is.
  void lose(std::size_t column) {
    known_ &= static_cast<std::uint8_t>(~bit(column));
    placed_ &= static_cast<std::uint8_t>(~bit(column));
  }
  void lose_linear();
  void lose_all() { known_ = placed_ = 0; }

 private:
  WordColumns columns_;
  int whole_digits_;
  NumberStyle style_;
  std::size_t x_, y_, z_;
  std::array<std::int64_t, 5> word_{};  ///< last of each column
  std::uint8_t known_ = 0;              ///< bit i: the control holds word_[i]
  std::uint8_t placed_ = 0;             ///< bit i: the axis is at word_[i]
};

/// The F word of feeds per minute: written where it changes.
class FeedWord {
 public:
  explicit FeedWord(int decimals) : decimals_{decimals} {}

  /// False: the feed has more digits than a control takes, or is not above 0.
  bool append(std::string& out, double feed, const NumberStyle& style) {
    if (feed == feed_) return true;
    const auto count = feed_count(feed, decimals_);
    if (!count) return false;
    if (*count != count_) append_word(out, 'F', *count, decimals_, style);
    feed_ = feed;
    count_ = *count;
    return true;
  }
  void restate() {
    feed_ = 0.0;
    count_ = 0;
  }

 private:
  int decimals_;
  double feed_ = 0.0;  ///< as asked for; 0: to be stated
  std::int64_t count_ = 0;
};

}  // namespace pentapost::nc
