#include "server/http/media_type.hpp"

#include <charconv>

namespace pentapost::server {
namespace {

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lower(std::string_view text) {
  std::string result{text};
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

/// Takes the part before the next `separator` outside quotes off `rest`.
std::string_view take_part(std::string_view& rest, char separator) {
  bool quoted = false;
  std::size_t end = 0;
  for (; end < rest.size() && (quoted || rest[end] != separator); ++end) {
    if (rest[end] == '\\' && quoted)
      ++end;
    else if (rest[end] == '"')
      quoted = !quoted;
  }
  end = std::min(end, rest.size());
  const auto part = trimmed(rest.substr(0, end));
  rest = end == rest.size() ? std::string_view{} : rest.substr(end + 1);
  return part;
}

/// The q of one element of a list, 0 to 1; a damaged one counts as 0.
double quality_of(std::string_view element) {
  const auto text = parameter_of(element, "q");
  if (!text) return 1.0;
  double quality = 0.0;
  const char* const end = text->data() + text->size();
  const auto [stop, error] = std::from_chars(text->data(), end, quality, std::chars_format::fixed);
  const bool usable = error == std::errc{} && stop == end && quality >= 0.0 && quality <= 1.0;
  return usable ? quality : 0.0;
}

/// How exactly `range` ("text/*") names `type`: 0 not at all, 1 by */*, 2 by type/*, 3 in full.
int match_of(std::string_view range, std::string_view type) {
  if (range == type) return 3;
  if (range == "*/*") return 1;
  const bool whole_kind = range.size() > 2 && range.ends_with("/*");
  return whole_kind && type.starts_with(range.substr(0, range.size() - 1)) ? 2 : 0;
}

double quality_for(std::string_view accept, std::string_view type) {
  int best_match = 0;
  double quality = 0.0;
  while (!accept.empty()) {
    const auto element = take_part(accept, ',');
    const int match = match_of(media_type_of(element), type);
    if (match <= best_match) continue;
    best_match = match;
    quality = quality_of(element);
  }
  return quality;
}

}  // namespace

std::string media_type_of(std::string_view content_type) {
  return lower(take_part(content_type, ';'));
}

std::optional<std::string> parameter_of(std::string_view header_value, std::string_view name) {
  take_part(header_value, ';');
  while (!header_value.empty()) {
    auto part = take_part(header_value, ';');
    const auto equals = part.find('=');
    if (equals == std::string_view::npos) continue;
    if (lower(trimmed(part.substr(0, equals))) != name) continue;
    auto value = trimmed(part.substr(equals + 1));
    if (value.size() < 2 || value.front() != '"' || value.back() != '"') return std::string{value};
    value = value.substr(1, value.size() - 2);
    std::string unquoted;
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (value[i] == '\\' && i + 1 < value.size()) ++i;
      unquoted.push_back(value[i]);
    }
    return unquoted;
  }
  return std::nullopt;
}

std::optional<std::string_view> negotiate(std::string_view accept,
                                          std::span<const std::string_view> offered) {
  if (trimmed(accept).empty()) return offered.front();
  std::optional<std::string_view> best;
  double best_quality = 0.0;
  for (const auto type : offered) {
    const double quality = quality_for(accept, type);
    if (quality <= best_quality) continue;
    best_quality = quality;
    best = type;
  }
  return best;
}

bool accepts_gzip(std::string_view accept_encoding) {
  while (!accept_encoding.empty()) {
    const auto element = take_part(accept_encoding, ',');
    if (media_type_of(element) == "gzip") return quality_of(element) > 0.0;
  }
  return false;
}

}  // namespace pentapost::server
