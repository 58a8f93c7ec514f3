// The only fence of toml++.

#include "data/io/toml_node.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/enum_names.h"
#include "base/error.h"
#include "base/file_io.h"
#include "data/io/file_guard.h"

namespace {
/// Thrown where toml++ would abort the program: some syntax errors violate its assertions.
struct ParserGaveUp {};
[[noreturn]] void give_up() { throw ParserGaveUp{}; }
}  // namespace
#undef TOML_SHARED_LIB  // the shared library has assertions of its own
#undef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(expr) ((expr) ? void() : give_up())
#include <toml++/toml.h>

namespace thenar {
namespace {

int line_of(const toml::source_region& region) { return static_cast<int>(region.begin.line); }

TomlNode convert(const toml::node& from);  // NOLINT(misc-no-recursion): as deep as the text

// NOLINTNEXTLINE(misc-no-recursion): as deep as the text
TomlNode convert_array(const toml::array& array) {
  TomlNode node;
  node.kind = TomlKind::kArray;
  node.items.reserve(array.size());
  for (const toml::node& item : array) node.items.push_back(convert(item));
  return node;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the text
TomlNode convert_table(const toml::table& table) {
  // toml++ sorts keys by name; readers need them in the order of the file.
  std::vector<std::pair<toml::source_position, std::pair<std::string, TomlNode>>> found;
  found.reserve(table.size());
  for (const auto& [key, value] : table) {
    TomlNode member = convert(value);
    if (!value.is_table() && !value.is_array()) member.line = line_of(key.source());
    found.push_back({key.source().begin, {std::string(key.str()), std::move(member)}});
  }
  // Back to the order of the file.
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.first.line, a.first.column) <
           std::make_pair(b.first.line, b.first.column);
  });
  // Members in this order, and an index by name for look-ups.
  TomlNode node;
  node.members.reserve(found.size());
  for (auto& entry : found) node.members.push_back(std::move(entry.second));
  node.by_name.resize(node.members.size());
  std::iota(node.by_name.begin(), node.by_name.end(), 0);
  std::sort(node.by_name.begin(), node.by_name.end(), [&](std::size_t a, std::size_t b) {
    return node.members[a].first < node.members[b].first;
  });
  return node;
}

TomlNode convert_value(const toml::node& from) {
  TomlNode node;
  if (const auto* text = from.as_string()) {
    node.kind = TomlKind::kText;
    node.text = text->get();
  } else if (const auto* flag = from.as_boolean()) {
    node.kind = TomlKind::kFlag;
    node.flag = flag->get();
  } else if (from.is_number()) {
    node.kind = TomlKind::kNumber;
    node.number = *from.value<double>();
  } else {
    node.kind = TomlKind::kDate;
  }
  return node;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the text
TomlNode convert(const toml::node& from) {
  TomlNode node = from.is_table()   ? convert_table(*from.as_table())
                  : from.is_array() ? convert_array(*from.as_array())
                                    : convert_value(from);
  node.line = line_of(from.source());
  return node;
}

bool gives_up_within(std::string_view text) {
  try {
    (void)toml::parse(text);
  } catch (const toml::parse_error&) {
    return false;  // perhaps a statement that goes on in the next line
  } catch (const ParserGaveUp&) {
    return true;
  }
  return false;
}

/// Line at which the parser gives up: the first whose end it cannot reach. Found by bisection, as
/// it does not get beyond that place however much follows.
int line_given_up(const std::string& text) {
  // Ends of all lines.
  std::vector<std::size_t> ends;
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
    ends.push_back(at);
  ends.push_back(text.size());
  const auto first = std::partition_point(ends.begin(), ends.end() - 1, [&](std::size_t end) {
    return !gives_up_within(std::string_view(text).substr(0, end));
  });
  return 1 + static_cast<int>(first - ends.begin());
}

}  // namespace

const TomlNode* TomlNode::find(const std::string& key) const {
  const auto at = std::lower_bound(
      by_name.begin(), by_name.end(), key,
      [&](std::size_t place, const std::string& wanted) { return members[place].first < wanted; });
  return at != by_name.end() && members[*at].first == key ? &members[*at].second : nullptr;
}

TomlNode parse_toml(const std::string& text, const std::string& path) {
  // Limits first; then syntax errors with their line.
  guard_text(text, path, GuardedKind::kToml);
  try {
    return convert(toml::parse(text, path));
  } catch (const toml::parse_error& e) {
    throw DataError(path, line_of(e.source()), std::string(e.description()));
  } catch (const ParserGaveUp&) {
    throw DataError(path, line_given_up(text), "is not TOML");
  }
}

std::string kind_name(TomlKind kind) {
  constexpr std::array kNames{
      EnumName{TomlKind::kText, "a text"},        EnumName{TomlKind::kNumber, "a number"},
      EnumName{TomlKind::kFlag, "true or false"}, EnumName{TomlKind::kDate, "a date"},
      EnumName{TomlKind::kArray, "a list"},       EnumName{TomlKind::kTable, "a table"}};
  return name_in(kNames, kind);
}

std::string read_text_file(const std::string& path) {
  return read_file(path, limit_of(GuardedKind::kMesh).bytes);  // the longest of texts
}

}  // namespace thenar
