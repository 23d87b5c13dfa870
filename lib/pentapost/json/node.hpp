#pragma once

#include "pentapost/core/result.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The tree behind json::Document; for the sources of this folder only.
namespace pentapost::json {

struct Member;
struct ObjectNode;

/// A JSON value. An array that holds numbers only (or nothing) is a flat vector. Move-only, and
/// small: a body can hold millions.
struct Node {
  std::variant<std::monostate, bool, double, std::string, std::vector<double>, std::vector<Node>,
               std::unique_ptr<ObjectNode>>
      value;
};

/// Sorted by key. Knows where its bytes are and what was asked for.
struct ObjectNode {
  std::vector<Member> members;
  std::size_t begin = 0, end = 0;         ///< bytes of the text, '{' to behind '}'
  std::vector<std::string> asked_absent;  ///< asked for, not there; for hints on misspelt keys
};

struct Member {
  std::string key;
  Node node;
  bool asked = false;
};

struct Reading {
  Node root;
  std::optional<Problem> problem = {};
};

/// What the object holds; nullptr: no node, or it is no object.
inline ObjectNode* object_of(const Node* node) {
  if (node == nullptr) return nullptr;
  const auto* const object = std::get_if<std::unique_ptr<ObjectNode>>(&node->value);
  return object == nullptr ? nullptr : object->get();
}

/// Parses a text into a tree; Problems are those of Document::parse.
Result<Node> parse_tree(std::string_view text);

/// A text for a message: in quotation marks, or its length where it is long.
std::string quoted(std::string_view text);

}  // namespace pentapost::json
