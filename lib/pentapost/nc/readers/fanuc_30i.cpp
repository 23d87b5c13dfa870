#include "pentapost/nc/readers/fanuc_30i.hpp"

#include "pentapost/nc/readers/fanuc_program.hpp"
#include "pentapost/nc/readers/fanuc_text.hpp"

namespace pentapost::nc::readers {

Status read_fanuc_30i(std::string_view text, const ReaderSetup& setup, const ItemSink& sink) {
  auto columns = AxisColumns::make(setup.letters);
  if (!columns) return std::move(columns).error();
  ItemStream items{sink};
  FanucText blocks{text, items};
  fanuc::Program program{*columns, items};
  Words words;
  for (;;) {
    switch (blocks.next(words)) {
      case FanucText::Found::problem:
        return items.take_problem();
      case FanucText::Found::end_of_text:
        if (program.has_ended()) return ok();
        items.fail(Code::not_in_dialect, "the program has no M30 or M02: the text is cut off");
        return items.take_problem();
      case FanucText::Found::block:
        if (!program.execute(words)) return items.take_problem();
        if (program.has_ended()) blocks.set_ended();
    }
  }
}

}  // namespace pentapost::nc::readers
