#include "pentapost/cl/length_unit.hpp"

#include "pentapost/cl/statements.hpp"

namespace pentapost::cl {

std::optional<Units> stated_unit(const Words& words) {
  for (const Word& word : words) {
    for (const std::string_view name : {"MM", "MMS", "METRIC", "MILLIMETERS", "MILLIMETRES"})
      if (word.is(name)) return Units::mm;
    for (const std::string_view name : {"INCHES", "INCH", "IN", "ENGLISH"})
      if (word.is(name)) return Units::inch;
  }
  return std::nullopt;
}

std::optional<FeedUnit> feed_unit(const Word& word) {
  if (word.is("MMPM")) return FeedUnit{Units::mm, false};
  if (word.is("IPM")) return FeedUnit{Units::inch, false};
  if (word.is("MMPR")) return FeedUnit{Units::mm, true};
  if (word.is("IPR")) return FeedUnit{Units::inch, true};
  if (word.is("PERMIN")) return FeedUnit{std::nullopt, false};
  if (word.is("PERREV")) return FeedUnit{std::nullopt, true};
  return std::nullopt;
}

UnitStatements find_units(std::string_view text) {
  UnitStatements found;
  Statements statements{text};
  Statement statement;
  Words words;
  while (statements.next(statement)) {
    if (statement.kind != Statement::Kind::statement) continue;
    const char first = upper(statement.text.front());
    const bool may_be_feed = !found.by_feed && (first == 'F' || first == 'C');
    if (first != 'U' && !may_be_feed) continue;
    const Major major = read_major(statement.text);
    if (!major.slash) continue;
    if (major.word() == "UNITS" || major.word() == "UNIT") {
      words.read(major.rest);
      found.stated = stated_unit(words);
      found.stated_line = statement.line;
      if (found.stated) return found;
    } else if (major.word() == "FEDRAT" || major.word() == "CYCLE") {
      words.read(major.rest);
      for (const Word& word : words) {
        const auto unit = feed_unit(word);
        if (!unit || !unit->length) continue;
        found.by_feed = unit->length;
        found.feed_line = statement.line;
        break;
      }
    }
  }
  return found;
}

}  // namespace pentapost::cl
