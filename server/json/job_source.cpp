#include "server/json/job_source.hpp"

#include "pentapost/core/number_text.hpp"
#include "server/json/name_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pentapost::server {
namespace {

using json::Domain;
using json::Object;

/// The words of a job, and where in the JSON job each belongs.
struct WordRow {
  std::string_view name, pointer;
};
constexpr std::array word_rows{
    WordRow{"machine", "/machine"},
    WordRow{"output", "/post/output"},
    WordRow{"dialect", "/post/dialect"},
    WordRow{"tip_mm", "/tolerances/tip_mm"},
    WordRow{"axis_deg", "/tolerances/axis_deg"},
    WordRow{"cl_units", "/cl_units"},
    WordRow{"program_name", "/post/program_name"},
    WordRow{"zone_share", "/zone_share"},
    WordRow{"nc_dialect", "/nc_dialect"},
    WordRow{"objective", "/objective"},
    WordRow{"max_tilt_deg", "/max_tilt_deg"},
    WordRow{"setup_accuracy_deg", "/setup_accuracy_deg"},
    WordRow{"machines", "/machines"},
    WordRow{"reorient", "/reorient"},
};

}  // namespace

std::string_view word_pointer(std::string_view word) {
  const auto row = std::ranges::find(word_rows, word, &WordRow::name);
  return row == word_rows.end() ? std::string_view{} : row->pointer;
}

void JobSource::fail(Code code, std::string_view pointer, std::string message) {
  fail({.code = code, .message = std::move(message), .pointer = std::string{pointer}});
}

void JobSource::fail(Problem problem) {
  if (!word_problem_ && !document_.problem()) word_problem_ = std::move(problem);
}

/// fail() keeps nothing after a failure of the document, so what it kept came before.
const std::optional<Problem>& JobSource::first_problem() const {
  return word_problem_ ? word_problem_ : document_.problem();
}

void JobSource::check_words(std::span<const std::string_view> excluded) {
  for (const auto& [name, value] : parts_.words) {
    if (word_pointer(name).empty() || std::ranges::find(excluded, name) != excluded.end())
      return fail(Code::unknown_key, json::pointer_step(name),
                  quoted(name) + " is not a key of this form");
    const auto same = [&name = name](const auto& field) { return field.first == name; };
    if (std::ranges::count_if(parts_.words, same) > 1)
      return fail(Code::conflicting_keys, word_pointer(name), quoted(name) + " stands twice");
  }
}

const std::string* JobSource::word(std::string_view name, const std::optional<Object>& object,
                                   std::string_view key) {
  const auto* found = find_field(parts_.words, name);
  if (found != nullptr && object && object->has(key)) {
    fail(Code::conflicting_keys, word_pointer(name),
         quoted(name) + " stands in the job and beside it");
  }
  return found;
}

std::optional<std::size_t> JobSource::choice(std::string_view name,
                                             const std::optional<Object>& object,
                                             std::string_view key,
                                             std::span<const std::string_view> words) {
  const auto* found = word(name, object, key);
  if (found == nullptr) return object ? object->optional_choice(key, words) : std::nullopt;
  const auto place = std::ranges::find(words, std::string_view{*found});
  if (place == words.end()) {
    fail(Code::out_of_domain, word_pointer(name),
         "found " + quoted(*found) + ", expected " + joined({words.begin(), words.end()}));
    return std::nullopt;
  }
  return static_cast<std::size_t>(place - words.begin());
}

std::optional<double> JobSource::number(std::string_view name, const std::optional<Object>& object,
                                        const Domain& domain) {
  const auto* found = word(name, object, name);
  if (found == nullptr) return object ? object->optional_number(name, domain) : std::nullopt;
  const auto number = parse_number(*found);
  if (!number || number->length != found->size() || !domain.contains(number->value)) {
    const std::string above = domain.lower_open ? "above " : "of at least ";
    const std::string bound =
        std::isfinite(domain.upper) ? " and of at most " + number_text(domain.upper) : "";
    fail(Code::out_of_domain, word_pointer(name),
         "found " + quoted(*found) + ", expected a number " + above + number_text(domain.lower) +
             bound);
    return std::nullopt;
  }
  return number->value;
}

std::optional<std::string> JobSource::text(std::string_view name,
                                           const std::optional<Object>& object) {
  const auto* found = word(name, object, name);
  if (found != nullptr) return *found;
  return object ? object->optional_string(name) : std::nullopt;
}

}  // namespace pentapost::server
