#include "pentapost/nc/readers/heidenhain_iso.hpp"

#include "pentapost/nc/readers/heidenhain_program.hpp"
#include "pentapost/nc/readers/heidenhain_text.hpp"

namespace pentapost::nc::readers {

Status read_heidenhain_iso(std::string_view text, const ReaderSetup& setup, const ItemSink& sink) {
  auto columns = AxisColumns::make(setup.letters);
  if (!columns) return std::move(columns).error();
  ItemStream items{sink};
  heidenhain::Text blocks{text, items};
  if (!blocks.read_program_line()) return items.take_problem();
  heidenhain::Program program{*columns, blocks.is_inch(), items};
  heidenhain::Block block;
  for (;;) {
    switch (blocks.next(block)) {
      case heidenhain::Text::Found::problem:
        return items.take_problem();
      case heidenhain::Text::Found::end_of_text:
        if (program.has_ended()) return ok();
        if (blocks.is_closed()) return sink(ReadItem{items.line(), ReadEnd{}});
        items.fail(Code::not_in_dialect, "the program has no M30 or M02: the text is cut off");
        return items.take_problem();
      case heidenhain::Text::Found::block:
        if (!program.execute(block)) return items.take_problem();
        if (program.has_ended()) blocks.set_ended();
    }
  }
}

}  // namespace pentapost::nc::readers
