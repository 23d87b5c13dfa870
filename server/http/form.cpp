#include "server/http/form.hpp"

#include "server/http/media_type.hpp"

#include <optional>

namespace pentapost::server {
namespace {

constexpr std::size_t most_fields = 16;
constexpr std::size_t longest_boundary = 70;  // RFC 2046, 5.1.1

Problem damaged(std::string message) {
  return Problem{.code = Code::bad_form, .message = std::move(message)};
}

/// The Content-Disposition of form-data among the header lines of a part.
std::optional<std::string_view> disposition_of_part(std::string_view headers) {
  while (!headers.empty()) {
    const auto end = headers.find("\r\n");
    const auto line = headers.substr(0, end);
    headers = end == std::string_view::npos ? std::string_view{} : headers.substr(end + 2);
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    if (media_type_of(line.substr(0, colon)) != "content-disposition") continue;
    if (media_type_of(line.substr(colon + 1)) != "form-data") return std::nullopt;
    return line.substr(colon + 1);
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<FormField>> read_form(std::string_view content_type, std::string_view body) {
  const auto boundary = parameter_of(content_type, "boundary");
  if (!boundary || boundary->empty() || boundary->size() > longest_boundary)
    return damaged("the Content-Type has no boundary of 1 to 70 characters");
  const std::string opening = "--" + *boundary;
  const std::string separator = "\r\n" + opening;
  auto start = body.starts_with(opening) ? opening.size() : body.find(separator);
  if (start == std::string_view::npos) return damaged("the boundary does not stand in the body");
  if (!body.starts_with(opening)) start += separator.size();

  std::vector<FormField> fields;
  for (auto rest = body.substr(start); !rest.starts_with("--");) {
    if (!rest.starts_with("\r\n")) return damaged("a boundary does not end its line");
    if (fields.size() == most_fields) return damaged("the form has more than 16 fields");
    // A part without headers starts with an empty line at once.
    const auto headers_end = rest.find("\r\n\r\n");
    const auto end = rest.find(separator, 2);
    if (end == std::string_view::npos) return damaged("the closing boundary is missing");
    if (headers_end == std::string_view::npos || headers_end + 4 > end + 2)
      return damaged("a field has no header");
    const auto disposition =
        disposition_of_part(rest.substr(2, headers_end < 2 ? 0 : headers_end - 2));
    const auto name = disposition ? parameter_of(*disposition, "name") : std::nullopt;
    if (!name) return damaged("a field has no name");
    const auto content_start = headers_end + 4;
    const auto content =
        content_start > end ? std::string_view{} : rest.substr(content_start, end - content_start);
    fields.push_back(FormField{.name = *name,
                               .content = content,
                               .file_name = parameter_of(*disposition, "filename").value_or("")});
    rest = rest.substr(end + separator.size());
  }
  return fields;
}

}  // namespace pentapost::server
