#include "questions/schema.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "base/numbers.h"

namespace thenar {
namespace {

constexpr double kUnitTolerance = 1e-3;  // of the length of a quaternion

/// "a number [m]", "a text of at most 80 bytes": what a schema wants, for messages.
std::string wish(const Schema& schema) {
  const std::string unit = schema.unit.empty() ? "" : fmt::format(" [{}]", schema.unit);
  // Numbers state their bounds, texts their words or length, lists and maps their size.
  switch (schema.kind) {
    case Schema::Kind::kNumber:
    case Schema::Kind::kInteger: {
      const char* const what = schema.kind == Schema::Kind::kNumber ? "a number" : "a whole number";
      if (schema.endless) return fmt::format("{}{} or \"inf\"", what, unit);
      const bool low = std::isfinite(schema.lower), high = std::isfinite(schema.upper);
      if (low && high)
        return fmt::format("{} from {} to {}{}", what, schema.lower, schema.upper, unit);
      if (low) return fmt::format("{} of at least {}{}", what, schema.lower, unit);
      if (high) return fmt::format("{} of at most {}{}", what, schema.upper, unit);
      return what + unit;
    }
    case Schema::Kind::kText:
      if (!schema.words.empty()) return "one of " + listed(schema.words);
      return fmt::format("a text of {} to {} bytes", schema.least, schema.most);
    case Schema::Kind::kFlag:
      return "true or false";
    case Schema::Kind::kList:
      if (schema.least == schema.most) return fmt::format("a list of {}", schema.least);
      return fmt::format("a list of {} to {} entries", schema.least, schema.most);
    case Schema::Kind::kMap:
      return fmt::format("an object of at most {} members{}", schema.most,
                         schema.unnamed ? ", or a list" : "");
    case Schema::Kind::kObject:
      break;
  }
  return "an object";
}

/// Returns a short text of a received value: numbers as they are, texts by their kind, so that no
/// message is long.
std::string seen(const Json& value) {
  if (value.is_number() || value.is_boolean() || value.is_null()) return json_text(value, -1);
  if (value.is_string()) {
    const std::string text = json_text(value, -1);
    return text.size() <= 40 ? text : fmt::format("a text of {} bytes", text.size() - 2);
  }
  return value.is_array() ? fmt::format("a list of {}", value.size()) : "an object";
}

[[noreturn]] void refuse(const Schema& schema, const Json& value, const std::string& where) {
  throw InputError(fmt::format("{}: wanted {}, got {}", where, wish(schema), seen(value)));
}

bool is_within(const Schema& schema, std::size_t size) {
  return size >= schema.least && size <= schema.most;
}

bool fits_number(const Schema& schema, const Json& value) {
  if (schema.endless && (value == "inf" || (value == "-inf" && schema.lower < 0))) return true;
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  if (schema.kind == Schema::Kind::kInteger && number != std::floor(number)) return false;
  return std::isfinite(number) && number >= schema.lower && number <= schema.upper;
}

bool fits_text(const Schema& schema, const Json& value) {
  if (!value.is_string()) return false;
  const std::string& text = value.get_ref<const std::string&>();
  if (schema.words.empty()) return is_within(schema, text.size());
  return std::find(schema.words.begin(), schema.words.end(), text) != schema.words.end();
}

/// @throws InputError for a name or path that nothing may be called by
void require_name(const std::string& text, OutsideUse use, const std::string& where) {
  const std::optional<std::string> fault = outside_fault(text, use);
  require(!fault, "{}: wanted a name or a path{}, got one with {}", where,
          use == OutsideUse::kInside ? " within the working folder" : "", fault.value_or(""));
}

/// Checks that a quaternion has length 1; values of other units pass. @throws InputError otherwise
void require_unit(const Schema& schema, const Json& value, const std::string& where) {
  if (schema.unit != "quaternion") return;
  double square = 0;
  for (const Json& entry : value) square += entry.get<double>() * entry.get<double>();
  require(std::abs(std::sqrt(square) - 1) <= kUnitTolerance,
          "{}: wanted a quaternion [w, x, y, z] of length 1, got length {}", where,
          std::sqrt(square));
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Json checked_list(const Schema& schema, const Json& value, const std::string& where) {
  if (!value.is_array() || !is_within(schema, value.size())) refuse(schema, value, where);
  Json out = Json::array();
  for (std::size_t i = 0; i < value.size(); ++i)
    out.push_back(checked(*schema.each, value[i], fmt::format("{}.{}", where, i)));
  require_unit(schema, value, where);
  return out;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Json checked_map(const Schema& schema, const Json& value, const std::string& where) {
  if (!value.is_object() || !is_within(schema, value.size())) refuse(schema, value, where);
  Json out = Json::object();
  for (const auto& [name, entry] : value.items()) {
    require_name(name, OutsideUse::kRead, where);
    out[name] = checked(*schema.each, entry, where + "." + name);
  }
  return out;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Json checked_object(const Schema& schema, const Json& value, const std::string& where) {
  if (!value.is_object()) refuse(schema, value, where);
  if (schema.open) return value;
  // Members that nobody knows are refused: they are misspelt ones.
  std::vector<std::string> names;
  for (const SchemaMember& member : schema.members) names.push_back(member.name);
  for (const auto& [name, entry] : value.items())
    require(std::find(names.begin(), names.end(), name) != names.end(),
            "{}: no member '{}'{} there are {}", where, name.substr(0, 40),
            hint_before_list(name.substr(0, 40), names), listed(names));
  // Known ones are checked, or take their usual value.
  Json out = Json::object();
  for (const SchemaMember& member : schema.members) {
    if (value.contains(member.name))
      out[member.name] = checked(member.schema, value[member.name], where + "." + member.name);
    else if (!member.usual.is_null())
      out[member.name] = member.usual;
    else
      require(!member.required, "{}: '{}' is missing, wanted {}", where, member.name,
              wish(member.schema));
  }
  return out;
}

/// Adds what limits a length, in the words of JSON Schema: minItems, maxItems.
void add_lengths(const Schema& schema, const std::string& of, OrderedJson& out) {
  if (schema.least > 0) out["min" + of] = schema.least;
  out["max" + of] = schema.most;
}

Schema sized_schema(Schema::Kind kind, std::size_t least, std::size_t most,
                    std::shared_ptr<const Schema> each = nullptr) {
  return {kind, "", -kInfinity, kInfinity, least, most, std::move(each)};
}

}  // namespace

Schema number_schema(const std::string& unit, double lower, double upper) {
  return {Schema::Kind::kNumber, unit, lower, upper};
}

Schema endless_schema(const std::string& unit, double lower) {
  Schema schema = number_schema(unit, lower);
  schema.endless = true;
  return schema;
}

Schema integer_schema(double lower, double upper) {
  return {Schema::Kind::kInteger, "", lower, upper};
}

Schema text_schema(std::size_t most) { return sized_schema(Schema::Kind::kText, 0, most); }

Schema saved_file_schema() {
  Schema schema = text_schema(kMaxOutsidePath);
  schema.use = OutsideUse::kInside;
  return schema;
}

Schema content_schema(std::size_t most) {
  Schema schema = text_schema(most);
  schema.use.reset();
  return schema;
}

Schema word_schema(std::vector<std::string> words) {
  Schema schema = text_schema();
  schema.words = std::move(words);
  return schema;
}

Schema flag_schema() { return {Schema::Kind::kFlag}; }

Schema list_schema(const Schema& each, std::size_t least, std::size_t most) {
  return sized_schema(Schema::Kind::kList, least, most, std::make_shared<Schema>(each));
}

Schema map_schema(const Schema& each, std::size_t most) {
  return sized_schema(Schema::Kind::kMap, 0, most, std::make_shared<Schema>(each));
}

Schema map_or_list_schema(const Schema& each) {
  Schema schema = map_schema(each);
  schema.unnamed = true;
  return schema;
}

Schema object_schema(std::vector<SchemaMember> members) {
  Schema schema;
  schema.members = std::move(members);
  return schema;
}

Schema any_object_schema() {
  Schema schema;
  schema.open = true;
  return schema;
}

Schema vector_schema(const std::string& unit) { return list_schema(number_schema(unit), 3, 3); }

Schema rotation_schema() {
  Schema schema = list_schema(number_schema("", -1.001, 1.001), 4, 4);
  schema.unit = "quaternion";
  return schema;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Json checked(const Schema& schema, const Json& value, const std::string& where) {
  // Each kind checks its own bounds; lists, maps and objects check what they contain.
  switch (schema.kind) {
    case Schema::Kind::kNumber:
    case Schema::Kind::kInteger:
      if (!fits_number(schema, value)) refuse(schema, value, where);
      return value;
    case Schema::Kind::kText:
      if (!fits_text(schema, value)) refuse(schema, value, where);
      if (schema.use) require_name(value.get_ref<const std::string&>(), *schema.use, where);
      return value;
    case Schema::Kind::kFlag:
      if (!value.is_boolean()) refuse(schema, value, where);
      return value;
    case Schema::Kind::kList:
      return checked_list(schema, value, where);
    case Schema::Kind::kMap:
      return schema.unnamed && value.is_array() ? checked_list(schema, value, where)
                                                : checked_map(schema, value, where);
    case Schema::Kind::kObject:
      break;
  }
  return checked_object(schema, value, where);
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
OrderedJson json_schema(const Schema& schema) {
  OrderedJson out;
  // Translate into JSON Schema, whose names for bounds differ from kind to kind.
  switch (schema.kind) {
    case Schema::Kind::kNumber:
    case Schema::Kind::kInteger:
      out["type"] = schema.kind == Schema::Kind::kNumber ? "number" : "integer";
      if (std::isfinite(schema.lower)) out["minimum"] = schema.lower;
      if (std::isfinite(schema.upper)) out["maximum"] = schema.upper;
      break;
    case Schema::Kind::kText:
      out["type"] = "string";
      if (schema.words.empty())
        add_lengths(schema, "Length", out);
      else
        out["enum"] = schema.words;
      break;
    case Schema::Kind::kFlag:
      out["type"] = "boolean";
      break;
    case Schema::Kind::kList:
      out["type"] = "array";
      out["items"] = json_schema(*schema.each);
      add_lengths(schema, "Items", out);
      break;
    case Schema::Kind::kMap:
      out["type"] = "object";
      out["additionalProperties"] = json_schema(*schema.each);
      add_lengths(schema, "Properties", out);
      break;
    case Schema::Kind::kObject: {
      out["type"] = "object";
      out["properties"] = OrderedJson::object();
      // Members with their descriptions and defaults; unknown members are refused.
      OrderedJson wanted = OrderedJson::array();
      for (const SchemaMember& member : schema.members) {
        OrderedJson of = json_schema(member.schema);
        of["description"] = member.about;
        if (!member.usual.is_null()) of["default"] = member.usual;
        out["properties"][member.name] = std::move(of);
        if (member.required) wanted.push_back(member.name);
      }
      if (!wanted.empty()) out["required"] = std::move(wanted);
      out["additionalProperties"] = false;
      break;
    }
  }
  // JSON Schema has no units, so they go into an extension.
  if (!schema.unit.empty()) out["x-unit"] = schema.unit;
  return out;
}

}  // namespace thenar
