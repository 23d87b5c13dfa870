#pragma once

#include "pentapost/core/result.hpp"
#include "pentapost/core/units.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Strict reading of JSON: what is not asked for, of the wrong type or out of its domain is a
/// Problem that names the RFC 6901 pointer. The only way from JSON text to structs.
///
///     auto document = json::Document::parse(body);
///     if (!document) return document.error();
///     auto job = document->object();
///     const double tip_mm = job.optional_number("tip_mm",
///     json::Domain::positive()).value_or(0.01); auto setup = job.optional_object("setup");
///     ...
///     job.finish();                                   // keys that nobody asked for
///     if (document->problem()) return *document->problem();
///
/// The first failure is kept; after it every getter goes on giving empty values (0, "", no
/// elements), so that a reader checks once, at its end. Views live as long as their Document, which
/// may be moved.
namespace pentapost::json {

struct Node;
struct Reading;  // the document's tree and its first Problem
class Array;
class Object;

/// Which numbers are allowed. They are finite in any case.
struct Domain {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;  ///< `lower` itself is not allowed

  static constexpr Domain any() { return {}; }
  static constexpr Domain positive() { return {.lower = 0.0, .lower_open = true}; }
  static constexpr Domain not_negative() { return {.lower = 0.0}; }
  static constexpr Domain between(double lower, double upper) { return {lower, upper}; }

  bool contains(double value) const {
    return (lower_open ? lower < value : lower <= value) && value <= upper;
  }
};

/// One step of a JSON pointer, escaped as RFC 6901 asks, with the slash before it.
std::string pointer_step(std::string_view key);

/// View of any JSON value.
class Value {
 public:
  bool is_null() const;
  bool is_boolean() const;
  bool is_number() const;
  bool is_string() const;
  bool is_array() const;
  bool is_object() const;

  bool boolean() const;
  double number(Domain domain = {}) const;
  /// A number without a fraction (3.0 is one); the bounds are included.
  std::int64_t integer(std::int64_t lower, std::int64_t upper) const;
  std::string string() const;
  std::string take_string() const;  ///< moves the text out of the document: for big ones, once
  Array array() const;
  Object object() const;

  /// Keeps a Problem at this place, unless there is one already.
  void fail(Code code, std::string message) const;
  std::string pointer() const;  ///< RFC 6901; walks the document

 private:
  friend class Array;
  friend class Object;
  friend class Document;
  Value(Reading* reading, Node* node, std::optional<std::size_t> element = std::nullopt)
      : reading_{reading}, node_{node}, element_{element} {}
  void expected(std::string_view what) const;
  std::string found() const;
  Reading* reading_;
  Node* node_;                          ///< nullptr: missing, and the Problem is kept
  std::optional<std::size_t> element_;  ///< element of an array of numbers, which has no nodes
};

/// View of an array.
class Array {
 public:
  std::size_t size() const;
  /// @param index  below size(), otherwise std::logic_error.
  Value at(std::size_t index) const;
  /// All elements as numbers, without a copy; empty after a failure.
  /// @param count  how many there must be; nullopt: any number.
  std::span<const double> numbers(std::optional<std::size_t> count = std::nullopt) const;
  std::vector<std::string> strings() const;
  void fail(Code code, std::string message) const { value_.fail(code, std::move(message)); }

 private:
  friend class Value;
  explicit Array(Value value) : value_{value} {}
  Value value_;
};

/// View of an object. Notes in the document which keys were asked for. `optional_` getters take a
/// missing key and null as none; the others keep missing_key, at the place where it would stand.
class Object {
 public:
  bool has(std::string_view key) const;   ///< there and not null; does not count as asked for
  std::vector<std::string> keys() const;  ///< all of them, sorted; for maps

  Value value(std::string_view key) const;
  std::optional<Value> optional_value(std::string_view key) const;
  bool boolean(std::string_view key) const;
  std::optional<bool> optional_boolean(std::string_view key) const;
  double number(std::string_view key, Domain domain = {}) const;
  std::optional<double> optional_number(std::string_view key, Domain domain = {}) const;
  std::int64_t integer(std::string_view key, std::int64_t lower, std::int64_t upper) const;
  std::optional<std::int64_t> optional_integer(std::string_view key, std::int64_t lower,
                                               std::int64_t upper) const;
  std::string string(std::string_view key) const;
  std::optional<std::string> optional_string(std::string_view key) const;
  std::string take_string(std::string_view key) const;  ///< see Value::take_string
  /// Index of the string in `words`; 0 after a failure.
  std::size_t choice(std::string_view key, std::span<const std::string_view> words) const;
  std::optional<std::size_t> optional_choice(std::string_view key,
                                             std::span<const std::string_view> words) const;
  /// Three numbers; a zero vector after a failure.
  Vec3 vector3(std::string_view key) const;
  std::optional<Vec3> optional_vector3(std::string_view key) const;
  /// [lower, upper] with lower < upper.
  /// @param reversed  the code where it is not so.
  std::optional<Range<double>> optional_range(std::string_view key,
                                              Code reversed = Code::out_of_domain) const;
  Array array(std::string_view key) const;
  std::optional<Array> optional_array(std::string_view key) const;
  Object object(std::string_view key) const;
  std::optional<Object> optional_object(std::string_view key) const;

  /// Keeps unknown_key for a key that nobody asked for, with near known ones.
  void finish() const;
  void fail(Code code, std::string message) const { value_.fail(code, std::move(message)); }
  /// Keeps a Problem at the value of `key`, or at the object where it has none.
  void fail_at(std::string_view key, Code code, std::string message) const;
  std::string pointer() const { return value_.pointer(); }
  /// The object's own bytes.
  /// @param source  the text that was parsed.
  std::string_view text_in(std::string_view source) const;

 private:
  friend class Value;
  explicit Object(Value value) : value_{value} {}
  Value value_;
};

/// A parsed JSON text. Move-only.
class Document {
 public:
  static constexpr std::size_t max_depth = 64;
  // These bound the memory that a text can cost.
  static constexpr std::size_t max_values = 5'000'000;    ///< other than numbers in arrays of them
  static constexpr std::size_t max_numbers = 40'000'000;  ///< in arrays of numbers
  static constexpr std::size_t max_key_bytes = 1000;      ///< keys come back in pointers

  /// @return Problem bad_json (with line and column) where the text is not JSON in UTF-8, a key
  ///         stands twice in an object, or values nest deeper than max_depth; bad_number where a
  ///         number overflows; too_large beyond
  ///         max_values, max_numbers or max_key_bytes.
  static Result<Document> parse(std::string_view text);

  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;
  ~Document();

  Value root() const;
  Object object() const { return root().object(); }  ///< the root, which must be an object
  const std::optional<Problem>& problem() const;     ///< the first failure of reading

 private:
  explicit Document(std::unique_ptr<Reading> reading);
  std::unique_ptr<Reading> reading_;
};

}  // namespace pentapost::json
