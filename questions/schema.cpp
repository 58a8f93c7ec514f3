#include "questions/schema.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/lists.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "base/numbers.h"

namespace thenar {
namespace {

constexpr double kUnitTolerance = 1e-3;  // deviation of a quaternion's length from 1 [1]

/// Returns the word for a value with named members.
const char* object_word(RequestSyntax syntax) {
  return syntax == RequestSyntax::kToml ? "a table" : "an object";
}

/// Describes the values that a schema accepts, for messages: "a number [m]".
std::string description(const Schema& schema, RequestSyntax syntax) {
  const std::string unit = schema.unit.empty() ? "" : fmt::format(" [{}]", schema.unit);
  // State the bounds of numbers, the words or lengths of texts, the sizes of lists and maps.
  switch (schema.kind) {
    case Schema::Kind::kNumber:
    case Schema::Kind::kInteger: {
      const char* const what = schema.kind == Schema::Kind::kNumber ? "a number" : "a whole number";
      if (schema.accepts_infinity)
        return what + unit + (syntax == RequestSyntax::kToml ? " or inf" : " or \"inf\"");
      const bool low = std::isfinite(schema.lower), high = std::isfinite(schema.upper);
      if (low && high)
        return fmt::format("{} from {} to {}{}", what, schema.lower, schema.upper, unit);
      if (low) return fmt::format("{} of at least {}{}", what, schema.lower, unit);
      if (high) return fmt::format("{} of at most {}{}", what, schema.upper, unit);
      return what + unit;
    }
    case Schema::Kind::kText:
      if (!schema.words.empty()) return "one of " + listed(schema.words);
      return fmt::format("a text of {} to {} bytes", schema.min_size, schema.max_size);
    case Schema::Kind::kFlag:
      return "true or false";
    case Schema::Kind::kList:
      if (schema.min_size == schema.max_size) return fmt::format("a list of {}", schema.min_size);
      return fmt::format("a list of {} to {} entries", schema.min_size, schema.max_size);
    case Schema::Kind::kMap:
      return fmt::format("{} of at most {} members{}", object_word(syntax), schema.max_size,
                         schema.accepts_list ? ", or a list" : "");
    case Schema::Kind::kObject:
      break;
  }
  return object_word(syntax);
}

/// Describes a received value in few words: numbers and short texts as they are, others by kind.
std::string brief(const Json& value, RequestSyntax syntax) {
  constexpr std::size_t kMaxQuoted = 40;  // longest text that is quoted [bytes]
  if (value.is_number() || value.is_boolean() || value.is_null()) return json_text(value, -1);
  if (value.is_string()) {
    const std::string text = json_text(value, -1);
    return text.size() <= kMaxQuoted ? text : fmt::format("a text of {} bytes", text.size() - 2);
  }
  return value.is_array() ? fmt::format("a list of {}", value.size()) : object_word(syntax);
}

[[noreturn]] void refuse(const Schema& schema, const Json& value, const std::string& where,
                         RequestSyntax syntax) {
  throw InputError(fmt::format("{}: wanted {}, got {}", where, description(schema, syntax),
                               brief(value, syntax)));
}

bool is_within(const Schema& schema, std::size_t size) {
  return size >= schema.min_size && size <= schema.max_size;
}

bool fits_number(const Schema& schema, const Json& value) {
  if (schema.accepts_infinity && (value == "inf" || (value == "-inf" && schema.lower < 0)))
    return true;
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  if (schema.kind == Schema::Kind::kInteger && number != std::floor(number)) return false;
  return std::isfinite(number) && number >= schema.lower && number <= schema.upper;
}

bool fits_text(const Schema& schema, const Json& value) {
  if (!value.is_string()) return false;
  const std::string& text = value.get_ref<const std::string&>();
  if (schema.words.empty()) return is_within(schema, text.size());
  return contains(schema.words, text);
}

/// @throws InputError for a text that is no valid name or path
void require_name(const std::string& text, OutsideUse use, const std::string& where) {
  const std::optional<std::string> fault = outside_fault(text, use);
  require(!fault, "{}: wanted a name or a path{}, got one with {}", where,
          use == OutsideUse::kInside ? " within the working folder" : "", fault.value_or(""));
}

/// Checks that a quaternion has length 1; ignores values of other units. @throws InputError
void require_unit(const Schema& schema, const Json& value, const std::string& where) {
  if (schema.unit != "quaternion") return;
  double square = 0;
  for (const Json& entry : value) square += entry.get<double>() * entry.get<double>();
  require(std::abs(std::sqrt(square) - 1) <= kUnitTolerance,
          "{}: wanted a quaternion [w, x, y, z] of length 1, got length {}", where,
          std::sqrt(square));
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Json checked_list(const Schema& schema, const Json& value, const std::string& where,
                  RequestSyntax syntax) {
  if (!value.is_array() || !is_within(schema, value.size())) refuse(schema, value, where, syntax);
  Json out = Json::array();
  for (std::size_t i = 0; i < value.size(); ++i)
    out.push_back(validated(*schema.element, value[i], fmt::format("{}.{}", where, i), syntax));
  require_unit(schema, value, where);
  return out;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Json checked_map(const Schema& schema, const Json& value, const std::string& where,
                 RequestSyntax syntax) {
  if (!value.is_object() || !is_within(schema, value.size())) refuse(schema, value, where, syntax);
  Json out = Json::object();
  for (const auto& [name, entry] : value.items()) {
    require_name(name, OutsideUse::kRead, where);
    out[name] = validated(*schema.element, entry, where + "." + name, syntax);
  }
  return out;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Json checked_object(const Schema& schema, const Json& value, const std::string& where,
                    RequestSyntax syntax) {
  if (!value.is_object()) refuse(schema, value, where, syntax);
  if (schema.accepts_any_member) return value;
  // Refuse unknown members, which are usually misspelt.
  const std::vector<std::string> names = names_of(schema.members);
  for (const auto& [name, entry] : value.items())
    require(contains(names, name), "{}: no member '{}'{} there are {}", where, name.substr(0, 40),
            hint_before_list(name.substr(0, 40), names), listed(names));
  // Check the known members, or set their default values.
  Json out = Json::object();
  for (const SchemaMember& member : schema.members) {
    if (value.contains(member.name))
      out[member.name] =
          validated(member.schema, value[member.name], where + "." + member.name, syntax);
    else if (!member.default_value.is_null())
      out[member.name] = member.default_value;
    else
      require(!member.required, "{}: '{}' is missing, wanted {}", where, member.name,
              description(member.schema, syntax));
  }
  return out;
}

/// Adds the bounds of a size in terms of JSON Schema: minItems, maxItems.
void add_size_bounds(const Schema& schema, const std::string& counted, OrderedJson& out) {
  if (schema.min_size > 0) out["min" + counted] = schema.min_size;
  out["max" + counted] = schema.max_size;
}

/// Returns a schema with bounds on its size.
Schema sized_schema(Schema::Kind kind, std::size_t min_size, std::size_t max_size,
                    std::shared_ptr<const Schema> element = nullptr) {
  return {kind, "", -kInfinity, kInfinity, min_size, max_size, std::move(element)};
}

}  // namespace

Schema number_schema(const std::string& unit, double lower, double upper) {
  return {Schema::Kind::kNumber, unit, lower, upper};
}

Schema infinite_number_schema(const std::string& unit, double lower) {
  Schema schema = number_schema(unit, lower);
  schema.accepts_infinity = true;
  return schema;
}

Schema integer_schema(double lower, double upper) {
  return {Schema::Kind::kInteger, "", lower, upper};
}

Schema text_schema(std::size_t max_bytes) {
  return sized_schema(Schema::Kind::kText, 0, max_bytes);
}

Schema saved_file_schema() {
  Schema schema = text_schema(kMaxOutsidePath);
  schema.use = OutsideUse::kInside;
  return schema;
}

Schema content_schema(std::size_t max_bytes) {
  Schema schema = text_schema(max_bytes);
  schema.use.reset();
  return schema;
}

Schema word_schema(std::vector<std::string> words) {
  Schema schema = text_schema();
  schema.words = std::move(words);
  return schema;
}

Schema flag_schema() { return {Schema::Kind::kFlag}; }

Schema list_schema(const Schema& element, std::size_t min_size, std::size_t max_size) {
  return sized_schema(Schema::Kind::kList, min_size, max_size, std::make_shared<Schema>(element));
}

Schema map_schema(const Schema& element, std::size_t max_size) {
  return sized_schema(Schema::Kind::kMap, 0, max_size, std::make_shared<Schema>(element));
}

Schema map_or_list_schema(const Schema& element) {
  Schema schema = map_schema(element);
  schema.accepts_list = true;
  return schema;
}

Schema object_schema(std::vector<SchemaMember> members) {
  Schema schema;
  schema.members = std::move(members);
  return schema;
}

Schema any_object_schema() {
  Schema schema;
  schema.accepts_any_member = true;
  return schema;
}

Schema vector_schema(const std::string& unit) { return list_schema(number_schema(unit), 3, 3); }

Schema rotation_schema() {
  Schema schema = list_schema(number_schema("", -1.001, 1.001), 4, 4);
  schema.unit = "quaternion";
  return schema;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Json validated(const Schema& schema, const Json& value, const std::string& where,
               RequestSyntax syntax) {
  // Check the bounds of the kind; lists, maps and objects check their contents.
  switch (schema.kind) {
    case Schema::Kind::kNumber:
    case Schema::Kind::kInteger:
      if (!fits_number(schema, value)) refuse(schema, value, where, syntax);
      return value;
    case Schema::Kind::kText:
      if (!fits_text(schema, value)) refuse(schema, value, where, syntax);
      if (schema.use) require_name(value.get_ref<const std::string&>(), *schema.use, where);
      return value;
    case Schema::Kind::kFlag:
      if (!value.is_boolean()) refuse(schema, value, where, syntax);
      return value;
    case Schema::Kind::kList:
      return checked_list(schema, value, where, syntax);
    case Schema::Kind::kMap:
      return schema.accepts_list && value.is_array() ? checked_list(schema, value, where, syntax)
                                                     : checked_map(schema, value, where, syntax);
    case Schema::Kind::kObject:
      break;
  }
  return checked_object(schema, value, where, syntax);
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
OrderedJson json_schema(const Schema& schema) {
  OrderedJson out;
  // Convert the kind and its bounds.
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
        add_size_bounds(schema, "Length", out);
      else
        out["enum"] = schema.words;
      break;
    case Schema::Kind::kFlag:
      out["type"] = "boolean";
      break;
    case Schema::Kind::kList:
      out["type"] = "array";
      out["items"] = json_schema(*schema.element);
      add_size_bounds(schema, "Items", out);
      break;
    case Schema::Kind::kMap:
      out["type"] = "object";
      out["additionalProperties"] = json_schema(*schema.element);
      add_size_bounds(schema, "Properties", out);
      break;
    case Schema::Kind::kObject: {
      out["type"] = "object";
      out["properties"] = OrderedJson::object();
      // Add the members with descriptions and default values; unknown members are invalid.
      OrderedJson required = OrderedJson::array();
      for (const SchemaMember& member : schema.members) {
        OrderedJson property = json_schema(member.schema);
        property["description"] = member.description;
        if (!member.default_value.is_null()) property["default"] = member.default_value;
        out["properties"][member.name] = std::move(property);
        if (member.required) required.push_back(member.name);
      }
      if (!required.empty()) out["required"] = std::move(required);
      out["additionalProperties"] = false;
      break;
    }
  }
  // Add the unit as an extension.
  if (!schema.unit.empty()) out["x-unit"] = schema.unit;
  return out;
}

}  // namespace thenar
