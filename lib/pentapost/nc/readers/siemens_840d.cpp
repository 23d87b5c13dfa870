#include "pentapost/nc/readers/siemens_840d.hpp"

#include "pentapost/nc/readers/siemens_program.hpp"
#include "pentapost/nc/readers/siemens_text.hpp"

#include <optional>

namespace pentapost::nc::readers {
namespace {

/// The D of the option edge_after_tool_change; nullopt: not known.
std::optional<int> edge_after_change(const machine::Options& options) {
  const auto found = options.find("edge_after_tool_change");
  if (found == options.end()) return std::nullopt;
  const double* const edge = std::get_if<double>(&found->second);
  constexpr double most_edges = 12.0;
  if (edge == nullptr || !(*edge >= 1.0 && *edge <= most_edges)) return std::nullopt;
  return static_cast<int>(*edge);
}

}  // namespace

Status read_siemens_840d(std::string_view text, const ReaderSetup& setup, const ItemSink& sink) {
  auto columns = AxisColumns::make(setup.letters);
  if (!columns) return std::move(columns).error();
  ItemStream items{sink};
  siemens::Text blocks{text, items};
  siemens::Program program{*columns, items, edge_after_change(setup.options)};
  siemens::Block block;
  for (;;) {
    switch (blocks.next(block)) {
      case siemens::Text::Found::problem:
        return items.take_problem();
      case siemens::Text::Found::end_of_text:
        if (program.has_ended()) return ok();
        items.fail(Code::not_in_dialect,
                   "the program has no M30, M2, M17 or RET: the text is cut off");
        return items.take_problem();
      case siemens::Text::Found::block:
        if (!program.execute(block)) return items.take_problem();
        if (program.has_ended()) blocks.set_ended();
    }
  }
}

}  // namespace pentapost::nc::readers
