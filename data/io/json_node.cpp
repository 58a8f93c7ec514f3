// The only fence of nlohmann-json below report/.

#include "data/io/json_node.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "data/io/file_guard.h"

namespace thenar {
namespace {

using PlainJson = nlohmann::json;         // members in alphabetic order
using FileJson = nlohmann::ordered_json;  // members as they were added
constexpr int kMaxMisspelling = 2;   // largest number of letters by which a misspelt key differs
constexpr double kMaxNumber = 1e12;  // largest number; beyond it wrenches lose all digits
constexpr std::size_t kLongestShown = 60;    // Most characters of a value in a message
constexpr double kLargestWhole = 1LL << 53;  // Largest whole number up to which a double is exact

/// Reader of a text's tokens, as the parser reports them, that counts lines.
class TokenLines {
 public:
  TokenLines(const std::string& text, int first_line) : text_(text), line_(first_line) {
    if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) at_ = 3;  // a mark of UTF-8
  }

  /// Line on which the next token starts.
  int next() {
    for (; at_ < text_.size() && std::string_view(" \t\r\n,:").find(text_[at_]) != kNotFound; ++at_)
      if (text_[at_] == '\n') ++line_;
    skip_token();
    return line_;
  }

 private:
  static constexpr std::size_t kNotFound = std::string_view::npos;

  void skip_token() {
    if (at_ >= text_.size()) return;
    const char first = text_[at_];
    if (first == '"') {
      for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
        if (text_[at_] == '\\') ++at_;
      ++at_;
    } else if (std::string_view("{}[]").find(first) != kNotFound) {
      ++at_;
    } else {
      at_ = std::min(text_.find_first_of(" \t\r\n,]}", at_), text_.size());
    }
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_;
};

/// nlohmann's words without its own prefix: "[json.exception.parse_error.101] ...: ".
std::string plain_words(const std::string& message) {
  const std::size_t start = message.find("syntax error");
  return start == std::string::npos ? message.substr(message.find("] ") + 2)
                                    : message.substr(start);
}

/// Builds the tree from the parser's events, and refuses members that stand twice in an object:
/// which one was meant?
class TreeBuilder : public nlohmann::json_sax<PlainJson> {
 public:
  TreeBuilder(const std::string& path, const std::string& text, int first_line)
      : path_(path), text_(text), first_line_(first_line), lines_(text, first_line) {}

  JsonNode root;

  bool null() override { return add(JsonNode()); }
  bool boolean(bool value) override { return add(JsonNode(value)); }
  bool number_integer(number_integer_t value) override { return add_whole(value); }
  bool number_unsigned(number_unsigned_t value) override { return add_whole(value); }
  bool number_float(number_float_t value, const string_t& /*text*/) override {
    return add(JsonNode(value));
  }
  bool string(string_t& value) override { return add(JsonNode(std::move(value))); }
  bool binary(binary_t& /*value*/) override { return false; }  // no such thing in texts

  bool start_object(std::size_t /*size*/) override { return open(JsonKind::kObject); }
  bool start_array(std::size_t /*size*/) override { return open(JsonKind::kArray); }
  bool end_object() override {
    met_.pop_back();
    return close();
  }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    const int line = lines_.next();
    if (!met_.back().insert(name).second)
      throw DataError(path_, line, fmt::format("'{}' is given twice", name));
    open_.back()->names.push_back(std::move(name));
    return true;
  }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const PlainJson::exception& error) override {
    // A number that is too large is a whole token; all else ends at the byte that is wrong.
    const bool syntax = dynamic_cast<const PlainJson::parse_error*>(&error) != nullptr;
    const int line =
        syntax ? first_line_ - 1 + line_of_offset(text_, static_cast<std::ptrdiff_t>(position) - 1)
               : lines_.next();
    throw DataError(path_, line, "wanted JSON: " + plain_words(error.what()));
  }

