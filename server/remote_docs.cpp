#include "server/remote_docs.h"

#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace thenar {
namespace {

constexpr std::size_t kProseColumns = 118;  // largest width of prose [columns]

/// Wraps a text between words.
std::string wrapped_text(const std::string& text) {
  std::istringstream words(text);
  std::string out, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kProseColumns) {
      out += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return out + line + "\n";
}

/// Describes the bounds of a number: ", 0 to 1".
std::string range_text(const Schema& schema) {
  const bool low = std::isfinite(schema.lower), high = std::isfinite(schema.upper);
  if (low && high) return fmt::format(", {} to {}", schema.lower, schema.upper);
  if (low) return fmt::format(", at least {}", schema.lower);
  return high ? fmt::format(", at most {}", schema.upper) : "";
}

/// Describes the values that a schema accepts: "number [m], 0 to 1".
// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
std::string type_text(const Schema& schema) {
  const std::string unit = schema.unit.empty() ? "" : fmt::format(" [{}]", schema.unit);
  switch (schema.kind) {
    case Schema::Kind::kNumber:
      return "number" + unit + range_text(schema);
    case Schema::Kind::kInteger:
      return "whole number" + unit + range_text(schema);
    case Schema::Kind::kText: {
      if (schema.words.empty()) return "text";
      std::string words;
      for (const std::string& word : schema.words)
        words += (words.empty() ? "`" : ", `") + word + "`";
      return "one of " + words;
    }
    case Schema::Kind::kFlag:
      return "`true` or `false`";
    case Schema::Kind::kList:
      if (schema.unit == "quaternion") return "rotation, quaternion [w, x, y, z]";
      if (schema.min_size == schema.max_size)
        return fmt::format("list of {}: {}", schema.min_size, type_text(*schema.element));
      return fmt::format("list of {} to {}: {}", schema.min_size, schema.max_size,
                         type_text(*schema.element));
    case Schema::Kind::kMap:
      return "object, name: " + type_text(*schema.element);
    case Schema::Kind::kObject:
      break;
  }
  // Objects list their members with their types.
  std::string members;
  for (const SchemaMember& member : schema.members)
    members += fmt::format("{}`{}`: {}", members.empty() ? "" : "; ", member.name,
                           type_text(member.schema));
  return "object: " + members;
}

/// Escapes the text of a table cell.
std::string escaped_cell(std::string text) {
  for (std::size_t i = 0; (i = text.find('|', i)) != std::string::npos; i += 2)
    text.insert(i, "\\");
  return text;
}

std::string default_text(const SchemaMember& member) {
  if (member.required) return "required";
  return member.default_value.is_null() ? "" : "`" + json_text(member.default_value, -1) + "`";
}

/// Writes an example request as indented code, on one line if it fits.
std::string example_of(const RpcMethod& method) {
  const OrderedJson request{{"jsonrpc", "2.0"},
                            {"id", 1},
                            {"method", method.name},
                            {"params", OrderedJson::parse(method.example)}};
  // Format it, and indent every line.
  std::string text = json_text(request, -1);
  if (text.size() > kProseColumns) text = json_text(request);
  std::string out = "    ";
  for (const char c : text) {
    out += c;
    if (c == '\n') out += "    ";
  }
  return out + "\n";
}

std::string section_of(const RpcMethod& method) {
  std::string out = fmt::format("### {}\n\n{}\n", method.name, wrapped_text(method.description));
  if (!method.params.members.empty()) {
    out += "| parameter | type | default | description |\n|---|---|---|---|\n";
    for (const SchemaMember& member : method.params.members)
      out += fmt::format("| `{}` | {} | {} | {} |\n", member.name,
                         escaped_cell(type_text(member.schema)), escaped_cell(default_text(member)),
                         escaped_cell(member.description));
    out += "\n";
  }
  // Add the result and an example; texts of several sentences already have a full stop.
  const std::string end = !method.returns.empty() && method.returns.back() == '.' ? "" : ".";
  return out + wrapped_text("Returns " + method.returns + end) + "\n" + example_of(method) + "\n";
}

}  // namespace

std::string methods_markdown(const MethodTable& table) {
  std::string out, group;
  for (const RpcMethod& method : table.methods()) {
    const std::string its = method.name.substr(0, method.name.find('.'));
    if (its != group) out += fmt::format("## {}.*\n\n", its);
    group = its;
    out += section_of(method);
  }
  return out;
}

}  // namespace thenar
