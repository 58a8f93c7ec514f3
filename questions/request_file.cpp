#include "questions/request_file.h"

#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "data/io/toml_node.h"
#include "data/io/toml_text.h"

namespace thenar {
namespace {

constexpr const char* kQuestionKey = "question";

// NOLINTNEXTLINE(misc-no-recursion): as deep as the text
Json json_from(const TomlNode& node, const std::string& path) {
  switch (node.kind) {
    case TomlKind::kText:
      return node.text;
    case TomlKind::kNumber:
      if (std::isnan(node.number)) throw DataError(path, node.line, "no parameter is nan");
      // Keep integers as integers.
      if (node.number == std::floor(node.number) && std::abs(node.number) < 1e15)
        return static_cast<long>(node.number);
      return value_json(node.number);
    case TomlKind::kFlag:
      return node.flag;
    case TomlKind::kDate:
      break;
    case TomlKind::kArray: {
      Json list = Json::array();
      for (const TomlNode& item : node.items) list.push_back(json_from(item, path));
      return list;
    }
    case TomlKind::kTable: {
      Json object = Json::object();
      for (const auto& [key, member] : node.members) object[key] = json_from(member, path);
      return object;
    }
  }
  throw DataError(path, node.line, "no parameter is a date");
}

/// Writes a TOML key, bare if possible.
std::string toml_key(const std::string& key) {
  const char* const bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  const bool is_bare = !key.empty() && key.find_first_not_of(bare) == std::string::npos;
  return is_bare ? key : toml_quoted(key);
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the value
std::string toml_of(const OrderedJson& value) {
  if (value.is_string()) return toml_quoted(value.get<std::string>());
  if (value.is_number_float()) return toml_number(value.get<double>());
  if (!value.is_structured()) return json_text(value, -1);
  std::string text;
  for (const auto& [key, each] : value.items())
    text += (text.empty() ? "" : ", ") + (value.is_object() ? toml_key(key) + " = " : "") +
            toml_of(each);
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

/// Returns the form of a value, to be filled in: "[{joint = \"..\", from = ..}]".
// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
std::string form_of(const Schema& schema) {
  switch (schema.kind) {
    case Schema::Kind::kNumber:
    case Schema::Kind::kInteger:
      return "..";
    case Schema::Kind::kText:
      return "\"..\"";
    case Schema::Kind::kFlag:
      return "true";
    case Schema::Kind::kList:
      return "[" + form_of(*schema.element) + "]";
    case Schema::Kind::kMap:
      return "{NAME = " + form_of(*schema.element) + "}";
    case Schema::Kind::kObject:
      break;
  }
  std::string members;
  for (const SchemaMember& member : schema.members)
    members += (members.empty() ? "" : ", ") + member.name + " = " + form_of(member.schema);
  return "{" + members + "}";
}

}  // namespace

Answer RequestFile::ask(const Progress& progress) const {
  try {
    // Check the request in the words of TOML first.
    (void)request_in_si(question->params, request, RequestSyntax::kToml);
    return question->ask(request, "", progress);
  } catch (const InputError& error) {
    // Report the line of the key that sets the field, in either unit.
    bool sets_field = false;
    for (const Param& param : question->params) {
      // Fields of postures are named without a unit, as their option is; twins set the same field.
      sets_field = (sets_field && param.is_twin) || param.member.name == error.field() ||
                   (!error.field().empty() && param.option == error.field());
      for (const UnitSystem system : {UnitSystem::kSi, UnitSystem::kPrinted})
        if (const auto line = lines.find(param.key_in(system)); sets_field && line != lines.end())
          throw DataError(path, line->second, error.what());
    }
    const auto line = lines.find(error.field());
    throw DataError(path, line == lines.end() ? 1 : line->second, error.what());
  }
}

RequestFile read_request(const std::string& path) {
  return parse_request(read_text_file(path), path);
}

RequestFile parse_request(const std::string& text, const std::string& path) {
  // Read the name of the question.
  const TomlNode root = parse_toml(text, path);
  const TomlNode* const name = root.find(kQuestionKey);
  if (name == nullptr || name->kind != TomlKind::kText)
    throw DataError(path, name == nullptr ? 1 : name->line,
                    "wanted question = \"..\": which question is asked");
  RequestFile file;
  file.path = path;
  file.question = at_line(path, name->line, [&] { return &question_named(name->text); });
  file.request = Json::object();
  // Keep the line of each key, for messages about its value.
  for (const auto& [key, member] : root.members) {
    if (key == kQuestionKey) continue;
    file.request[key] = json_from(member, path);
    file.lines[key] = member.line;
  }
  return file;
}

std::string request_text(const std::string& question, const OrderedJson& request) {
  std::string text = fmt::format("{} = {}\n", kQuestionKey, toml_quoted(question));
  for (const auto& [key, value] : request.items())
    if (!value.is_null()) text += fmt::format("{} = {}\n", toml_key(key), toml_of(value));
  return text;
}

std::string request_template(const Question& question) {
  // Write each parameter, with its default value as a comment, so that the file is valid.
  std::string text = fmt::format("# {}\n{} = {}\n", question.description, kQuestionKey,
                                 toml_quoted(question.name));
  const Json example = Json::parse(question.example);
  for (const Param& param : question.params) {
    // Use keys in printed units, because users edit the file.
    if (param.is_twin) continue;
    const std::string key = param.key_in(UnitSystem::kPrinted);
    const Schema schema = param.schema_in(UnitSystem::kPrinted);
    text += fmt::format("\n# {}\n", param.member.description);
    if (!schema.words.empty()) text += fmt::format("# One of {}.\n", listed(schema.words));
    if (example.contains(key))
      text += fmt::format("{} = {}\n", toml_key(key), toml_of(example[key]));
    else if (!param.member.default_value.is_null())
      text += fmt::format(
          "# {} = {}\n", toml_key(key),
          toml_of(value_in(param.member.default_value, param.unit, UnitSystem::kPrinted)));
    else
      text += fmt::format("# {} = {}\n", toml_key(key), form_of(schema));
  }
  return text;
}

}  // namespace thenar
