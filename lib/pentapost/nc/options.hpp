#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/machine/definition.hpp"
#include "pentapost/nc/dialect.hpp"

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pentapost::nc {

/// Typed access to a controller's options against the rows of its dialect.
///
/// Every accessor gives the option, or the row's default where the option is not set or not usable.
/// The first misuse is kept: read all options, then ask problem() before using any of them.
class OptionReader {
 public:
  /// Both must outlive the reader. Finds options that no row knows.
  OptionReader(std::span<const OptionRow> rows, const machine::Options& options);

  bool flag(std::string_view name);
  /// A whole number in [lowest, highest].
  int whole(std::string_view name, int lowest, int highest);
  /// A finite number in [lowest, highest].
  double number(std::string_view name, double lowest, double highest);
  /// One line of printable ASCII; may be empty.
  std::string text(std::string_view name);
  /// Lines of printable ASCII, none of them empty. The list may be empty.
  /// @param placeholders  what the dialect fills in, "{tool}"; others are refused.
  std::vector<std::string> lines(std::string_view name,
                                 std::initializer_list<std::string_view> placeholders = {});

  /// Refuses the option for a reason of the caller's.
  void refuse(std::string_view name, const std::string& reason);

  /// Code bad_option, its message names the option; pointer into the definition. nullopt: all is
  /// well.
  const std::optional<Problem>& problem() const noexcept { return problem_; }

 private:
  template <class T>
  const T& typed(std::string_view name, std::string_view type_name);

  std::span<const OptionRow> rows_;
  const machine::Options& options_;
  std::optional<Problem> problem_;
};

}  // namespace pentapost::nc