 private:
  template <typename Integer>
  bool add_whole(Integer value) {
    JsonNode node(static_cast<double>(value));
    node.whole = true;
    return add(std::move(node));
  }

  bool add(JsonNode node) {
    node.line = lines_.next();
    if (open_.empty())
      root = std::move(node);
    else
      open_.back()->items.push_back(std::move(node));
    return true;
  }

  bool open(JsonKind kind) {
    add(JsonNode(kind));
    open_.push_back(open_.empty() ? &root : &open_.back()->items.back());
    if (kind == JsonKind::kObject) met_.emplace_back();
    return true;
  }

  bool close() {
    (void)lines_.next();
    open_.pop_back();
    return true;
  }

  const std::string& path_;
  const std::string& text_;
  int first_line_;
  TokenLines lines_;
  std::vector<JsonNode*> open_;             // from the root to where values are added
  std::vector<std::set<std::string>> met_;  // names of members of each open object
};

/// Converts a tree to nlohmann's type.
template <typename Json>
Json fence_json(const JsonNode& node) {  // NOLINT(misc-no-recursion): as deep as the tree
  if (node.kind == JsonKind::kNull) return Json();
  if (node.kind == JsonKind::kFlag) return Json(node.flag);
  if (node.kind == JsonKind::kText) return Json(node.text);
  if (node.kind == JsonKind::kNumber) {
    if (!std::isfinite(node.number)) return Json();
    if (node.whole && std::abs(node.number) < kLargestWhole)
      return Json(static_cast<std::int64_t>(node.number));
    return Json(node.number);
  }
  // Lists and objects are translated entry by entry; members keep their order.
  const bool list = node.kind == JsonKind::kArray;
  Json json = list ? Json::array() : Json::object();
  for (std::size_t i = 0; i < node.items.size(); ++i)
    if (list)
      json.push_back(fence_json<Json>(node.items[i]));
    else
      json.emplace(node.names[i], fence_json<Json>(node.items[i]));
  return json;
}

