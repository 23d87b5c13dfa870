#pragma once

#include "pentapost/json/strict_reader.hpp"
#include "server/json/job_json.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pentapost::server {

/// The JSON pointer of the key that a word of a job stands for; empty: there is no such word.
std::string_view word_pointer(std::string_view word);

/// The JSON job and the words beside it as one source of values. The first failure is kept; reading
/// goes on with "none" after it. Refers to document and parts.
class JobSource {
 public:
  JobSource(json::Document& document, const JobParts& parts) : document_{document}, parts_{parts} {}

  /// Every word must be known, none of the excluded, and stand once.
  void check_words(std::span<const std::string_view> excluded);

  /// The word of that name; nullptr: there is none. It and the key in the JSON job exclude each
  /// other.
  const std::string* word(std::string_view name, const std::optional<json::Object>& object,
                          std::string_view key);
  /// Index of one of `words`.
  std::optional<std::size_t> choice(std::string_view name,
                                    const std::optional<json::Object>& object, std::string_view key,
                                    std::span<const std::string_view> words);
  /// A number of a domain with a lower end.
  std::optional<double> number(std::string_view name, const std::optional<json::Object>& object,
                               const json::Domain& domain);
  std::optional<std::string> text(std::string_view name, const std::optional<json::Object>& object);

  void fail(Code code, std::string_view pointer, std::string message);
  void fail(Problem problem);
  const std::optional<Problem>& first_problem() const;

 private:
  json::Document& document_;
  const JobParts& parts_;
  std::optional<Problem> word_problem_ = {};  ///< first failure outside the JSON text
};

}  // namespace pentapost::server
