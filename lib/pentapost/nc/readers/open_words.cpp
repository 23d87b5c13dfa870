#include "pentapost/nc/readers/open_words.hpp"

#include "pentapost/core/number_text.hpp"

#include <string>

namespace pentapost::nc::readers {

/// Always false.
bool OpenWords::refuse_first(ItemStream& items) const {
  char letter = 'A';
  while (!any_left(letter_bit(letter))) ++letter;
  return items.fail(Code::not_in_dialect, std::string{letter} + number_text((*words_)[letter]) +
                                              " has no meaning that is understood in this block");
}

}  // namespace pentapost::nc::readers
