#include "pentapost/cl/words.hpp"

#include "pentapost/core/number_text.hpp"

#include <algorithm>

namespace pentapost::cl {
namespace {

constexpr std::array<double, 23> power_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                              1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                              1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t exact_integers = std::uint64_t{1} << 53;

bool starts_exponent(const char* at, const char* end) {
  if (at == end) return false;
  const char letter = upper(*at);
  if (letter != 'E' && letter != 'D') return false;
  const char* digit = at + 1;
  if (digit != end && (*digit == '+' || *digit == '-')) ++digit;
  return digit != end && is_digit(*digit);
}

/// Numbers with an exponent or with more digits than a double holds exactly, and what is none.
Decimal read_any_decimal(const char* begin, const char* end, int decimals) {
  Decimal found;
  found.next = begin;
  const char* at = begin;
  if (at != end && (*at == '+' || *at == '-')) ++at;
  const std::string_view word{at, static_cast<std::size_t>(std::min<std::ptrdiff_t>(3, end - at))};
  if (same_word(word, "NAN") || same_word(word, "INF")) {
    found.state = Decimal::State::not_finite;
    return found;
  }
  if (at == end || !(is_digit(*at) || (*at == '.' && at + 1 != end && is_digit(at[1]))))
    return found;
  const auto parsed = parse_number({begin, static_cast<std::size_t>(end - begin)});
  if (!parsed) {
    found.state = Decimal::State::not_finite;
    return found;
  }
  found.state = Decimal::State::number;
  found.value = parsed->value + 0.0;
  found.next = begin + parsed->length;
  found.decimals = decimals;
  for (const char* letter = begin; letter != found.next; ++letter) {
    if (!is_letter(*letter)) continue;
    const auto exponent =
        parse_number({letter + 1, static_cast<std::size_t>(found.next - letter - 1)});
    if (exponent) found.decimals -= static_cast<int>(std::clamp(exponent->value, -300.0, 300.0));
    break;
  }
  found.decimals = std::max(found.decimals, 0);
  return found;
}

bool is_gear(const Word& word) {
  return word.is_number() || word.is("LOW") || word.is("MEDIUM") || word.is("HIGH");
}

/// How many words a minor word takes; nullopt: what it needs is not there.
/// @param behind  the word behind it; nullptr: none.
std::optional<std::size_t> taken_words(Takes takes, const Word* behind) {
  const auto one_if = [](bool there) {
    return there ? std::optional<std::size_t>{1} : std::nullopt;
  };
  switch (takes) {
    case Takes::nothing:
      return 0;
    case Takes::number:
      return one_if(behind != nullptr && behind->is_number());
    case Takes::number_if_there:
      return behind != nullptr && behind->is_number() ? 1 : 0;
    case Takes::number_or_gear:
      return one_if(behind != nullptr && is_gear(*behind));
    case Takes::on_or_off:
      return one_if(behind != nullptr && (behind->is("ON") || behind->is("OFF")));
  }
  return std::nullopt;
}

bool is_separator(char c) {
  return is_blank(c) || c == ',' || c == '(' || c == ')' || c == '/' || c == '=';
}

}  // namespace

bool same_word(std::string_view text, std::string_view word) {
  return text.size() == word.size() &&
         std::equal(text.begin(), text.end(), word.begin(),
                    [](char c, char expected) { return upper(c) == expected; });
}

Decimal read_decimal(const char* begin, const char* end) {
  const char* at = begin;
  const bool negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  std::uint64_t digits = 0;
  const char* const first = at;
  while (at != end && is_digit(*at)) digits = 10 * digits + static_cast<std::uint64_t>(*at++ - '0');
  std::ptrdiff_t count = at - first;
  int decimals = 0;
  if (at != end && *at == '.') {
    const char* const point = at++;
    while (at != end && is_digit(*at))
      digits = 10 * digits + static_cast<std::uint64_t>(*at++ - '0');
    const std::ptrdiff_t behind = at - point - 1;
    decimals = static_cast<int>(std::min<std::ptrdiff_t>(behind, 300));
    count += behind;
  }
  // Two exact doubles: their quotient is the correctly rounded value.
  if (count < 1 || count > 19 || digits > exact_integers || starts_exponent(at, end))
    return read_any_decimal(begin, end, decimals);
  const double magnitude =
      static_cast<double>(digits) / power_of_ten[static_cast<std::size_t>(decimals)];
  Decimal found;
  found.value = negative && digits != 0 ? -magnitude : magnitude;
  found.decimals = decimals;
  found.state = Decimal::State::number;
  found.next = at;
  return found;
}

Coordinates read_coordinates(std::string_view text) {
  Coordinates found;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at != end && is_blank(*at)) ++at;
  while (at != end) {
    const Decimal number = read_decimal(at, end);
    if (number.state != Decimal::State::number) {
      found.fault = number.state == Decimal::State::not_finite ? Coordinates::Fault::not_finite
                                                               : Coordinates::Fault::not_a_number;
      return found;
    }
    if (found.count < 6) {
      found.value[found.count] = number.value;
      int& decimals = found.count < 3 ? found.tip_decimals : found.axis_decimals;
      decimals = std::max(decimals, number.decimals);
    }
    at = number.next;
    if (at != end && *at != ',' && !is_blank(*at)) {
      found.fault = Coordinates::Fault::not_a_number;
      return found;
    }
    ++found.count;
    while (at != end && is_blank(*at)) ++at;
    if (at != end && *at == ',') ++at;
    while (at != end && is_blank(*at)) ++at;
  }
  return found;
}

