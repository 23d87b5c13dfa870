#pragma once

#include "pentapost/nc/readers/decimal.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace pentapost::nc::readers {

/// Bit of a word address in the masks below.
constexpr std::uint32_t letter_bit(char letter) { return 1U << (letter - 'A'); }

/// The words of one block: at most one of every address, besides G and M.
struct Words {
  static constexpr std::size_t most_codes = 16;

  std::uint32_t line = 0;     ///< 1-based line of the NC text
  std::uint32_t stated = 0;   ///< letters with a word; never G, M or N
  std::uint32_t pointed = 0;  ///< letters whose number has a decimal point
  std::uint32_t relative =
      0;  ///< letters read while G91 held (controls that take G91 word by word)
  std::array<double, 26> number{};            ///< as written; only where stated
  std::array<std::uint16_t, most_codes> g{};  ///< in tenths: 434 is G43.4
  std::array<std::uint16_t, most_codes> m{};
  std::size_t g_count = 0, m_count = 0;

  bool has(char letter) const { return (stated & letter_bit(letter)) != 0; }
  double operator[](char letter) const { return number[static_cast<std::size_t>(letter - 'A')]; }
  /// False: the block has a word with this address already.
  bool add(char letter, const Decimal& word) {
    if (has(letter)) return false;
    stated |= letter_bit(letter);
    if (word.has_point) pointed |= letter_bit(letter);
    number[static_cast<std::size_t>(letter - 'A')] = word.value();
    return true;
  }
  bool is_empty() const { return stated == 0 && g_count == 0 && m_count == 0; }

  void clear(std::uint32_t text_line) {
    line = text_line;
    stated = pointed = relative = 0;
    g_count = m_count = 0;
  }
};

}  // namespace pentapost::nc::readers
