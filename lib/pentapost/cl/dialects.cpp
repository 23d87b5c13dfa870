#include "pentapost/cl/dialects.hpp"

#include "pentapost/cl/words.hpp"

#include <algorithm>
#include <string>

namespace pentapost::cl {
namespace {

// Arc senses: read off the tangents of the neighbouring GOTO in files of each system.
constexpr std::array table{
    ClDialect{.name = "nx-clsf",
              .title = "Siemens NX, CLSF",
              .line_starts = {"TOOLPATH/", "$$CENTERLINEDATA", "PAINT/", "END-OF-PATH",
                              "INFORMATIONLISTINGCREATEDBY"},
              .arc_sense = ArcSense::left_handed,
              .depth_is_signed = true,
              .text_around = true,
              .axis_resets = true},
    ClDialect{.name = "catia-apt",
              .title = "CATIA V5, APT source",
              .line_starts = {"$$CATIAAPT", "$$*CATIA0", "$$MANUFACTURINGPROGRAM",
                              "$$OPERATIONNAME", "$$*AXS1"}},
    ClDialect{.name = "creo-ncl",
              .title = "PTC Creo, NCL",
              .line_starts = {"$$*PRO/CLFILE", "$$*CREO", "$$->", "MACHIN/UNCX01"},
              .arc_sense = ArcSense::right_handed,
              .axis_resets = true},
    ClDialect{.name = "makino-aptcl",
              .title = "Makino FF, APTCL",
              .line_starts = {"PPRINT/APTCL-SPEC"},
              .arc_sense = ArcSense::left_handed,
              .pprint_is_data = true},
    ClDialect{.name = "solidworks-cam-clt",
              .title = "SolidWorks CAM, CLT",
              .line_parts = {",COUNTERCLOCKWISE", ",CLOCKWISE"},
              .arc_sense = ArcSense::right_handed},
    ClDialect{.name = "solidworks-cam-apt",
              .title = "SolidWorks CAM, APT",
              .line_starts = {"TRNTYP/", "CSYS/", "CYCLE/INIT"},
              .line_parts = {"SOLIDWORKSCAM", "CAMWORKS"},
              .arc_sense = ArcSense::right_handed},
    ClDialect{.name = "nccs-apt",
              .title = "NCCS, APT",
              .line_starts = {"$$NCL"},
              .line_parts = {"NCCS", "NUMERICALCONTROLCOMPUTERSCIENCES"}},
    ClDialect{.name = "fusion-apt",
              .title = "Autodesk Fusion, ISO 4343 APT",
              .line_starts = {"MODE/MILL", "MODE/TURN"},
              .arc_sense = ArcSense::right_handed,
              .hole_point = HolePoint::bottom,
              .clearance_is_height = true,
              .rapto_is_below_clearance = true,
              .bare_spindle_is_unclear = true},
    ClDialect{.name = "apt", .title = "APT"},
};

constexpr std::size_t first_lines = 400;
constexpr std::size_t longest_mark = 64;

/// The first characters of `line` in upper case, blanks left out.
std::string packed(std::string_view line) {
  std::string text;
  for (const char c : line) {
    if (text.size() >= longest_mark) break;
    if (!is_blank(c)) text += upper(c);
  }
  return text;
}

bool has_mark(const ClDialect& dialect, std::string_view line) {
  const auto starts = [&](std::string_view mark) {
    return !mark.empty() && line.starts_with(mark);
  };
  const auto holds = [&](std::string_view mark) {
    return !mark.empty() && line.find(mark) != std::string_view::npos;
  };
  return std::any_of(dialect.line_starts.begin(), dialect.line_starts.end(), starts) ||
         std::any_of(dialect.line_parts.begin(), dialect.line_parts.end(), holds);
}

}  // namespace

std::span<const ClDialect> cl_dialects() { return table; }

const ClDialect* find_cl_dialect(std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const ClDialect& dialect) { return dialect.name == name; });
  return found == table.end() ? nullptr : &*found;
}

const ClDialect& detect_cl_dialect(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  for (std::size_t line = 0; line < first_lines && !text.empty(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\n\r"), text.size());
    const std::string start = packed(text.substr(0, end));
    for (const ClDialect& dialect : table)
      if (has_mark(dialect, start)) return dialect;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return table.back();
}

}  // namespace pentapost::cl