template <typename Json>
std::string dumped(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

const JsonNode* JsonNode::find(const std::string& name) const {
  const auto at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? nullptr : &items[at - names.begin()];
}

JsonNode* JsonNode::find(const std::string& name) {
  return const_cast<JsonNode*>(std::as_const(*this).find(name));
}

JsonNode& JsonNode::member(const std::string& name) {
  if (kind == JsonKind::kNull) kind = JsonKind::kObject;
  if (JsonNode* found = find(name)) return *found;
  names.push_back(name);
  return items.emplace_back();
}

void JsonNode::erase(const std::string& name) {
  const int at = place_in(names, name);
  if (at < 0) return;
  items.erase(items.begin() + at);
  names.erase(names.begin() + at);
}

bool operator==(const JsonNode& a, const JsonNode& b) {
  return canonical_text(a) == canonical_text(b);
}
bool operator!=(const JsonNode& a, const JsonNode& b) { return !(a == b); }

JsonNode parse_json(const std::string& path, const std::string& text, int first_line) {
  guard_text(text, path, GuardedKind::kJson, first_line);
  TreeBuilder builder(path, text, first_line);
  (void)PlainJson::sax_parse(text, &builder);
  return std::move(builder.root);
}

std::map<std::string, std::vector<std::string>> text_members(
    const JsonNode& root, const std::vector<std::string>& steps) {
  // Follow the path to the object; without it there are no members.
  const JsonNode* object = &root;
  for (const std::string& step : steps)
    if ((object = object->find(step)) == nullptr) return {};
  // Texts, and lists of texts.
  std::map<std::string, std::vector<std::string>> members;
  for (std::size_t i = 0; i < object->names.size(); ++i) {
    const JsonNode& member = object->items[i];
    if (member.kind == JsonKind::kText) members[object->names[i]] = {member.text};
    const auto is_text = [](const JsonNode& entry) { return entry.kind == JsonKind::kText; };
    if (member.kind == JsonKind::kArray && all_of(member.items, is_text))
      members[object->names[i]] =
          transformed(member.items, [](const JsonNode& entry) { return entry.text; });
  }
  return members;
}

std::string written(const JsonNode& node, int indent) {
  return dumped(fence_json<FileJson>(node), indent);
}

std::string canonical_text(const JsonNode& node) { return dumped(fence_json<PlainJson>(node), -1); }

void JsonValue::fail(const std::string& complaint) const {
  throw DataError(path_, node_.line, complaint);
}

void JsonValue::fail_wanted(const std::string& what) const {
  std::string came = canonical_text(node_);
  if (came.size() > kLongestShown) came = came.substr(0, kLongestShown) + "...";
  fail(fmt::format("wanted {}{}, got {}", what, steps_.empty() ? "" : " as " + name(), came));
}

bool JsonValue::gives(const std::string& member) const {
  const JsonNode* found = node_.find(member);
  return found != nullptr && found->kind != JsonKind::kNull;
}

JsonValue JsonValue::operator[](const std::string& member) const {
  const JsonNode* found = node_.find(member);
  if (found == nullptr) fail(fmt::format("{} has no '{}'", name(), member));
  return step(*found, member);
}

std::vector<JsonValue> JsonValue::entries(const std::string& what) const {
  if (node_.kind != JsonKind::kArray) fail_wanted(what);
  std::vector<JsonValue> result;
  for (std::size_t i = 0; i < node_.items.size(); ++i)
    result.push_back(step(node_.items[i], std::to_string(i)));
  return result;
}

std::size_t JsonValue::size() const {
  return node_.kind == JsonKind::kArray ? node_.items.size() : 0;
}

std::vector<std::string> JsonValue::others_than(const std::vector<std::string>& known) const {
  if (node_.kind != JsonKind::kObject) fail_wanted("an object");
  std::vector<std::string> others;
  for (std::size_t i = 0; i < node_.names.size(); ++i) {
    const std::string& member = node_.names[i];
    if (contains(known, member)) continue;
    // A name that is one or two letters off is a misspelt key, not a member of the user's own.
    for (const std::string& meant : known)
      if (edit_distance(member, meant) <= kMaxMisspelling &&
          meant.size() > std::size_t{2} * kMaxMisspelling)
        step(node_.items[i], member)
            .fail(fmt::format("{} knows no '{}', did you mean '{}'?", name(), member, meant));
    others.push_back(member);
  }
  return others;
}

double JsonValue::number(const std::string& what) const {
  if (node_.kind != JsonKind::kNumber) fail_wanted(what);
  return bounded(node_.number);
}

std::vector<double> JsonValue::numbers(std::size_t count) const {
  const std::string what = fmt::format("{} numbers", count);
  if (size() != count) fail_wanted(what);
  std::vector<double> result;
  for (const JsonNode& item : node_.items) {
    if (item.kind != JsonKind::kNumber) fail_wanted(what);
    result.push_back(bounded(item.number));
  }
  return result;
}

int JsonValue::count() const {
  constexpr int kMaxCount = 1000000000;  // largest count [1]
  if (node_.kind != JsonKind::kNumber || !node_.whole || node_.number < 0 ||
      node_.number > kMaxCount)
    fail_wanted(fmt::format("an integer of 0 to {}", kMaxCount));
  return static_cast<int>(node_.number);
}

double JsonValue::bounded(double number) const {
  if (!(std::abs(number) <= kMaxNumber)) fail_wanted(fmt::format("no more than {:g}", kMaxNumber));
  return number;
}

JsonValue JsonValue::step(const JsonNode& node, const std::string& to) const {
  JsonValue value(path_, node);
  value.steps_ = steps_;
  value.steps_.push_back(to);
  return value;
}

std::string JsonValue::name() const {
  return steps_.empty() ? "the file" : fmt::format("{}", fmt::join(steps_, "."));
}

}  // namespace thenar
