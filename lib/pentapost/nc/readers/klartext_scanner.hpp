#pragma once

#include "pentapost/nc/readers/decimal.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pentapost::nc::readers::klartext {

/// Reads the text behind the keyword of a statement, over all its lines; remarks are skipped.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : at_{text.data()}, end_{at_ + text.size()} {}

  bool at_end() {
    skip();
    return at_ == end_;
  }
  /// The next character, '\0' at the end.
  char ahead() { return at_end() ? '\0' : *at_; }
  const char* at() const { return at_; }

  /// Takes `what` where it stands next, as a part of a word too.
  bool take(std::string_view what) {
    skip();
    if (static_cast<std::size_t>(end_ - at_) < what.size() ||
        std::string_view{at_, what.size()} != what)
      return false;
    at_ += what.size();
    return true;
  }
  /// The letters, digits and signs up to the next blank.
  std::string_view word() {
    skip();
    const char* const begin = at_;
    while (at_ != end_ && !is_gap(*at_) && *at_ != ';') ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }
  bool number(Decimal& number) {
    skip();
    return read_decimal(at_, end_, number);
  }
  /// Digits alone: what stands behind them is left, a point too.
  bool integer(Decimal& number) {
    skip();
    number = {};
    const std::ptrdiff_t digits = read_digits(at_, end_, number.mantissa);
    number.digits = static_cast<int>(std::min<std::ptrdiff_t>(digits, Decimal::most_digits + 1));
    return digits > 0 && digits <= Decimal::most_digits;
  }
  void take_letter() { ++at_; }
  /// Whether "Q200=..." stands next.
  bool is_parameter_next() {
    const char* at = (skip(), at_);
    if (at == end_ || *at++ != 'Q') return false;
    std::uint64_t digits = 0;
    return read_digits(at, end_, digits) > 0 && at != end_ && (*at == '=' || *at == ' ');
  }

 private:
  static bool is_gap(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '~'; }
  void skip() {
    for (; at_ != end_; ++at_) {
      if (*at_ == ';')
        while (at_ + 1 != end_ && at_[1] != '\n') ++at_;
      else if (!is_gap(*at_))
        return;
    }
  }

  const char* at_;
  const char* end_;
};

}  // namespace pentapost::nc::readers::klartext
