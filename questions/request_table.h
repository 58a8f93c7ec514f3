#pragma once

/// Table of the parameters of a request: names, units, ranges. Reading and writing of JSON and
/// TOML, command options, and the documentation of server methods are generated from it.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "api/named/posture.h"
#include "base/enum_names.h"
#include "base/lists.h"
#include "questions/schema.h"
#include "report/fields.h"

namespace thenar {

/// Clients that may set a parameter.
enum class ParamScope {
  kAnywhere,  // commands, files and clients of a server
  kLocal      // commands and files only: data folders, files that are written
};

/// Description of one parameter.
struct Param {
  SchemaMember member;  // key without unit, schema in SI
  FieldUnit unit;       // unit of all numbers
  // Names of command options, separated by commas; a "!" marks an option that clears a flag:
  // "approach,!no-approach". Empty: no option; absent: an option named after the key.
  std::optional<std::string> option = {};
  std::string form = "NAME=number";  // syntax of a number by name: "MUSCLE=newton"
  ParamScope scope = ParamScope::kAnywhere;
  bool is_positional = false;        // true: a positional argument of commands
  bool is_twin = false;              // true: the previous parameter in another unit
  std::string off_description = {};  // help of the options that clear a flag, one sentence

  /// Returns the key with its unit: "hold_length_m", "hold_length_mm".
  [[nodiscard]] std::string key_in(UnitSystem system) const;
  /// Returns the schema of its value in a system of units.
  [[nodiscard]] Schema schema_in(UnitSystem system) const;
};

/// Checks a request, and converts it to SI with keys without units.
/// @param request  object whose keys have SI or printed units
/// @param syntax   language in which it was written
/// @throws InputError with the field, for an unknown key, a key given in two units, an invalid
///         value or a missing parameter
[[nodiscard]] Json request_in_si(const std::vector<Param>& params, const Json& request,
                                 RequestSyntax syntax = RequestSyntax::kJson);

/// Returns the schema of a request whose keys have SI units.
/// @param scope  kAnywhere: without local parameters
[[nodiscard]] Schema schema_of(const std::vector<Param>& params, ParamScope scope);

// Conversion of the members of requests from and to JSON, in SI. An empty value is null.
template <typename Value>
void read_value(const Json& json, Value& value) {
  value = json.get<Value>();
}
void read_value(const Json& json, double& value);
void read_value(const Json& json, Eigen::Vector3d& value);
void read_value(const Json& json, std::map<std::string, double>& value);
template <typename Value>
void read_value(const Json& json, std::optional<Value>& value) {
  read_value(json, value.emplace());
}
template <typename Value>
[[nodiscard]] Json value_json(const Value& value) {
  return value;
}
[[nodiscard]] Json value_json(double value);
[[nodiscard]] Json value_json(const std::string& value);
[[nodiscard]] Json value_json(const std::vector<std::string>& value);
[[nodiscard]] Json value_json(const Eigen::Vector3d& value);
[[nodiscard]] Json value_json(const std::map<std::string, double>& value);
template <typename Value>
[[nodiscard]] Json value_json(const std::optional<Value>& value) {
  return value ? value_json(*value) : Json();
}

/// Parameters of one kind of request, with a setter and a getter for each.
template <typename Request>
class RequestTable {
 public:
  using Setter = std::function<void(Request& request, const Json& value)>;
  using Getter = std::function<Json(const Request& request)>;

