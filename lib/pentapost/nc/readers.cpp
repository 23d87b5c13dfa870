#include "pentapost/nc/reader.hpp"

#include "pentapost/nc/readers/fanuc_30i.hpp"
#include "pentapost/nc/readers/heidenhain_iso.hpp"

#include <array>

namespace pentapost::nc {
namespace {

constexpr std::array readers_by_name{
    Reader{"fanuc-30i", readers::read_fanuc_30i},
    Reader{"heidenhain-iso", readers::read_heidenhain_iso},
};

}  // namespace

std::span<const Reader> readers_of_dialects() { return readers_by_name; }

const Reader* find_reader(std::string_view name) {
  for (const Reader& reader : readers_by_name)
    if (reader.name == name) return &reader;
  return nullptr;
}

}  // namespace pentapost::nc
