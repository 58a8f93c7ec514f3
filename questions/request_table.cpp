#include "questions/request_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/error.h"
#include "base/name_hint.h"
#include "base/nearest_name.h"
#include "base/numbers.h"

namespace thenar {
namespace {

/// Converts a JSON number, or the texts "inf" and "-inf".
double number_of(const Json& json) {
  if (!json.is_string()) return json.get<double>();
  return json == "-inf" ? -kInfinity : kInfinity;
}

/// Converts all numbers of a value from printed units to SI.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the value
Json from_printed(const Json& value, const FieldUnit& unit) {
  if (value.is_number()) return value.get<double>() * unit.denominator / unit.numerator;
  Json out = value;
  if (value.is_structured())
    for (Json& each : out) each = from_printed(each, unit);
  return out;
}

/// Converts the unit of a key to text: "N_m_per_rad" to "N m/rad", "Nm" to "N m", "percent" to "%".
std::string unit_words(std::string key) {
  if (key == "percent") return "%";
  if (key.rfind("Nm", 0) == 0) key.replace(0, 2, "N_m");
  if (const std::size_t per = key.find("_per_"); per != std::string::npos) key.replace(per, 5, "/");
  std::replace(key.begin(), key.end(), '_', ' ');
  return key;
}

/// Returns a schema in SI with the unit and bounds of a system of units.
// NOLINTNEXTLINE(misc-no-recursion): as deep as the schema
Schema with_unit(Schema schema, const FieldUnit& unit, UnitSystem system) {
  if (*unit.printed == '\0') return schema;
  // Set the unit of numbers, also those of lists and maps.
  if (schema.element) {
    schema.element = std::make_shared<Schema>(with_unit(*schema.element, unit, system));
  } else if (schema.kind == Schema::Kind::kNumber) {
    schema.unit = unit_words(system == UnitSystem::kSi ? unit.si : unit.printed);
    // Convert the bounds, which are in SI.
    if (system == UnitSystem::kPrinted)
      for (double* bound : {&schema.lower, &schema.upper})
        *bound = *bound * unit.numerator / unit.denominator;
  }
  return schema;
}

/// Returns all valid keys, in SI and in printed units.
std::vector<std::string> keys_of(const std::vector<Param>& params) {
  std::vector<std::string> keys;
  for (const Param& param : params) {
    keys.push_back(param.key_in(UnitSystem::kSi));
    const std::string printed = param.key_in(UnitSystem::kPrinted);
    if (printed != keys.back()) keys.push_back(printed);
  }
  return keys;
}

/// Finds the parameter of a key, and the system of units of the key. @throws InputError if none
std::pair<const Param*, UnitSystem> param_of(const std::vector<Param>& params,
                                             const std::string& key) {
  // Compare the key with those of all parameters in both systems.
  for (const UnitSystem system : {UnitSystem::kSi, UnitSystem::kPrinted})
    for (const Param& param : params)
      if (param.key_in(system) == key) return {&param, system};
  // Report an unknown key, cut to a readable length.
  const std::vector<std::string> keys = keys_of(params);
  throw InputError(fmt::format("no parameter '{}'{} there are {}", key.substr(0, 40),
                               hint_before_list(key.substr(0, 40), keys), listed(keys)),
                   key);
}

}  // namespace

std::string Param::key_in(UnitSystem system) const { return key_with(member.name, unit, system); }

Schema Param::schema_in(UnitSystem system) const { return with_unit(member.schema, unit, system); }

Json request_in_si(const std::vector<Param>& params, const Json& request, RequestSyntax syntax) {
  require(request.is_object(), "wanted a request with names and values, got {}",
          json_text(request, -1).substr(0, 40));
  Json si = Json::object();
  for (const auto& [key, value] : request.items()) {
    // Check the value in the unit of its key, then convert it.
    const auto [param, system] = param_of(params, key);
    const std::string& name = param->member.name;
    try {
      require(!si.contains(name), "'{}' is given twice, in two units", name);
      const Json fits = validated(param->schema_in(system), value, key, syntax);
      si[name] = system == UnitSystem::kSi ? fits : from_printed(fits, param->unit);
    } catch (const InputError& error) {
      throw InputError(error.what(), name);
    }
  }
  // Check that all required parameters are there, in either unit.
  for (const Param& param : params)
    if (param.member.required && !si.contains(param.member.name))
      throw InputError(fmt::format("'{}' is missing: {}", param.key_in(UnitSystem::kSi),
                                   param.member.description),
                       param.member.name);
  return si;
}

Schema schema_of(const std::vector<Param>& params, ParamScope scope) {
  std::vector<SchemaMember> members;
  for (const Param& param : params) {
    if (scope == ParamScope::kAnywhere && param.scope == ParamScope::kLocal) continue;
    SchemaMember member = param.member;
    member.name = param.key_in(UnitSystem::kSi);
    member.schema = param.schema_in(UnitSystem::kSi);
    if (member.required) member.default_value = nullptr;
    members.push_back(std::move(member));
  }
  return object_schema(std::move(members));
}

void read_value(const Json& json, double& value) { value = number_of(json); }

void read_value(const Json& json, Eigen::Vector3d& value) {
  for (int i = 0; i < 3; ++i) value[i] = json[static_cast<std::size_t>(i)].get<double>();
}

void read_value(const Json& json, std::map<std::string, double>& value) {
  value.clear();
  for (const auto& [name, number] : json.items()) value[name] = number_of(number);
}

Json value_json(double value) {
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  return number_or_null(value);
}

Json value_json(const std::string& value) { return value.empty() ? Json() : Json(value); }

Json value_json(const std::vector<std::string>& value) {
  return value.empty() ? Json() : Json(value);
}

Json value_json(const Eigen::Vector3d& value) { return to_json(value); }

Json value_json(const std::map<std::string, double>& value) {
  Json json;
  for (const auto& [name, number] : value) json[name] = value_json(number);
  return json;
}

}  // namespace thenar