  /// Adds a parameter. @param get  getter of its value in SI; null: the value is missing
  Param& add(Param param, Setter set, Getter get) {
    if (!param.option) param.option = option_of(param.member.name);
    param.member.default_value = get(Request());
    params_.push_back(std::move(param));
    setters_.push_back(std::move(set));
    getters_.push_back(std::move(get));
    return params_.back();
  }
  /// Adds a member of the request as a parameter. @param option  as Param::option
  template <typename Value>
  Param& add(const std::string& key, const FieldUnit& unit, Schema schema, Value Request::*member,
             const std::string& about, const std::optional<std::string>& option = {}) {
    return add(
        {{key, std::move(schema), about}, unit, option},
        [member](Request& request, const Json& value) { read_value(value, request.*member); },
        [member](const Request& request) { return value_json(request.*member); });
  }
  /// Adds a member without a unit.
  template <typename Value>
  Param& add(const std::string& key, Schema schema, Value Request::*member,
             const std::string& about, const std::optional<std::string>& option = {}) {
    return add(key, units::kOne, std::move(schema), member, about, option);
  }
  /// Adds a required name or file, or a list of them: a positional argument of commands.
  template <typename Value>
  void add_argument(const std::string& key, Value Request::*member, const std::string& about,
                    Schema schema = text_schema()) {
    Param& param = add(key, std::move(schema), member, about);
    param.is_positional = param.member.required = true;
  }
  /// Adds a member of an enumeration type, or an optional one.
  template <typename Enum, std::size_t size, typename Value>
  Param& add_word(const std::string& key, const std::array<EnumName<Enum>, size>& names,
                  Value Request::*member, const std::string& about,
                  const std::optional<std::string>& option = {}) {
    return add(
        {{key, word_schema(names_in(names)), about}, units::kOne, option},
        [=](Request& request, const Json& value) {
          request.*member = value_in(names, value.get<std::string>(), key, key);
        },
        [=](const Request& request) {
          const std::optional<Enum> value = request.*member;
          return value ? Json(name_in(names, *value)) : Json();
        });
  }
  /// Adds a list of values of an enumeration type. @param kind  as of value_in()
  template <typename Enum, std::size_t size>
  Param& add_words(const std::string& key, const Schema& schema, const std::string& kind,
                   const std::array<EnumName<Enum>, size>& names,
                   std::vector<Enum> Request::*member, const std::string& about,
                   const std::optional<std::string>& option = {}) {
    return add(
        {{key, schema, about}, units::kOne, option},
        [=](Request& request, const Json& value) {
          (request.*member).clear();
          for (const Json& each : value)
            (request.*member).push_back(value_in(names, each.get<std::string>(), kind, key));
        },
        [=](const Request& request) {
          return value_json(
              transformed(request.*member, [&](Enum each) { return name_in(names, each); }));
        });
  }
  /// Adds the parameters of a nested part of the request.
  template <typename Part>
  void include(const RequestTable<Part>& table, Part Request::*part) {
    for (std::size_t i = 0; i < table.params().size(); ++i)
      add(
          table.params()[i],
          [=](Request& request, const Json& value) { table.set(i, request.*part, value); },
          [=](const Request& request) { return table.get(i, request.*part); });
  }

  [[nodiscard]] const std::vector<Param>& params() const { return params_; }
  void set(std::size_t i, Request& request, const Json& value) const {
    setters_[i](request, value);
  }
  [[nodiscard]] Json get(std::size_t i, const Request& request) const {
    return getters_[i](request);
  }

  /// Reads a request from JSON. @throws InputError as request_in_si()
  [[nodiscard]] Request read(const Json& json) const {
    const Json si = request_in_si(params_, json);
    Request request;
    for (std::size_t i = 0; i < params_.size(); ++i)
      if (si.contains(params_[i].member.name)) set(i, request, si[params_[i].member.name]);
    return request;
  }
  /// Writes a request as JSON in SI, with default values; missing values are left out.
  [[nodiscard]] OrderedJson write(const Request& request) const {
    OrderedJson json = OrderedJson::object();
    for (std::size_t i = 0; i < params_.size(); ++i) {
      const Json value = get(i, request);
      if (!value.is_null()) json[params_[i].key_in(UnitSystem::kSi)] = value;
    }
    return json;
  }

 private:
  [[nodiscard]] static std::string option_of(std::string key) {
    for (char& c : key)
      if (c == '_') c = '-';
    return key;
  }

  std::vector<Param> params_;
  std::vector<Setter> setters_;
  std::vector<Getter> getters_;
};

}  // namespace thenar
