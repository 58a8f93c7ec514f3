#include "server/method.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/nearest_name.h"

namespace thenar {

std::map<std::string, double> named_numbers(const Json& params, const std::string& member) {
  std::map<std::string, double> numbers;
  if (!params.contains(member)) return numbers;
  for (const auto& [name, value] : params.at(member).items()) numbers[name] = value.get<double>();
  return numbers;
}

void MethodTable::add(RpcMethod method) {
  require(!has(method.name), "there are two methods '{}'", method.name);
  methods_.push_back(std::move(method));
}

bool MethodTable::has(const std::string& name) const {
  return std::any_of(methods_.begin(), methods_.end(),
                     [&](const RpcMethod& method) { return method.name == name; });
}

const RpcMethod& MethodTable::at(const std::string& name) const {
  const auto found = std::find_if(methods_.begin(), methods_.end(),
                                  [&](const RpcMethod& method) { return method.name == name; });
  if (found != methods_.end()) return *found;
  std::vector<std::string> names;
  for (const RpcMethod& method : methods_) names.push_back(method.name);
  throw InputError(
      fmt::format("no method '{}'{}; session.methods lists all", name, did_you_mean(name, names)));
}

}  // namespace thenar