void Words::read_number_or_word(std::string_view token) {
  const char* const end = token.data() + token.size();
  Word word{Word::Kind::word, token, 0.0};
  // The only minor word that starts with a digit.
  const bool is_word = is_letter(token.front()) || same_word(token, "1STPECK");
  if (!is_word) {
    const Decimal number = read_decimal(token.data(), end);
    const std::string_view behind{number.next, static_cast<std::size_t>(end - number.next)};
    if (number.state != Decimal::State::number || !(behind.empty() || is_letter(behind.front()))) {
      word.kind = Word::Kind::damaged;
      damaged_ = true;
    } else {
      word.kind = Word::Kind::number;
      word.number = number.value;
      word.text = token.substr(0, token.size() - behind.size());
      if (!behind.empty()) {
        words_.push_back(word);
        word = {Word::Kind::word, behind, 0.0};
      }
    }
  }
  words_.push_back(word);
}

void Words::read(std::string_view text) {
  words_.clear();
  damaged_ = false;
  std::size_t at = 0;
  while (at < text.size()) {
    if (is_separator(text[at])) {
      ++at;
      continue;
    }
    if (words_.size() >= max_words) {
      damaged_ = true;
      return;
    }
    std::size_t end = at;
    if (text[at] == '\'' || text[at] == '"') {
      end = std::min(text.find(text[at], at + 1), text.size());
      words_.push_back({Word::Kind::quoted, text.substr(at + 1, end - at - 1), 0.0});
      at = end + 1;
      continue;
    }
    while (end < text.size() && !is_separator(text[end])) ++end;
    read_number_or_word(text.substr(at, end - at));
    at = end;
  }
}

bool Words::has(std::string_view word) const {
  return std::any_of(words_.begin(), words_.end(), [&](const Word& w) { return w.is(word); });
}

std::optional<double> Words::number_after(std::string_view word) const {
  for (std::size_t i = 0; i + 1 < words_.size(); ++i)
    if (words_[i].is(word) && words_[i + 1].is_number()) return words_[i + 1].number;
  return std::nullopt;
}

std::vector<double> Words::numbers() const {
  std::vector<double> found;
  for (const Word& word : words_)
    if (word.is_number()) found.push_back(word.number);
  return found;
}

FormMatch match_form(const Words& words, std::span<const MinorWord> known) {
  FormMatch match;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Word& word = words[i];
    if (word.is_number()) {
      if (match.number) return {{}, {}, "a second number, " + quoted_excerpt(word.text)};
      match.number = word.number;
      match.text = word.text;
      continue;
    }
    const auto minor = std::find_if(known.begin(), known.end(),
                                    [&](const MinorWord& m) { return word.is(m.word); });
    if (minor == known.end()) return {{}, {}, quoted_excerpt(word.text)};
    const auto taken = taken_words(minor->takes, i + 1 < words.size() ? &words[i + 1] : nullptr);
    if (!taken) return {{}, {}, quoted_excerpt(word.text) + " without its value"};
    i += *taken;
  }
  if (words.has_damage()) return {{}, {}, "too many words"};
  return match;
}

Major read_major(std::string_view text) {
  Major major;
  std::size_t at = 0;
  const auto skip_blanks = [&] {
    while (at < text.size() && is_blank(text[at])) ++at;
  };
  const auto belongs = [](char c) { return is_letter(c) || is_digit(c) || c == '-' || c == '_'; };
  if (text.empty() || !is_letter(text.front())) return major;
  for (; at < text.size() && belongs(text[at]); ++at) {
    if (major.size == major.letters.size()) return {};
    major.letters[major.size++] = upper(text[at]);
  }
  skip_blanks();
  if (major.word() == "TOOL" && text.size() >= at + 4 && same_word(text.substr(at, 4), "PATH")) {
    constexpr std::string_view path = " PATH";
    std::copy(path.begin(), path.end(), major.letters.begin() + 4);
    major.size += path.size();
    at += 4;
    skip_blanks();
  }
  major.slash = at < text.size() && text[at] == '/';
  if (major.slash) ++at;
  skip_blanks();
  major.rest = text.substr(at);
  return major;
}

std::string quoted_excerpt(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string excerpt = "\"";
  for (const char c : text.substr(0, longest))
    excerpt += c >= ' ' && c < 0x7F ? c : (is_blank(c) ? ' ' : '?');
  excerpt += text.size() > longest ? "...\"" : "\"";
  return excerpt;
}

}  // namespace pentapost::cl
