#include "server/http/head.hpp"

#include <algorithm>
#include <charconv>

namespace pentapost::server {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::size_t longest_target = 8'000;  // httplib refuses 8192 and more in its own way

Problem malformed(std::string message) {
  return Problem{.code = Code::bad_request, .message = std::move(message)};
}

bool is_token_character(char c) {
  if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) return true;
  return std::string_view{"!#$%&'*+-.^_`|~"}.find(c) != std::string_view::npos;
}

bool is_token(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_token_character);
}

bool is_control(char c) { return (c >= 0 && c < 0x20 && c != '\t') || c == 0x7f; }

std::string lower(std::string_view text) {
  std::string result{text};
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Takes the text before the next `separator` off `rest`.
std::string_view take_until(std::string_view& rest, std::string_view separator) {
  const auto end = rest.find(separator);
  const auto part = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + separator.size());
  return part;
}

/// True where a comma-separated list has `token`, in any case.
bool lists(std::string_view list, std::string_view token) {
  while (!list.empty())
    if (lower(trimmed(take_until(list, ","))) == token) return true;
  return false;
}

/// "http://host/path" as "/path": proxies' form, which servers must read too (RFC 9112, 3.2.2).
std::string origin_form(std::string_view target) {
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (lower(target.substr(0, scheme.size())) != scheme) continue;
    const auto path = target.find_first_of("/?", scheme.size());
    if (path == std::string_view::npos) return "/";
    std::string origin = target[path] == '?' ? "/" : "";
    return origin.append(target.substr(path));
  }
  return std::string{target};
}

Status read_request_line(std::string_view line, Head& head, bool& version_1_1) {
  const auto method = take_until(line, " ");
  const auto target = take_until(line, " ");
  if (!is_token(method) || method.size() > 32)
    return malformed("the request line does not start with a method");
  const bool visible = std::ranges::all_of(target, [](char c) { return c > 0x20 && c < 0x7f; });
  head.target = origin_form(target);
  const bool star = head.target == "*" && method == "OPTIONS";
  if (!visible || (!head.target.starts_with('/') && !star))
    return malformed("the request target is not a path of visible ASCII characters");
  if (line != "HTTP/1.1" && line != "HTTP/1.0")
    return malformed("the request line does not end in HTTP/1.1 or HTTP/1.0");
  if (head.target.size() > longest_target) {
    return Problem{
        .code = Code::head_too_large,
        .message = "the request target is over " + std::to_string(longest_target) + " bytes"};
  }
  head.method = method;
  version_1_1 = line == "HTTP/1.1";
  return ok();
}

Status read_field(std::string_view line, Head& head) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos || !is_token(line.substr(0, colon)))
    return malformed("a header line is not 'name: value'");
  const auto value = trimmed(line.substr(colon + 1));
  if (std::ranges::any_of(value, is_control))
    return malformed("a header value holds a control character");
  head.headers.emplace_back(lower(line.substr(0, colon)), value);
  return ok();
}

/// At most one field of that name, or a Problem.
Result<const std::string*> single(const Head& head, std::string_view name) {
  const auto is_named = [name](const auto& field) { return field.first == name; };
  if (std::ranges::count_if(head.headers, is_named) > 1)
    return malformed("the header " + std::string{name} + " stands more than once");
  return find_field(head.headers, name);
}

Status read_content_length(const std::string& text, Head& head) {
  std::uint64_t length = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, length);
  if (error != std::errc{} || stop != end || length > (std::uint64_t{1} << 62))
    return malformed("Content-Length is not a number of bytes");
  head.content_length = length;
  return ok();
}

Status read_framing(Head& head, bool version_1_1) {
  const auto length = single(head, "content-length");
  if (!length) return length.error();
  const auto coding = single(head, "transfer-encoding");
  if (!coding) return coding.error();
  if (*length != nullptr) {
    if (*coding != nullptr)
      return malformed("Content-Length and Transfer-Encoding exclude each other");
    if (auto status = read_content_length(**length, head); !status) return status;
  }
  if (*coding != nullptr) {
    if (!version_1_1 || lower(**coding) != "chunked")
      return malformed("the only Transfer-Encoding is 'chunked', with HTTP/1.1");
    head.chunked = true;
  }
  return ok();
}

Status read_connection(Head& head, bool version_1_1) {
  const auto host = single(head, "host");
  if (!host) return host.error();
  if (version_1_1 && *host == nullptr) return malformed("the header Host is missing");
  head.keep_alive = version_1_1;
  for (const auto& [name, value] : head.headers) {
    if (name == "connection" && lists(value, "close")) head.keep_alive = false;
    if (name != "expect") continue;
    if (lower(value) != "100-continue") return malformed("the only Expect is '100-continue'");
    head.expects_continue = version_1_1;
  }
  return ok();
}

}  // namespace

Result<Head> parse_head(std::string_view text, const HeadLimits& limits) {
  if (text.size() > limits.bytes) {
    return Problem{
        .code = Code::head_too_large,
        .message = "the request's head is over " + std::to_string(limits.bytes) + " bytes"};
  }
  Head head;
  bool version_1_1 = false;
  auto rest = text;
  if (auto status = read_request_line(take_until(rest, "\r\n"), head, version_1_1); !status)
    return std::move(status).error();
  while (!rest.empty()) {
    if (head.headers.size() == limits.fields) {
      return Problem{
          .code = Code::head_too_large,
          .message = "the request has over " + std::to_string(limits.fields) + " headers"};
    }
    if (auto status = read_field(take_until(rest, "\r\n"), head); !status)
      return std::move(status).error();
  }
  if (auto status = read_framing(head, version_1_1); !status) return std::move(status).error();
  if (auto status = read_connection(head, version_1_1); !status) return std::move(status).error();
  return head;
}

}  // namespace pentapost::server
