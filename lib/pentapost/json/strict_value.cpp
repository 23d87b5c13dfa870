#include "pentapost/json/strict_reader.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/json/node.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace pentapost::json {
namespace {

constexpr double largest_exact_integer = 9007199254740992.0;  ///< 2^53
constexpr std::size_t longest_quote = 60;                     ///< bytes of a string in a message

std::string text_of(const Domain& domain) {
  const bool has_lower = std::isfinite(domain.lower);
  const bool has_upper = std::isfinite(domain.upper);
  const std::string lower = (domain.lower_open ? "above " : "of at least ") +
                            (has_lower ? number_text(domain.lower) : "");
  const std::string upper = "of at most " + (has_upper ? number_text(domain.upper) : "");
  if (has_lower && has_upper) return "a number " + lower + " and " + upper;
  if (has_lower) return "a number " + lower;
  return has_upper ? "a number " + upper : "a finite number";
}

/// Appends the steps from `node` down to `wanted`; false: it is not below `node`.
bool append_path(const Node& node, const Node* wanted, std::string& path) {
  if (&node == wanted) return true;
  const auto length = path.size();
  if (const auto* const object = object_of(&node)) {
    for (const auto& member : object->members) {
      path += pointer_step(member.key);
      if (append_path(member.node, wanted, path)) return true;
      path.resize(length);
    }
  } else if (const auto* const nodes = std::get_if<std::vector<Node>>(&node.value)) {
    for (std::size_t i = 0; i < nodes->size(); ++i) {
      path += pointer_step(std::to_string(i));
      if (append_path((*nodes)[i], wanted, path)) return true;
      path.resize(length);
    }
  }
  return false;
}

template <class T>
T* content(Node* node, const std::optional<std::size_t>& element) {
  return node == nullptr || element ? nullptr : std::get_if<T>(&node->value);
}

}  // namespace

std::string quoted(std::string_view text) {
  if (text.size() <= longest_quote) return '"' + std::string{text} + '"';
  return "a string of " + std::to_string(text.size()) + " bytes";
}

std::string pointer_step(std::string_view key) {
  std::string step = "/";
  for (const char letter : key) {
    if (letter == '~')
      step += "~0";
    else if (letter == '/')
      step += "~1";
    else
      step += letter;
  }
  return step;
}

bool Value::is_null() const { return content<std::monostate>(node_, element_) != nullptr; }
bool Value::is_boolean() const { return content<bool>(node_, element_) != nullptr; }
bool Value::is_number() const { return element_ || content<double>(node_, element_) != nullptr; }
bool Value::is_string() const { return content<std::string>(node_, element_) != nullptr; }
bool Value::is_array() const {
  return content<std::vector<double>>(node_, element_) != nullptr ||
         content<std::vector<Node>>(node_, element_) != nullptr;
}
bool Value::is_object() const { return !element_ && object_of(node_) != nullptr; }

std::string Value::pointer() const {
  if (node_ == nullptr) return reading_->problem ? reading_->problem->pointer : std::string{};
  std::string path;
  append_path(reading_->root, node_, path);
  return element_ ? path + pointer_step(std::to_string(*element_)) : path;
}

void Value::fail(Code code, std::string message) const {
  if (reading_->problem) return;
  reading_->problem = Problem{.code = code, .message = std::move(message), .pointer = pointer()};
}

std::string Value::found() const {
  if (is_null()) return "null";
  if (const bool* const truth = content<bool>(node_, element_)) return *truth ? "true" : "false";
  if (is_number()) {
    const double value = element_ ? std::get<std::vector<double>>(node_->value)[*element_]
                                  : std::get<double>(node_->value);
    return number_text(value);
  }
  if (const auto* const text = content<std::string>(node_, element_)) return quoted(*text);
  return is_array() ? "an array" : "an object";
}

void Value::expected(std::string_view what) const {
  if (node_ == nullptr || reading_->problem) return;
  fail(Code::wrong_type, "found " + found() + "; expected " + std::string{what});
}

bool Value::boolean() const {
  if (const bool* const truth = content<bool>(node_, element_)) return *truth;
  expected("true or false");
  return false;
}

double Value::number(Domain domain) const {
  if (!is_number()) {
    expected(text_of(domain));
    return 0.0;
  }
  const double value = element_ ? std::get<std::vector<double>>(node_->value)[*element_]
                                : std::get<double>(node_->value);
  if (domain.contains(value)) return value;
  if (!reading_->problem)
    fail(Code::out_of_domain, "found " + number_text(value) + "; expected " + text_of(domain));
  return 0.0;
}

std::int64_t Value::integer(std::int64_t lower, std::int64_t upper) const {
  const double value = number();
  if (!is_number()) return 0;
  if (value != std::trunc(value) || std::abs(value) > largest_exact_integer) {
    fail(Code::wrong_type, "found " + number_text(value) + "; expected an integer");
    return 0;
  }
  const auto integer = static_cast<std::int64_t>(value);
  if (lower <= integer && integer <= upper) return integer;
  fail(Code::out_of_domain, "found " + std::to_string(integer) + "; expected an integer from " +
                                std::to_string(lower) + " to " + std::to_string(upper));
  return 0;
}

std::string Value::string() const {
  if (const auto* const text = content<std::string>(node_, element_)) return *text;
  expected("a string");
  return {};
}

std::string Value::take_string() const {
  if (auto* const text = content<std::string>(node_, element_)) return std::exchange(*text, {});
  expected("a string");
  return {};
}

Array Value::array() const {
  if (is_array()) return Array{*this};
  expected("an array");
  return Array{Value{reading_, nullptr}};
}

Object Value::object() const {
  if (is_object()) return Object{*this};
  expected("an object");
  return Object{Value{reading_, nullptr}};
}

std::size_t Array::size() const {
  if (const auto* const flat = content<std::vector<double>>(value_.node_, {})) return flat->size();
  const auto* const nodes = content<std::vector<Node>>(value_.node_, {});
  return nodes == nullptr ? 0 : nodes->size();
}

Value Array::at(std::size_t index) const {
  if (index >= size()) throw std::logic_error{"json::Array: the index is beyond the end"};
  if (auto* const nodes = content<std::vector<Node>>(value_.node_, {}))
    return Value{value_.reading_, &(*nodes)[index]};
  return Value{value_.reading_, value_.node_, index};
}

std::span<const double> Array::numbers(std::optional<std::size_t> count) const {
  if (value_.node_ == nullptr) return {};
  const auto* const flat = content<std::vector<double>>(value_.node_, {});
  if (flat == nullptr) {
    for (std::size_t i = 0; i < size(); ++i) at(i).number();
    return {};
  }
  if (!count || *count == flat->size()) return *flat;
  if (!value_.reading_->problem)
    fail(Code::wrong_type,
         "found " + std::to_string(flat->size()) + " numbers; expected " + std::to_string(*count));
  return {};
}

std::vector<std::string> Array::strings() const {
  std::vector<std::string> list;
  list.reserve(size());
  for (std::size_t i = 0; i < size(); ++i) list.push_back(at(i).string());
  return list;
}

}  // namespace pentapost::json
