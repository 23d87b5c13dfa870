#include "pentapost/json/node.hpp"
#include "pentapost/json/strict_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace pentapost::json {
namespace {

constexpr std::string_view whole_text;  ///< JSON pointer of the root

/// Walks over the text and tells the handler how far the lexer has read.
class TrackedIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TrackedIterator(const char* at, const char** reached) : at_{at}, reached_{reached} {}
  reference operator*() const { return *at_; }
  TrackedIterator& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  TrackedIterator operator++(int) {
    const TrackedIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const TrackedIterator& other) const { return at_ == other.at_; }
  bool operator!=(const TrackedIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** reached_;
};

/// "line 3, column 7" of a byte.
std::string place_of(std::string_view text, std::size_t offset) {
  const auto before = text.substr(0, std::min(offset, text.size()));
  const auto lines = std::count(before.begin(), before.end(), '\n');
  const auto last_break = before.rfind('\n');
  const auto column =
      last_break == std::string_view::npos ? before.size() : before.size() - last_break - 1;
  return "line " + std::to_string(lines + 1) + ", column " +
         std::to_string(std::max<std::size_t>(column, 1));
}

/// What the parser found wrong, without its prefix and without the text it read, which may be long
/// or not UTF-8.
std::string reason_of(std::string_view what) {
  if (const auto prefix = what.find(": "); prefix != std::string_view::npos)
    what.remove_prefix(prefix + 2);
  if (const auto last_read = what.find("; last read:"); last_read != std::string_view::npos) {
    const auto expected = what.find("; expected", last_read);
    const std::string tail{expected == std::string_view::npos ? "" : what.substr(expected)};
    return std::string{what.substr(0, last_read)} + tail;
  }
  return std::string{what.substr(0, 200)};
}

/// Builds the tree from the parser's events and stops at the first thing that is not allowed.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, const char* const* reached) : text_{text}, reached_{reached} {}

  bool null() { return add_node({}); }
  bool boolean(bool value) { return add_node({value}); }
  bool number_integer(std::int64_t value) { return number(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<double>(value)); }
  bool number_float(double value, const std::string&) { return number(value); }
  bool string(std::string& value) { return add_node({std::move(value)}); }
  bool binary(nlohmann::json::binary_t&) {
    return fail(Code::bad_json, "binary values are not JSON");
  }

