#include "pentapost/nc/plain_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

namespace pentapost::nc {
namespace {

/// Plain spelling of U+00C0 to U+00FF.
constexpr std::array<std::string_view, 64> latin_letters{
    "A", "A", "A", "A", "Ae", "A", "AE", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",
    "D", "N", "O", "O", "O",  "O", "Oe", "x", "O", "U", "U", "U", "Ue", "Y", "Th", "ss",
    "a", "a", "a", "a", "ae", "a", "ae", "c", "e", "e", "e", "e", "i",  "i", "i",  "i",
    "d", "n", "o", "o", "o",  "o", "oe", "/", "o", "u", "u", "u", "ue", "y", "th", "y"};

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

}  // namespace

std::string printable_ascii(std::string_view utf8) {
  std::string text;
  text.reserve(utf8.size());
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte >= 0x20 && byte < 0x7F) {
      text += utf8[i];
    } else if (byte < 0x80) {
      text += ' ';
    } else if (byte == 0xC3 && i + 1 < utf8.size() && is_continuation(utf8[i + 1])) {
      text += latin_letters[static_cast<unsigned char>(utf8[++i]) & 0x3FU];
    } else {
      text += '?';
      while (i + 1 < utf8.size() && is_continuation(utf8[i + 1])) ++i;
    }
  }
  return text;
}

std::vector<std::string> comment_lines(std::string_view text, std::string_view forbidden,
                                       std::size_t width) {
  std::string plain = printable_ascii(text);
  std::erase_if(plain, [&](char c) { return forbidden.find(c) != std::string_view::npos; });
  std::vector<std::string> lines;
  std::string_view rest = plain;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    if (rest.empty()) return lines;
    std::size_t length = rest.size();
    if (length > width) {
      const std::size_t blank = rest.rfind(' ', width);
      length = blank == std::string_view::npos ? width : blank;
    }
    std::string_view line = rest.substr(0, length);
    line = line.substr(0, line.find_last_not_of(' ') + 1);
    lines.emplace_back(line);
    rest.remove_prefix(length);
  }
}

std::string clean_program_name(std::string_view name, std::size_t longest) {
  std::string clean;
  bool gap = false;
  for (const char c : upper_case(printable_ascii(name))) {
    if (!is_upper(c) && !is_digit(c) && c != '_' && c != '-') {
      gap = true;
      continue;
    }
    if (gap && !clean.empty()) clean += '_';
    gap = false;
    clean += c;
  }
  clean.resize(std::min(clean.size(), longest));
  return clean.empty() ? "PROGRAM" : clean;
}

std::string upper_case(std::string text) {
  for (char& c : text) {
    if (is_lower(c)) c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

std::string filled(std::string line, std::string_view placeholder, std::string_view replacement) {
  for (std::size_t at = line.find(placeholder); at != std::string::npos;
       at = line.find(placeholder, at + replacement.size()))
    line.replace(at, placeholder.size(), replacement);
  line.resize(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace pentapost::nc
