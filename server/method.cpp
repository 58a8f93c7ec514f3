#include "server/method.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/lists.h"
#include "base/name_hint.h"

namespace thenar {

std::map<std::string, double> named_numbers(const Json& params, const std::string& member) {
  std::map<std::string, double> numbers;
  if (!params.contains(member)) return numbers;
  for (const auto& [name, value] : params.at(member).items()) numbers[name] = value.get<double>();
  return numbers;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the fields
OrderedJson reply_json(const Fields& fields) {
  OrderedJson json = OrderedJson::object();
  for (const Field& field : fields.all()) {
    const OrderedJson value = field.is_list ? list_of_each<OrderedJson>(field.parts, reply_json)
                              : field.parts.empty()
                                  ? value_in(field.value, field.unit, UnitSystem::kSi)
                                  : reply_json(field.parts.front());
    if (*field.unit.printed == '\0') json[field.key] = value;
    json[key_with(field.key, field.unit, UnitSystem::kSi)] = value;
  }
  return json;
}

void MethodTable::add(RpcMethod method) {
  require(!has_method(method.name), "there are two methods '{}'", method.name);
  methods_.push_back(std::move(method));
}

bool MethodTable::has_method(const std::string& name) const {
  return find_named(methods_, name) != nullptr;
}

const RpcMethod& MethodTable::method_named(const std::string& name) const {
  if (const RpcMethod* found = find_named(methods_, name)) return *found;
  throw InputError(fmt::format("no method '{}'{} session.methods lists all", name,
                               hint_before_list(name, names_of(methods_))));
}

}  // namespace thenar