  bool start_object(std::size_t) {
    auto object = std::make_unique<ObjectNode>();
    object->begin = reached_offset() - 1;
    return open({std::move(object)});
  }
  bool key(std::string& name) {
    key_.clear();
    if (name.size() > Document::max_key_bytes)
      return fail(Code::too_large,
                  "a key is longer than " + std::to_string(Document::max_key_bytes) + " bytes");
    key_ = std::move(name);
    return true;
  }
  bool end_object() {
    auto& object = *std::get<std::unique_ptr<ObjectNode>>(open_.back().node.value);
    object.end = reached_offset();
    std::sort(object.members.begin(), object.members.end(),
              [](const Member& x, const Member& y) { return x.key < y.key; });
    const auto twice =
        std::adjacent_find(object.members.begin(), object.members.end(),
                           [](const Member& x, const Member& y) { return x.key == y.key; });
    if (twice != object.members.end()) {
      key_ = twice->key;
      return fail(Code::bad_json, "the key stands twice in its object");
    }
    return close();
  }
  bool start_array(std::size_t) { return open({std::vector<double>{}}); }
  bool end_array() { return close(); }

  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) {
    if (error.id == number_overflow) return fail(Code::bad_number, "the number is not finite");
    if (!problem_)
      problem_ = Problem{
          .code = Code::bad_json,
          .message = "not JSON at " + place_of(text_, position) + ": " + reason_of(error.what()),
          .pointer = std::string{whole_text}};
    return false;
  }

  Result<Node> take() && {
    if (problem_) return *std::move(problem_);
    return Result<Node>{std::move(root_)};
  }

 private:
  static constexpr int number_overflow = 406;  ///< id of the parser's out_of_range exception

  struct Open {
    Node node;
    std::string key;  ///< under which it will stand, if its parent is an object
  };

  std::size_t reached_offset() const { return static_cast<std::size_t>(*reached_ - text_.data()); }

  /// The array that takes numbers without nodes, if the innermost open value is one.
  std::vector<double>* flat_array() {
    return open_.empty() ? nullptr : std::get_if<std::vector<double>>(&open_.back().node.value);
  }

  bool number(double value) {
    auto* const flat = flat_array();
    if (flat == nullptr) return add_node({value});
    if (++numbers_ > Document::max_numbers)
      return fail(Code::too_large,
                  "the text holds more than " + std::to_string(Document::max_numbers) + " numbers");
    flat->push_back(value);
    return true;
  }

  bool count_values(std::size_t count) {
    values_ += count;
    return values_ <= Document::max_values ||
           fail(Code::too_large,
                "the text holds more than " + std::to_string(Document::max_values) + " values");
  }

  bool add_node(Node node) {
    if (!count_values(1)) return false;
    return attach(std::move(node), std::move(key_));
  }

  bool attach(Node node, std::string key) {
    if (open_.empty()) {
      root_ = std::move(node);
      return true;
    }
    auto& parent = open_.back().node.value;
    if (auto* const object = std::get_if<std::unique_ptr<ObjectNode>>(&parent)) {
      (*object)->members.push_back({std::move(key), std::move(node)});
      return true;
    }
    if (const auto* const flat = std::get_if<std::vector<double>>(&parent)) {
      if (!count_values(flat->size())) return false;
      std::vector<Node> nodes;
      nodes.reserve(flat->size() + 1);
      for (const double element : *flat) nodes.push_back({element});
      parent = std::move(nodes);
    }
    std::get<std::vector<Node>>(parent).push_back(std::move(node));
    return true;
  }

  bool open(Node node) {
    if (!count_values(1)) return false;
    if (open_.size() >= Document::max_depth)
      return fail(Code::bad_json,
                  "values nest deeper than " + std::to_string(Document::max_depth) + " levels");
    open_.push_back({std::move(node), std::move(key_)});
    return true;
  }

  bool close() {
    auto closed = std::move(open_.back());
    open_.pop_back();
    return attach(std::move(closed.node), std::move(closed.key));
  }

  bool fail(Code code, std::string message) {
    if (!problem_)
      problem_ =
          Problem{.code = code,
                  .message = std::move(message) + " (" + place_of(text_, reached_offset()) + ")",
                  .pointer = pointer()};
    return false;
  }

  /// Pointer of the value that is being read.
  std::string pointer() const {
    std::string pointer;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const auto& container = open_[i].node.value;
      if (std::holds_alternative<std::unique_ptr<ObjectNode>>(container)) {
        pointer += pointer_step(i + 1 < open_.size() ? open_[i + 1].key : key_);
      } else if (const auto* const nodes = std::get_if<std::vector<Node>>(&container)) {
        pointer += pointer_step(std::to_string(nodes->size()));
      } else {
        pointer += pointer_step(std::to_string(std::get<std::vector<double>>(container).size()));
      }
    }
    return pointer;
  }

  std::string_view text_;
  const char* const* reached_;
  std::vector<Open> open_;
  std::string key_;
  Node root_;
  std::size_t values_ = 0;   ///< nodes
  std::size_t numbers_ = 0;  ///< in flat arrays
  std::optional<Problem> problem_;
};

}  // namespace

Result<Node> parse_tree(std::string_view text) {
  const char* reached = text.data();
  TreeBuilder builder{text, &reached};
  const TrackedIterator begin{text.data(), &reached};
  const TrackedIterator end{text.data() + text.size(), &reached};
  const bool complete = nlohmann::json::sax_parse(begin, end, &builder);
  auto tree = std::move(builder).take();
  if (!complete && tree) throw std::logic_error{"parse_tree: the parser stopped without a reason"};
  return tree;
}

}  // namespace pentapost::json
