#include "pentapost/nc/reader.hpp"

#include "pentapost/nc/readers/fanuc_30i.hpp"
#include "pentapost/nc/readers/heidenhain_iso.hpp"
#include "pentapost/nc/readers/heidenhain_klartext.hpp"
#include "pentapost/nc/readers/siemens_840d.hpp"

#include <array>

namespace pentapost::nc {
namespace {

constexpr std::array readers_by_name{
    Reader{"fanuc-30i", readers::read_fanuc_30i},
    Reader{"heidenhain", readers::read_heidenhain_klartext},
    Reader{"heidenhain-iso", readers::read_heidenhain_iso},
    Reader{"siemens-840d", readers::read_siemens_840d},
};

}  // namespace

std::span<const Reader> readers_of_dialects() { return readers_by_name; }

const Reader* find_reader(std::string_view name) {
  for (const Reader& reader : readers_by_name)
    if (reader.name == name) return &reader;
  return nullptr;
}

}  // namespace pentapost::nc
