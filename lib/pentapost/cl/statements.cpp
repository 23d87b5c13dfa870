#include "pentapost/cl/statements.hpp"

#include "pentapost/cl/words.hpp"

#include <algorithm>
#include <array>

namespace pentapost::cl {
namespace {

constexpr std::array<std::string_view, 7> free_text_words{"PARTNO", "PPRINT", "INSERT", "REMARK",
                                                          "TPRINT", "LETTER", "DISPLY"};

bool is_free_text(std::string_view line) {
  return std::any_of(free_text_words.begin(), free_text_words.end(), [&](std::string_view word) {
    return line.size() >= word.size() && same_word(line.substr(0, word.size()), word);
  });
}

/// What of a physical line counts, and whether the statement goes on.
struct Content {
  std::string_view text;
  bool continues = false;
};

Content content_of(std::string_view line) {
  const std::size_t first_mark = line.find('$');
  if (first_mark == std::string_view::npos) return {line, false};
  const std::string_view before = line.substr(0, first_mark);
  if (before.find('\'') == std::string_view::npos && before.find('"') == std::string_view::npos)
    return {before, line.substr(first_mark, 2) != "$$"};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '\'' || c == '"') {
      // A quote that is not closed on its line is an apostrophe.
      const std::size_t closing = line.find(c, i + 1);
      if (closing == std::string_view::npos) {
        const std::size_t mark = line.find('$', i);
        if (mark == std::string_view::npos) return {line, false};
        i = mark - 1;
        continue;
      }
      i = closing;
    } else if (c == '$') {
      const bool comment = i + 1 < line.size() && line[i + 1] == '$';
      return {line.substr(0, i), !comment};
    }
  }
  return {line, false};
}

Content free_text_content(std::string_view line) {
  return {line.substr(0, std::min(line.find("$$"), line.size())), false};
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

Statements::Statements(std::string_view text) : text_{text} {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
  next_feed_ = std::min(text_.find('\n', at_), text_.size());
  next_return_ = std::min(text_.find('\r', at_), text_.size());
}

bool Statements::next_line(std::string_view& line) {
  if (at_ >= text_.size()) return false;
  const std::size_t end = std::min(next_feed_, next_return_);
  line = text_.substr(at_, end - at_);
  at_ = end + 1;
  if (end == next_return_ && end + 1 == next_feed_) ++at_;
  if (next_feed_ < at_) next_feed_ = std::min(text_.find('\n', at_), text_.size());
  if (next_return_ < at_) next_return_ = std::min(text_.find('\r', at_), text_.size());
  ++line_;
  return true;
}

void Statements::continue_statement(std::string_view start, Statement& statement) {
  joined_.assign(start);
  std::string_view line;
  bool continues = true;
  while (continues && next_line(line)) {
    const Content content = content_of(line);
    joined_.append(content.text);
    continues = content.continues;
  }
  statement.text = trimmed(joined_);
}

bool Statements::next(Statement& statement) {
  std::string_view line;
  while (next_line(line)) {
    line = trimmed(line);
    if (line.empty()) continue;
    statement.line = line_;
    statement.kind = Statement::Kind::statement;
    if (line.find('$') == std::string_view::npos) {
      statement.text = line;
      return true;
    }
    if (line.starts_with("$$->")) {
      statement.kind = Statement::Kind::data_comment;
      line.remove_prefix(4);
    } else if (line.starts_with("$$")) {
      statement.kind = Statement::Kind::comment;
      statement.text = trimmed(line.substr(2));
      return true;
    }
    const Content content = is_free_text(line) ? free_text_content(line) : content_of(line);
    if (content.continues)
      continue_statement(content.text, statement);
    else
      statement.text = trimmed(content.text);
    if (!statement.text.empty()) return true;
  }
  return false;
}

}  // namespace pentapost::cl
