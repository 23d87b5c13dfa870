#include "pentapost/json/strict_reader.hpp"

#include "pentapost/core/number_text.hpp"
#include "pentapost/json/node.hpp"
#include "pentapost/machine/near_names.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pentapost::json {
namespace {

std::string list_of(std::span<const std::string_view> words) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) list += i + 1 == words.size() ? " or " : ", ";
    list += quoted(words[i]);
  }
  return list;
}

Member* find_member(Node* node, std::string_view key) {
  if (node == nullptr) return nullptr;
  auto& members = object_of(node)->members;
  const auto found =
      std::lower_bound(members.begin(), members.end(), key,
                       [](const Member& member, std::string_view k) { return member.key < k; });
  return found != members.end() && found->key == key ? &*found : nullptr;
}

/// The member, noted as asked for.
Member* ask_for(Node* node, std::string_view key) {
  if (node == nullptr) return nullptr;
  Member* const member = find_member(node, key);
  if (member != nullptr)
    member->asked = true;
  else
    object_of(node)->asked_absent.emplace_back(key);
  return member;
}

bool is_null_node(const Node& node) { return std::holds_alternative<std::monostate>(node.value); }

std::size_t index_in(const Value& value, std::span<const std::string_view> words) {
  if (!value.is_string()) {
    value.string();  // keeps wrong_type
    return 0;
  }
  const std::string word = value.string();
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  value.fail(Code::out_of_domain, "found " + quoted(word) + "; expected " + list_of(words));
  return 0;
}

Vec3 vector_of(const Value& value) {
  const auto numbers = value.array().numbers(3);
  return numbers.size() == 3 ? Vec3{numbers[0], numbers[1], numbers[2]} : Vec3{Vec3::Zero()};
}

}  // namespace

bool Object::has(std::string_view key) const {
  const Member* const member = find_member(value_.node_, key);
  return member != nullptr && !is_null_node(member->node);
}

std::vector<std::string> Object::keys() const {
  std::vector<std::string> names;
  if (value_.node_ == nullptr) return names;
  for (const auto& member : object_of(value_.node_)->members) names.push_back(member.key);
  return names;
}

Value Object::value(std::string_view key) const {
  if (Member* const member = ask_for(value_.node_, key))
    return Value{value_.reading_, &member->node};
  if (value_.node_ != nullptr && !value_.reading_->problem)
    value_.reading_->problem = Problem{.code = Code::missing_key,
                                       .message = "the key " + quoted(key) + " is missing",
                                       .pointer = pointer() + pointer_step(key)};
  return Value{value_.reading_, nullptr};
}

std::optional<Value> Object::optional_value(std::string_view key) const {
  Member* const member = ask_for(value_.node_, key);
  if (member == nullptr || is_null_node(member->node)) return std::nullopt;
  return Value{value_.reading_, &member->node};
}

bool Object::boolean(std::string_view key) const { return value(key).boolean(); }
double Object::number(std::string_view key, Domain domain) const {
  return value(key).number(domain);
}
std::int64_t Object::integer(std::string_view key, std::int64_t lower, std::int64_t upper) const {
  return value(key).integer(lower, upper);
}
std::string Object::string(std::string_view key) const { return value(key).string(); }
std::string Object::take_string(std::string_view key) const { return value(key).take_string(); }
Array Object::array(std::string_view key) const { return value(key).array(); }
Object Object::object(std::string_view key) const { return value(key).object(); }

std::optional<bool> Object::optional_boolean(std::string_view key) const {
  const auto found = optional_value(key);
  return found ? std::optional{found->boolean()} : std::nullopt;
}
std::optional<double> Object::optional_number(std::string_view key, Domain domain) const {
  const auto found = optional_value(key);
  return found ? std::optional{found->number(domain)} : std::nullopt;
}
std::optional<std::int64_t> Object::optional_integer(std::string_view key, std::int64_t lower,
                                                     std::int64_t upper) const {
  const auto found = optional_value(key);
  return found ? std::optional{found->integer(lower, upper)} : std::nullopt;
}
std::optional<std::string> Object::optional_string(std::string_view key) const {
  const auto found = optional_value(key);
  return found ? std::optional{found->string()} : std::nullopt;
}
std::optional<Array> Object::optional_array(std::string_view key) const {
  const auto found = optional_value(key);
  return found ? std::optional{found->array()} : std::nullopt;
}
std::optional<Object> Object::optional_object(std::string_view key) const {
  const auto found = optional_value(key);
  return found ? std::optional{found->object()} : std::nullopt;
}

std::size_t Object::choice(std::string_view key, std::span<const std::string_view> words) const {
  return index_in(value(key), words);
}
std::optional<std::size_t> Object::optional_choice(std::string_view key,
                                                   std::span<const std::string_view> words) const {
  const auto found = optional_value(key);
  return found ? std::optional{index_in(*found, words)} : std::nullopt;
}
Vec3 Object::vector3(std::string_view key) const { return vector_of(value(key)); }
std::optional<Vec3> Object::optional_vector3(std::string_view key) const {
  const auto found = optional_value(key);
  return found ? std::optional{vector_of(*found)} : std::nullopt;
}

std::optional<Range<double>> Object::optional_range(std::string_view key, Code reversed) const {
  const auto found = optional_value(key);
  if (!found) return std::nullopt;
  const auto bounds = found->array().numbers(2);
  if (bounds.size() != 2) return std::nullopt;
  if (bounds[0] < bounds[1]) return Range<double>{bounds[0], bounds[1]};
  found->fail(reversed, "found [" + number_text(bounds[0]) + ", " + number_text(bounds[1]) +
                            "]; expected a lower and a greater upper bound");
  return std::nullopt;
}

void Object::finish() const {
  if (value_.node_ == nullptr || value_.reading_->problem) return;
  const auto& object = *object_of(value_.node_);
  for (const auto& member : object.members) {
    if (member.asked) continue;
    const auto near = machine::near_names(member.key, object.asked_absent);
    std::string message = "the key " + quoted(member.key) + " is not known here";
    if (!near.empty()) message += "; did you mean " + quoted(near.front()) + "?";
    fail_at(member.key, Code::unknown_key, std::move(message));
    return;
  }
}

void Object::fail_at(std::string_view key, Code code, std::string message) const {
  if (Member* const member = find_member(value_.node_, key))
    Value{value_.reading_, &member->node}.fail(code, std::move(message));
  else
    fail(code, std::move(message));
}

std::string_view Object::text_in(std::string_view source) const {
  if (value_.node_ == nullptr) return {};
  const auto& object = *object_of(value_.node_);
  if (object.end > source.size())
    throw std::logic_error{"json::Object: this is not the text that was parsed"};
  return source.substr(object.begin, object.end - object.begin);
}

}  // namespace pentapost::json
