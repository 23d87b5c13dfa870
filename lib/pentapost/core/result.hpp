#pragma once

#include "pentapost/core/codes.hpp"
#include "pentapost/core/diagnostics.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace pentapost {

/// Why a job cannot be served, and where in the caller's input.
struct Problem {
  Code code;                                  ///< stable for callers; its row is in core/codes.hpp
  std::string message;                        ///< what was found and what was expected
  std::optional<std::uint32_t> cl_line = {};  ///< 1-based line of the CL data
  std::string pointer = {};                   ///< RFC 6901 JSON pointer into the request body
  Diagnostics diagnostics = {};               ///< all that was found, where there is more than one
};

/// A value, or the Problem that prevented it. Member names are those of std::expected (C++23).
template <class T>
class [[nodiscard]] Result {
 public:
  // Not explicit, so that a function returns either as it is.
  Result(T value)  // NOLINT(google-explicit-constructor)
      : state_{std::in_place_index<0>, std::move(value)} {}
  Result(Problem problem)  // NOLINT(google-explicit-constructor)
      : state_{std::in_place_index<1>, std::move(problem)} {}
  bool has_value() const noexcept { return state_.index() == 0; }
  explicit operator bool() const noexcept { return has_value(); }
  const T& value() const& { return std::get<0>(state_); }  ///< throws on a Problem: a defect, 500
  T& value() & { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }
  const Problem& error() const& { return std::get<1>(state_); }
  Problem&& error() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, Problem> state_;
};

/// Nothing to give, only success or the Problem.
using Status = Result<std::monostate>;
inline Status ok() { return Status{std::monostate{}}; }

}  // namespace pentapost
