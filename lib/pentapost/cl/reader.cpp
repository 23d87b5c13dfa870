#include "pentapost/cl/reader.hpp"

#include "pentapost/cl/interpreter.hpp"

#include <algorithm>
#include <array>

namespace pentapost::cl {
namespace {

/// How a major word is followed by its data.
enum class Form : std::uint8_t {
  slash,          ///< "WORD/data"
  slash_or_bare,  ///< "WORD/data" or "WORD"
  text,           ///< "WORD/text" or "WORD text"
  motion,         ///< "WORD/data"; anything else is a damaged motion
};

struct MajorRow {
  std::string_view word;
  Form form;
  Interpreter::Handler handle;
};

constexpr std::array major_rows{
    MajorRow{"AIR", Form::slash, &Interpreter::without_effect},
    MajorRow{"ARC", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"ARCSLP", Form::slash, &Interpreter::silent},
    MajorRow{"AUTOPS", Form::slash_or_bare, &Interpreter::silent},
    MajorRow{"AUXFUN", Form::slash, &Interpreter::auxiliary_function},
    MajorRow{"CHECK", Form::slash, &Interpreter::silent},
    MajorRow{"CIRCLE", Form::motion, &Interpreter::circle},
    MajorRow{"CLAMP", Form::slash, &Interpreter::without_effect},
    MajorRow{"CLEARP", Form::slash, &Interpreter::silent},
    MajorRow{"CLPRNT", Form::slash_or_bare, &Interpreter::silent},
    MajorRow{"CNTRL", Form::motion, &Interpreter::controls},
    MajorRow{"COOLNT", Form::slash, &Interpreter::coolant},
    MajorRow{"COPY", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"CSYS", Form::slash, &Interpreter::silent},
    MajorRow{"CUT", Form::slash_or_bare, &Interpreter::silent},
    MajorRow{"CUTCOM", Form::slash, &Interpreter::cutter_compensation},
    MajorRow{"CUTTER", Form::slash, &Interpreter::cutter},
    MajorRow{"CYCLE", Form::motion, &Interpreter::cycle},
    MajorRow{"DELAY", Form::slash, &Interpreter::delay},
    MajorRow{"DISPLY", Form::text, &Interpreter::silent},
    MajorRow{"DNTCUT", Form::slash_or_bare, &Interpreter::silent},
    MajorRow{"DWELL", Form::slash, &Interpreter::delay},
    MajorRow{"END", Form::slash_or_bare, &Interpreter::silent},
    MajorRow{"END-OF-PATH", Form::slash_or_bare, &Interpreter::end_of_path},
    MajorRow{"FEDRAT", Form::slash, &Interpreter::feed},
    MajorRow{"FINI", Form::slash_or_bare, &Interpreter::silent},
    MajorRow{"FROM", Form::motion, &Interpreter::from},
    MajorRow{"GO", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"GOBACK", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"GODLTA", Form::motion, &Interpreter::go_delta},
    MajorRow{"GODOWN", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"GOFWD", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"GOHOME", Form::slash_or_bare, &Interpreter::go_home},
    MajorRow{"GOLFT", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"GORGT", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"GOTO", Form::motion, &Interpreter::go_to_statement},
    MajorRow{"GOUP", Form::motion, &Interpreter::unreadable_motion},
    MajorRow{"HEADER", Form::text, &Interpreter::silent},
    MajorRow{"INDIRP", Form::slash, &Interpreter::silent},
    MajorRow{"INDIRV", Form::slash, &Interpreter::start_tangent},
    MajorRow{"INSERT", Form::text, &Interpreter::insert},
    MajorRow{"INTOL", Form::slash, &Interpreter::silent},
    MajorRow{"ISN", Form::slash, &Interpreter::silent},
    MajorRow{"KNOT", Form::motion, &Interpreter::knots},
    MajorRow{"KNOTS", Form::motion, &Interpreter::knots},
    MajorRow{"LETTER", Form::text, &Interpreter::silent},
    MajorRow{"LINTOL", Form::slash, &Interpreter::silent},
    MajorRow{"LOAD", Form::slash, &Interpreter::load},
    MajorRow{"LOADTL", Form::slash, &Interpreter::load_tool},
    MajorRow{"MACHIN", Form::text, &Interpreter::silent},
    MajorRow{"MCS", Form::slash, &Interpreter::frame_change},
    MajorRow{"MCSYS", Form::slash, &Interpreter::frame_change},
    MajorRow{"MODE", Form::slash, &Interpreter::coordinate_mode},
    MajorRow{"MOVARC", Form::motion, &Interpreter::circle},
    MajorRow{"MOVNRB", Form::slash, &Interpreter::silent},
    MajorRow{"MSYS", Form::slash, &Interpreter::silent},
    MajorRow{"MULTAX", Form::slash_or_bare, &Interpreter::multax},
    MajorRow{"NOPS", Form::slash_or_bare, &Interpreter::silent},
    MajorRow{"NURBS", Form::motion, &Interpreter::nurbs},
    MajorRow{"OPSKIP", Form::slash, &Interpreter::without_effect},
    MajorRow{"OPSTOP", Form::slash_or_bare, &Interpreter::optional_stop},
    MajorRow{"ORIGIN", Form::slash, &Interpreter::frame_change},
    MajorRow{"OUTTOL", Form::slash, &Interpreter::silent},
    MajorRow{"PAINT", Form::slash, &Interpreter::silent},
    MajorRow{"PARTNO", Form::text, &Interpreter::part_name},
    MajorRow{"PLUNGE", Form::motion, &Interpreter::clearance_motion},
    MajorRow{"PPFUN", Form::text, &Interpreter::without_effect},
    MajorRow{"PPRINT", Form::text, &Interpreter::print},
    MajorRow{"PREFUN", Form::slash, &Interpreter::without_effect},
    MajorRow{"PSIS", Form::slash, &Interpreter::silent},
    MajorRow{"RAPID", Form::slash_or_bare, &Interpreter::rapid},
    MajorRow{"REMARK", Form::text, &Interpreter::print},
    MajorRow{"RETRCT", Form::motion, &Interpreter::clearance_motion},
    MajorRow{"REWIND", Form::slash_or_bare, &Interpreter::silent},
    MajorRow{"ROTABL", Form::slash, &Interpreter::frame_change},
    MajorRow{"ROTATE", Form::slash, &Interpreter::frame_change},
    MajorRow{"ROTHED", Form::slash, &Interpreter::frame_change},
    MajorRow{"SELCTL", Form::slash, &Interpreter::silent},
    MajorRow{"SELECT", Form::slash, &Interpreter::select},
    MajorRow{"SEQNO", Form::slash, &Interpreter::silent},
    MajorRow{"SET", Form::slash, &Interpreter::coordinate_mode},
    MajorRow{"SETUP", Form::text, &Interpreter::silent},
    MajorRow{"SPINDL", Form::slash, &Interpreter::spindle},
    MajorRow{"STOP", Form::slash_or_bare, &Interpreter::stop},
    MajorRow{"THICK", Form::slash, &Interpreter::silent},
    MajorRow{"TLAXIS", Form::motion, &Interpreter::tool_axis},
    MajorRow{"TLDATA", Form::slash, &Interpreter::cutter},
    MajorRow{"TLON", Form::text, &Interpreter::tool_on_curve},
    MajorRow{"TOLER", Form::slash, &Interpreter::silent},
    MajorRow{"TOOL", Form::slash, &Interpreter::load_tool},
    MajorRow{"TOOL PATH", Form::slash, &Interpreter::tool_path},
    MajorRow{"TOOLNO", Form::slash, &Interpreter::silent},
    MajorRow{"TPRINT", Form::text, &Interpreter::tool_name},
    MajorRow{"TRACUT", Form::slash, &Interpreter::frame_change},
    MajorRow{"TRANS", Form::slash, &Interpreter::frame_change},
    MajorRow{"TRNTYP", Form::slash, &Interpreter::silent},
    MajorRow{"TURRET", Form::slash, &Interpreter::load_tool},
    MajorRow{"UNIT", Form::slash, &Interpreter::unit_statement},
    MajorRow{"UNITS", Form::slash, &Interpreter::unit_statement},
    MajorRow{"VERIFY", Form::slash, &Interpreter::silent},
    MajorRow{"ZSURF", Form::slash, &Interpreter::silent},
};
static_assert(std::is_sorted(major_rows.begin(), major_rows.end(),
                             [](const auto& a, const auto& b) { return a.word < b.word; }));

const MajorRow* find_row(std::string_view word) {
  const auto found =
      std::lower_bound(major_rows.begin(), major_rows.end(), word,
                       [](const MajorRow& row, std::string_view w) { return row.word < w; });
  return found != major_rows.end() && found->word == word ? &*found : nullptr;
}

bool has_form(const MajorRow& row, const Major& major) {
  switch (row.form) {
    case Form::slash:
      return major.slash;
    case Form::slash_or_bare:
      return major.slash || major.rest.empty();
    case Form::text:
    case Form::motion:
      return true;
  }
  return false;
}

/// The common case, before any table: what stands behind "GOTO /"; nullopt: another statement.
std::optional<std::string_view> go_to_data(std::string_view text) {
  constexpr std::size_t length = 4;
  if (text.size() <= length || upper(text[0]) != 'G' || upper(text[1]) != 'O' ||
      upper(text[2]) != 'T' || upper(text[3]) != 'O')
    return std::nullopt;
  std::size_t at = length;
  while (at < text.size() && is_blank(text[at])) ++at;
  if (at == text.size() || text[at] != '/') return std::nullopt;
  return text.substr(at + 1);
}

/// True where an unknown statement holds a motion, such as "N10 GOTO/1,2,3".
bool holds_motion(std::string_view text) {
  for (std::size_t slash = text.find('/'); slash != std::string_view::npos;
       slash = text.find('/', slash + 1)) {
    const std::string_view before =
        trimmed(text.substr(slash < 24 ? 0 : slash - 24, slash < 24 ? slash : 24));
    for (const std::string_view word : {"GOTO", "GODLTA", "CIRCLE"}) {
      if (before.size() >= word.size() &&
          same_word(before.substr(before.size() - word.size()), word))
        return true;
    }
  }
  return false;
}

}  // namespace

Interpreter::Interpreter(const ClDialect& dialect, const UnitStatements& units,
                         const ReadOptions& options, ReadResult& result)
    : dialect_{dialect},
      result_{result},
      path_{result.path},
      diagnostics_{result.diagnostics},
      units_found_{units},
      units_are_given_{options.units.has_value()},
      in_text_{dialect.text_around} {
  if (options.units)
    units_ = *options.units;
  else if (units.stated)
    units_ = *units.stated;
  else if (units.by_feed)
    units_ = *units.by_feed;
  else
    report_at(Severity::warning, Code::unit_assumed, 0, [] {
      return std::string{
          "Neither a UNITS statement nor a feed gives the unit of length: mm was assumed."};
    });
  mm_ = mm_per(units_);
  units_line_ = units.stated_line;
  result_.units = units_;
}

void Interpreter::read(const Statement& statement) {
  statement_ = &statement;
  line_ = statement.line;
  if (statement.kind == Statement::Kind::statement) {
    if (!nurbs_) {
      if (const auto coordinates = go_to_data(statement.text)) {
        in_text_ = false;
        return go_to(*coordinates);
      }
    }
    return dispatch(statement);
  }
  if (statement.kind == Statement::Kind::comment)
    comment(statement);
  else
    data_comment(statement);
}

void Interpreter::dispatch(const Statement& statement) {
  const Major major = read_major(statement.text);
  if (nurbs_ && major.word() != "KNOT" && major.word() != "KNOTS" && major.word() != "CNTRL")
    finish_nurbs();
  const MajorRow* row = find_row(major.word());
  const bool is_prose = in_text_ && !major.slash && !major.rest.empty();
  if (row == nullptr || !has_form(*row, major) || is_prose) return unknown(statement);
  in_text_ = false;
  (this->*row->handle)(major);
}

void Interpreter::unknown(const Statement& statement) {
  if (in_text_) return;
  if (holds_motion(statement.text)) {
    report_damage(Severity::error, Code::damaged_motion, "a statement that starts with its word");
    return;
  }
  report(Severity::warning, Code::unknown_statement,
         [&] { return quoted_excerpt(statement.text) + " is not known and was left out."; });
}

void Interpreter::finish() {
  if (nurbs_) finish_nurbs();
  drop_arc();
  end_cycle();
  settle_open_arcs(path_, open_arcs_, diagnostics_);
  path_.axis_rounding_rad = axis_rounding_rad();
  if (path_.size() == 0 && !diagnostics_.has_errors()) {
    diagnostics_.add({Severity::error, Code::no_motion, 0,
                      "The text holds no motion: expected CL data with GOTO statements."});
  }
}

ReadResult read(std::string_view text, const ReadOptions& options) {
  ReadResult result;
  const ClDialect* dialect = &detect_cl_dialect(text);
  if (options.dialect) {
    dialect = find_cl_dialect(*options.dialect);
    if (dialect == nullptr) {
      result.diagnostics.add({Severity::error, Code::unknown_dialect, 0,
                              "There is no CL dialect " + quoted_excerpt(*options.dialect) + "."});
      return result;
    }
  }
  result.dialect = dialect->name;
  // A line with three numbers has about 32 characters; pages that stay unused cost nothing.
  constexpr std::size_t shortest_line = 32;
  result.path.reserve(text.size() / shortest_line);
  Interpreter interpreter{*dialect, find_units(text), options, result};
  Statements statements{text};
  Statement statement;
  while (statements.next(statement)) interpreter.read(statement);
  result.lines = statements.lines();
  interpreter.finish();
  return result;
}

}  // namespace pentapost::cl
