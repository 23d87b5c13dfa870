#include "pentapost/nc/lint_rules/lint_text.hpp"

#include <algorithm>

namespace pentapost::nc::lint_rules {
namespace {

bool is_letter(char character) {
  return (character >= 'A' && character <= 'Z') || character == '_';
}

bool is_of_number(char character) {
  return (character >= '0' && character <= '9') || character == '.' || character == '+' ||
         character == '-';
}

/// End of what begins at `at` with an open bracket; the end of the line where it stays open.
std::size_t end_of_brackets(std::string_view line, std::size_t at) {
  int depth = 0;
  for (; at < line.size(); ++at) {
    if (line[at] == '(') ++depth;
    if (line[at] == ')' && --depth == 0) return at + 1;
  }
  return line.size();
}

}  // namespace

const LintWord* LintBlock::find(std::string_view name) const {
  if (name.size() == 1 && name[0] != '_' && !has(name[0])) return nullptr;
  const auto all = words();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const LintWord& each) { return each.letters == name; });
  return found == all.end() ? nullptr : &*found;
}

bool LintBlock::has(std::string_view name, std::string_view number) const {
  const auto all = words();
  return std::any_of(all.begin(), all.end(),
                     [&](const LintWord& each) { return each.is(name, number); });
}

bool LintText::next(LintBlock& block) {
  if (at_ >= text_.size()) return false;
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  block.text = text_.substr(at_, end - at_);
  if (block.text.ends_with('\r')) block.text.remove_suffix(1);
  at_ = end + 1;
  block.line = ++line_;
  block.count = 0;
  block.single = 0;
  return true;
}

void LintText::split(LintBlock& block) const {
  const std::string_view line = block.text;
  for (std::size_t at = 0; at < line.size() && block.count < LintBlock::most_words;) {
    const char character = line[at];
    if (character == ';' && syntax_.semicolon_comments) return;
    if (character == '"') {  // a string of the control
      at = std::min(line.find('"', at + 1), line.size() - 1) + 1;
      continue;
    }
    if (character == '(') {
      at = end_of_brackets(line, at);
      continue;
    }
    if (!is_letter(character)) {
      ++at;
      continue;
    }
    LintWord& word = block.word[block.count++];
    std::size_t end = at;
    while (end < line.size() && is_letter(line[end])) ++end;
    word = {.letters = line.substr(at, end - at), .number = {}};
    at = end;
    while (end < line.size() && is_of_number(line[end])) ++end;
    word.number = line.substr(at, end - at);
    at = end;
    if (syntax_.calls && at < line.size() && line[at] == '=') {
      end = at + 1;
      while (end < line.size() && line[end] != ' ' && line[end] != '(') ++end;
      if (end < line.size() && line[end] == '(') end = end_of_brackets(line, end);
      word.assigned = line.substr(at + 1, end - at - 1);
      at = end;
    } else if (syntax_.calls && at < line.size() && line[at] == '(') {
      end = end_of_brackets(line, at);
      word.arguments = line.substr(at + 1, end - at - (line[end - 1] == ')' ? 2 : 1));
      at = end;
    }
    // "A3=..." is another word than "A..."; "X=..." is X.
    const bool is_numbered = !word.assigned.empty() && !word.number.empty();
    if (word.letters.size() == 1 && word.letters[0] != '_' && !is_numbered)
      block.single |= 1U << (word.letters[0] - 'A');
  }
}

}  // namespace pentapost::nc::lint_rules
