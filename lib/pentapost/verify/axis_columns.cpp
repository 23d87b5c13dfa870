#include "pentapost/verify/axis_columns.hpp"

#include <algorithm>
#include <string>

namespace pentapost::verify {

Result<AxisColumns> AxisColumns::make(std::string_view letters, const kinematics::Model& model) {
  const Problem mismatch{Code::proof_failed, "The words \"" + std::string{letters} +
                                                 "\" are not those of the machine's axes"};
  AxisColumns columns;
  columns.rotary_count_ = static_cast<std::size_t>(model.rotary_count);
  if (letters.size() != columns.count()) return mismatch;
  std::copy(letters.begin(), letters.end(), columns.letters_.begin());
  for (std::size_t i = 0; i < 3; ++i)
    if (model.linear_names[i] != letters.substr(i, 1)) return mismatch;

  std::array<std::size_t*, 2> rotary_columns{&columns.first_, &columns.second_};
  for (std::size_t i = 0; i < columns.rotary_count_; ++i) {
    const std::string& name = model.rotary_names[i];
    const std::size_t column = name.size() == 1 ? letters.find(name, 3) : std::string_view::npos;
    if (column == std::string_view::npos) return mismatch;
    *rotary_columns[i] = column;
  }
  if (columns.rotary_count_ == 2 && columns.first_ == columns.second_) return mismatch;
  return columns;
}

std::optional<std::size_t> AxisColumns::find(char letter) const {
  const auto end = letters_.begin() + static_cast<std::ptrdiff_t>(count());
  const auto found = std::find(letters_.begin(), end, letter);
  if (found == end) return std::nullopt;
  return static_cast<std::size_t>(found - letters_.begin());
}

}  // namespace pentapost::verify
