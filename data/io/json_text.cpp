#include "data/io/json_text.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "data/io/file_guard.h"

namespace thenar {
namespace {

using PlainJson = nlohmann::json;

int line_at(const std::string& text, std::size_t position) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(position, text.size()));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

/// Walks over a text that is known to be JSON.
class Walk {
 public:
  explicit Walk(const std::string& text) : text_(text) { skip_blanks(); }

  [[nodiscard]] std::size_t position() const { return at_; }

  /// Goes to a member or an entry of the value it stands at; false: there is none.
  bool enter(const std::string& step) {
    const char kind = text_[at_];
    if (kind != '{' && kind != '[') return false;
    forward();
    for (int entry = 0; text_[at_] != '}' && text_[at_] != ']'; ++entry) {
      const std::string name = kind == '{' ? member() : std::to_string(entry);
      if (name == step) return true;
      skip_value();
      if (text_[at_] == ',') forward();
    }
    return false;
  }

 private:
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size() - 1); }

  void forward() {
    ++at_;
    skip_blanks();
  }

  std::string quoted() {
    const std::size_t start = at_++;
    for (; text_[at_] != '"'; ++at_)
      if (text_[at_] == '\\') ++at_;
    forward();
    return text_.substr(start, text_.find_last_of('"', at_ - 1) + 1 - start);
  }

  std::string member() {
    const std::string name = PlainJson::parse(quoted()).get<std::string>();
    forward();  // the colon
    return name;
  }

  void skip_value() {
    int depth = 0;
    do {
      const char c = text_[at_];
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      if (c == '"')
        (void)quoted();
      else if (std::string("{}[],:").find(c) != std::string::npos)
        forward();
      else
        skip_word();
    } while (depth > 0);
  }

  void skip_word() {
    at_ = text_.find_first_of(" \t\r\n,]}", at_);
    skip_blanks();
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

/// Line of the n-th time a member of this name is written.
int line_of_member(const std::string& text, const std::string& name, int n) {
  const std::string quoted = PlainJson(name).dump();
  std::size_t at = text.find(quoted);
  while (--n > 0 && at != std::string::npos) at = text.find(quoted, at + 1);
  return line_at(text, at);
}

/// Refuses members that stand twice in an object: which one was meant?
class Strict {
 public:
  Strict(const std::string& path, const std::string& text, int before)
      : path_(path), text_(text), before_(before) {}

  bool operator()(int /*depth*/, PlainJson::parse_event_t event, const PlainJson& parsed) {
    if (event == PlainJson::parse_event_t::object_start) open_.emplace_back();
    if (event == PlainJson::parse_event_t::object_end) open_.pop_back();
    if (event != PlainJson::parse_event_t::key) return true;
    const auto name = parsed.get<std::string>();
    const int times = ++seen_[name];
    if (!open_.back().insert(name).second)
      throw DataError(path_, before_ + line_of_member(text_, name, times),
                      fmt::format("'{}' is given twice", name));
    return true;
  }

 private:
  const std::string& path_;
  const std::string& text_;
  int before_;  // lines before the text
  std::vector<std::set<std::string>> open_;
  std::map<std::string, int> seen_;
};

/// nlohmann's words without its own prefix: "[json.exception.parse_error.101] ...: ".
std::string plain(const std::string& message) {
  const std::size_t start = message.find("syntax error");
  return start == std::string::npos ? message.substr(message.find("] ") + 2)
                                    : message.substr(start);
}

/// A number too large for a double stands between quotes in the message.
int line_of_quoted(const std::string& text, const std::string& message) {
  const std::size_t from = message.find('\''), to = message.rfind('\'');
  if (from == to) return 1;
  return line_at(text, text.find(message.substr(from + 1, to - from - 1)));
}

}  // namespace

PlainJson parse_json(const std::string& path, const std::string& text, int first_line) {
  const int before = first_line - 1;
  guard_text(text, path, GuardedKind::kJson, first_line);
  try {
    const Strict strict(path, text, before);
    return PlainJson::parse(text, strict);
  } catch (const PlainJson::parse_error& e) {
    throw DataError(path, before + line_at(text, std::max<std::size_t>(e.byte, 1) - 1),
                    "wanted JSON: " + plain(e.what()));
  } catch (const PlainJson::exception& e) {
    throw DataError(path, before + line_of_quoted(text, e.what()),
                    "wanted JSON: " + plain(e.what()));
  }
}

int line_of(const std::string& text, const JsonPath& value) {
  Walk walk(text);
  std::size_t innermost = walk.position();
  for (const std::string& step : value) {
    if (!walk.enter(step)) break;
    innermost = walk.position();
  }
  return line_at(text, innermost);
}

std::map<std::string, std::vector<std::string>> text_members(const std::string& path,
                                                             const std::string& text,
                                                             const JsonPath& value) {
  const PlainJson parsed = parse_json(path, text);
  const PlainJson* object = &parsed;
  for (const std::string& step : value) {
    if (!object->is_object() || !object->contains(step)) return {};
    object = &(*object)[step];
  }
  std::map<std::string, std::vector<std::string>> members;
  if (!object->is_object()) return members;
  for (const auto& [name, member] : object->items()) {
    const bool texts = member.is_array() &&
                       std::all_of(member.begin(), member.end(),
                                   [](const PlainJson& entry) { return entry.is_string(); });
    if (member.is_string()) members[name] = {member.get<std::string>()};
    if (texts) members[name] = member.get<std::vector<std::string>>();
  }
  return members;
}

}  // namespace thenar
