#pragma once

/// JSON as a plain tree that remembers line numbers: read strictly, checked with messages, written.

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace thenar {

/// Kind of a JSON value.
enum class JsonKind { kNull, kFlag, kNumber, kText, kArray, kObject };

/// One value, with everything below it.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the tree
struct JsonNode {
  JsonKind kind = JsonKind::kNull;
  int line = 1;                    // line on which the value starts, from 1
  bool flag = false;               // value of kFlag
  bool whole = false;              // kNumber without point and exponent, of 64 bits at most
  double number = 0;               // value of kNumber; not finite: written as null
  std::string text;                // value of kText
  std::vector<JsonNode> items;     // entries of kArray, or values of kObject
  std::vector<std::string> names;  // member names of kObject, one for each of `items`

  JsonNode() = default;
  explicit JsonNode(JsonKind its_kind) : kind(its_kind) {}
  explicit JsonNode(bool value) : kind(JsonKind::kFlag), flag(value) {}
  explicit JsonNode(int value) : kind(JsonKind::kNumber), whole(true), number(value) {}
  explicit JsonNode(unsigned value) : kind(JsonKind::kNumber), whole(true), number(value) {}
  explicit JsonNode(double value) : kind(JsonKind::kNumber), number(value) {}
  explicit JsonNode(std::string value) : kind(JsonKind::kText), text(std::move(value)) {}
  explicit JsonNode(const char* value) : JsonNode(std::string(value)) {}
  /// A list of numbers or texts.
  template <typename Value>
  explicit JsonNode(const std::vector<Value>& values) : kind(JsonKind::kArray) {
    for (const Value& value : values) items.emplace_back(value);
  }

  /// Returns the member of that name; null if there is none, or if this is no object.
  [[nodiscard]] const JsonNode* find(const std::string& name) const;
  [[nodiscard]] JsonNode* find(const std::string& name);
  /// Adds a member, or gives the one of that name another value; a null becomes an object.
  template <typename Value>
  JsonNode& set(const std::string& name, Value&& value) {
    member(name) = JsonNode(std::forward<Value>(value));
    return *this;
  }
  void erase(const std::string& name);

 private:
  JsonNode& member(const std::string& name);
};

/// Compare two trees by their values. The order of members, and
/// lines, do not count.
[[nodiscard]] bool operator==(const JsonNode& a, const JsonNode& b);
[[nodiscard]] bool operator!=(const JsonNode& a, const JsonNode& b);

/// Parses strictly: no repeated members, no NaN or infinite numbers, no comments; within the limits
/// of data/io/file_guard.h.
/// @param first_line  number of the text's first line
/// @throws DataError `path:line: ...` saying what was wanted and what came.
[[nodiscard]] JsonNode parse_json(const std::string& path, const std::string& text,
                                  int first_line = 1);

/// Returns the members of the object at the end of `steps` that are a text, or a list of nothing
/// but texts; none if there is no object there.
/// @param steps  names of members from the root
[[nodiscard]] std::map<std::string, std::vector<std::string>> text_members(
    const JsonNode& root, const std::vector<std::string>& steps);

/// Returns the tree as the text of a file. Bytes that are not UTF-8 become U+FFFD.
/// @param indent  blanks a level; -1: all on one line
[[nodiscard]] std::string written(const JsonNode& node, int indent = -1);

/// Returns the text that checksums are of: on one line, members in alphabetic order.
[[nodiscard]] std::string canonical_text(const JsonNode& node);

/// A value of a file with the way to it: takes what is wanted, or says what came instead.
/// Holds references to the path and the node.
class JsonValue {
 public:
  JsonValue(const std::string& path, const JsonNode& root) : path_(path), node_(root) {}

  /// @throws DataError `path:line: complaint`, always
  [[noreturn]] void fail(const std::string& complaint) const;
  /// @throws DataError "wanted WHAT as contacts.0.friction, got -1", always
  [[noreturn]] void fail_wanted(const std::string& what) const;

  /// Returns whether it has a member that is not null.
  [[nodiscard]] bool gives(const std::string& member) const;
  /// Returns a member. @throws DataError if there is none.
  [[nodiscard]] JsonValue operator[](const std::string& member) const;
  /// Returns the entries of a list. @throws DataError, as wanting `what`, if it is none.
  [[nodiscard]] std::vector<JsonValue> entries(const std::string& what) const;
  /// Returns the number of entries; 0 if it is no list.
  [[nodiscard]] std::size_t size() const;
  /// Names of members that are none of `known`.
  /// @throws DataError if it is no object, or for a name that looks like a known one misspelt.
  [[nodiscard]] std::vector<std::string> others_than(const std::vector<std::string>& known) const;

  /// Returns a number of at most 1e12. @throws DataError, as wanting `what`, otherwise.
  [[nodiscard]] double number(const std::string& what) const;
  /// Returns `count` numbers of at most 1e12 each. @throws DataError otherwise.
  [[nodiscard]] std::vector<double> numbers(std::size_t count) const;
  /// Returns a whole number from 0 to 1e9. @throws DataError otherwise.
  [[nodiscard]] int count() const;

 private:
  [[nodiscard]] JsonValue step(const JsonNode& node, const std::string& to) const;
  [[nodiscard]] std::string name() const;
  [[nodiscard]] double bounded(double number) const;

  const std::string& path_;
  const JsonNode& node_;
  std::vector<std::string> steps_;  // names of members, numbers of entries
};

}  // namespace thenar
