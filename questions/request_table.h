#pragma once

/// Parameters of a request by name, unit and range: one table from which requests are read and
/// written as JSON and TOML, options of commands are made, and methods of servers are documented.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "api/named/posture.h"
#include "base/enum_names.h"
#include "questions/schema.h"
#include "report/fields.h"

namespace thenar {

/// Who may set a parameter.
enum class ParamScope {
  kAnywhere,  // commands, files and clients of a server
  kLocal      // not clients of a server: folders of data, files that are written
};

/// Description of one parameter.
struct Param {
  SchemaMember member;  // its key without a unit, its values in SI
  FieldUnit unit;       // of all its numbers
  // Names of options of commands, with commas between, "!" before those that say the opposite of a
  // flag: "approach,!no-approach"; "": none; absent: by its key.
  std::optional<std::string> option = {};
  std::string form = "NAME=number";  // how a number by name is typed: "MUSCLE=newton"
  ParamScope scope = ParamScope::kAnywhere;
  bool is_positional = false;  // of commands: a plain argument
  bool is_twin = false;        // of the parameter before it, in another unit
  std::string off_about = {};  // one sentence: help of the options that turn a flag off

  /// "hold_length_m", "hold_length_mm"
  [[nodiscard]] std::string key_in(UnitSystem system) const;
  /// The schema of its value in either system of units.
  [[nodiscard]] Schema schema_in(UnitSystem system) const;
};

/// The key of a parameter that a request has, in SI: values checked, names resolved.
/// @param request  an object whose keys bear SI or printed units
/// @throws InputError with the field, for a key that is unknown or given in two units, a value of
/// another type or out of range, or a parameter that is missing
[[nodiscard]] Json request_in_si(const std::vector<Param>& params, const Json& request);

/// Schema of an object whose members bear units in SI.
[[nodiscard]] Schema schema_of(const std::vector<Param>& params, ParamScope scope);

// Members of requests from and to JSON, in SI. What is absent is null.
template <typename Value>
void take(const Json& json, Value& value) {
  value = json.get<Value>();
}
void take(const Json& json, double& value);
void take(const Json& json, Eigen::Vector3d& value);
void take(const Json& json, std::map<std::string, double>& value);
template <typename Value>
void take(const Json& json, std::optional<Value>& value) {
  take(json, value.emplace());
}
template <typename Value>
[[nodiscard]] Json give(const Value& value) {
  return value;
}
[[nodiscard]] Json give(double value);
[[nodiscard]] Json give(const std::string& value);
[[nodiscard]] Json give(const std::vector<std::string>& value);
[[nodiscard]] Json give(const Eigen::Vector3d& value);
[[nodiscard]] Json give(const std::map<std::string, double>& value);
template <typename Value>
[[nodiscard]] Json give(const std::optional<Value>& value) {
  return value ? give(*value) : Json();
}

/// The parameters of one kind of request, and how each is set and got.
template <typename Request>
class RequestTable {
 public:
  using Setter = std::function<void(Request& request, const Json& value)>;
  using Getter = std::function<Json(const Request& request)>;

  /// Adds a parameter. @param get  its value in SI; null: left out
  Param& add(Param param, Setter set, Getter get) {
    if (!param.option) param.option = option_of(param.member.name);
    param.member.usual = get(Request());
    params_.push_back(std::move(param));
    setters_.push_back(std::move(set));
    getters_.push_back(std::move(get));
    return params_.back();
  }
  /// Adds a member of the request. @param option  as Param::option
  template <typename Value>
  Param& add(const std::string& key, const FieldUnit& unit, Schema schema, Value Request::*member,
             const std::string& about, const std::optional<std::string>& option = {}) {
    return add(
        {{key, std::move(schema), about}, unit, option},
        [member](Request& request, const Json& value) { take(value, request.*member); },
        [member](const Request& request) { return give(request.*member); });
  }
  /// Adds a member that has no unit.
  template <typename Value>
  Param& add(const std::string& key, Schema schema, Value Request::*member,
             const std::string& about, const std::optional<std::string>& option = {}) {
    return add(key, units::kOne, std::move(schema), member, about, option);
  }
  /// Adds a name or a file, or several, that are needed: a plain argument of commands.
  template <typename Value>
  void add_argument(const std::string& key, Value Request::*member, const std::string& about,
                    Schema schema = text_schema()) {
    Param& param = add(key, std::move(schema), member, about);
    param.is_positional = param.member.required = true;
  }
  /// Adds a word of an enumeration, or of one that may be left out.
  template <typename Enum, std::size_t size, typename Value>
  Param& add_word(const std::string& key, const std::array<EnumName<Enum>, size>& names,
                  Value Request::*member, const std::string& about,
                  const std::optional<std::string>& option = {}) {
    return add(
        {{key, word_schema(names_in(names)), about}, units::kOne, option},
        [=](Request& request, const Json& value) {
          request.*member = value_in(names, value.get<std::string>(), key);
        },
        [=](const Request& request) {
          const std::optional<Enum> value = request.*member;
          return value ? Json(name_in(names, *value)) : Json();
        });
  }
  /// Adds the parameters of a part of the request.
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

  /// A request from an object. @throws InputError as request_in_si()
  [[nodiscard]] Request read(const Json& json) const {
    const Json si = request_in_si(params_, json);
    Request request;
    for (std::size_t i = 0; i < params_.size(); ++i)
      if (si.contains(params_[i].member.name)) set(i, request, si[params_[i].member.name]);
    return request;
  }
  /// The request as an object in SI, usual values included; what is left out stays out.
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
