#include "pentapost/json/strict_reader.hpp"

#include "pentapost/json/node.hpp"

#include <utility>

namespace pentapost::json {

Document::Document(std::unique_ptr<Reading> reading) : reading_{std::move(reading)} {}
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;
Document::~Document() = default;

Result<Document> Document::parse(std::string_view text) {
  auto tree = parse_tree(text);
  if (!tree) return std::move(tree).error();
  return Document{std::make_unique<Reading>(Reading{.root = std::move(tree).value()})};
}

Value Document::root() const { return Value{reading_.get(), &reading_->root}; }
const std::optional<Problem>& Document::problem() const { return reading_->problem; }

}  // namespace pentapost::json
