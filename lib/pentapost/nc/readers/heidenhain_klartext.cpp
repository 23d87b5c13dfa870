#include "pentapost/nc/readers/heidenhain_klartext.hpp"

#include "pentapost/nc/readers/klartext_program.hpp"
#include "pentapost/nc/readers/klartext_text.hpp"

#include <utility>

namespace pentapost::nc::readers {

Status read_heidenhain_klartext(std::string_view text, const ReaderSetup& setup,
                                const ItemSink& sink) {
  auto columns = AxisColumns::make(setup.letters);
  if (!columns) return std::move(columns).error();
  ItemStream items{sink};
  klartext::Text blocks{text, items};
  if (!blocks.read_program_line()) return items.take_problem();
  klartext::Program program{*columns, blocks.is_inch(), items};
  klartext::Block block;
  for (;;) {
    switch (blocks.next(block)) {
      case klartext::Text::Found::problem:
        return items.take_problem();
      case klartext::Text::Found::end_of_text:
        if (program.has_ended()) return ok();
        items.fail(Code::not_in_dialect,
                   "the program has neither M30 nor END PGM: the text is cut off");
        return items.take_problem();
      case klartext::Text::Found::block:
        if (!program.execute(block)) return items.take_problem();
    }
  }
}

}  // namespace pentapost::nc::readers
