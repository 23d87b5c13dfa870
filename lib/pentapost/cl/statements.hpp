#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace pentapost::cl {

/// One logical line of CL data.
struct Statement {
  enum class Kind : std::uint8_t {
    statement,
    comment,       ///< "$$ ..."; text is what follows the $$
    data_comment,  ///< Creo's "$$-> ..."; text is what follows the arrow
  };
  std::string_view text;   ///< without blanks at its ends, without comment and continuation marks
  std::uint32_t line = 0;  ///< 1-based line on which it starts
  Kind kind = Kind::statement;
};

/// Divides CL text into logical lines.
///
/// Lines end with LF, CR or CRLF. "$" continues a statement on the next line, joined without a
/// blank; "$$" starts a comment. Neither means anything within quotes. Free text (PARTNO, PPRINT,
/// INSERT and the like) is never continued. Linear in the length of the text.
class Statements {
 public:
  explicit Statements(std::string_view text);

  /// Gives the next logical line that is not empty; false at the end of the text.
  /// statement.text is valid until the next call.
  bool next(Statement& statement);

  /// Physical lines read so far.
  std::uint32_t lines() const noexcept { return line_; }

 private:
  bool next_line(std::string_view& line);
  void continue_statement(std::string_view start, Statement& statement);

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t next_feed_ = 0;    ///< where the next LF is, or the end of the text
  std::size_t next_return_ = 0;  ///< where the next CR is, or the end of the text
  std::uint32_t line_ = 0;
  std::string joined_;
};

/// `text` without blanks (any control character counts as one) at its ends.
std::string_view trimmed(std::string_view text);

}  // namespace pentapost::cl
