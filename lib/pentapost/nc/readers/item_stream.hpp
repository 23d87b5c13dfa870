#pragma once

#include "pentapost/nc/reader.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace pentapost::nc::readers {

/// The text around `at`, fit for a message: printable ASCII of its line, at most 40 characters to
/// each side.
inline std::string quoted(const char* line_begin, const char* at, const char* end) {
  constexpr std::ptrdiff_t most_characters = 40;
  const char* first = at - line_begin > most_characters ? at - most_characters : line_begin;
  std::string out = first == line_begin ? "'" : "'...";
  for (; first != end && first - at < most_characters && *first != '\n' && *first != '\r'; ++first)
    out += *first >= ' ' && *first <= '~' ? *first : '?';
  const bool is_cut = first != end && *first != '\n' && *first != '\r';
  return out + (is_cut ? "...'" : "'");
}

/// Hands items on, and keeps the Problem that ended the reading. Its functions give false on a
/// Problem, so that a block costs no Status.
class ItemStream {
 public:
  explicit ItemStream(const ItemSink& sink) : sink_{sink} {}

  /// Items and Problems from here on belong to this line of the text.
  void set_line(std::uint32_t text_line) { item_.text_line = text_line; }
  std::uint32_t line() const { return item_.text_line; }

  template <class What>
  bool send(const What& what) {
    item_.what = what;
    Status taken = sink_(item_);
    if (taken.has_value()) return true;
    problem_ = std::move(taken).error();
    return false;
  }

  /// Always false.
  bool fail(Code code, std::string_view what) {
    problem_.code = code;
    problem_.message = "NC text line " + std::to_string(item_.text_line) + ": ";
    problem_.message += what;
    return false;
  }

  /// fail() with the text around `at`, of the line that begins at `line_begin`.
  bool fail_at(Code code, std::string_view what, const char* line_begin, const char* at,
               const char* end) {
    if (line_begin == end) return fail(code, what);
    return fail(code, std::string{what} + ", in " + quoted(line_begin, at, end));
  }

  Problem take_problem() { return std::move(problem_); }

 private:
  const ItemSink& sink_;
  ReadItem item_;
  Problem problem_{.code = Code::not_in_dialect, .message = {}};
};

}  // namespace pentapost::nc::readers
