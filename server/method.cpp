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
