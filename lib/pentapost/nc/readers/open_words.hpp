#pragma once

#include "pentapost/nc/readers/axis_columns.hpp"
#include "pentapost/nc/readers/item_stream.hpp"
#include "pentapost/nc/readers/words.hpp"

#include <cstddef>
#include <cstdint>

namespace pentapost::nc::readers {

/// The words of the block in execution, and which of them nothing has understood yet.
class OpenWords {
 public:
  void open(const Words& words) {
    words_ = &words;
    left_ = words.stated;
  }
  const Words* operator->() const { return words_; }
  /// The number of a word that the block has, as written.
  double operator[](char letter) const { return (*words_)[letter]; }
  bool is_pointed(char letter) const { return (words_->pointed & letter_bit(letter)) != 0; }

  /// Whether one of these letters is left.
  bool any_left(std::uint32_t letters) const { return (left_ & letters) != 0; }
  /// Marks a word as understood. @return false: the block has none.
  bool take(char letter) {
    const bool stated = any_left(letter_bit(letter));
    drop(letter_bit(letter));
    return stated;
  }
  /// Marks words as understood that mean nothing here.
  void drop(std::uint32_t letters) { left_ &= ~letters; }
  /// Takes the axis words. @return the bits of their columns.
  std::uint8_t take_columns(const AxisColumns& columns) {
    std::uint8_t taken = 0;
    if (!any_left(columns.letter_bits())) return taken;
    for (std::size_t column = 0; column < columns.size(); ++column)
      if (take(columns.letter(column))) taken = static_cast<std::uint8_t>(taken | 1U << column);
    return taken;
  }
  /// False where a word is left, which is a Problem not_in_dialect.
  bool nothing_left(ItemStream& items) const { return left_ == 0 || refuse_first(items); }

 private:
  bool refuse_first(ItemStream& items) const;

  const Words* words_ = nullptr;
  std::uint32_t left_ = 0;
};

}  // namespace pentapost::nc::readers
