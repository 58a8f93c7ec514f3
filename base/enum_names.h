#pragma once

/// Tables of enumeration values and their names, for conversion both ways.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/nearest_name.h"

namespace thenar {

/// Value with its name.
template <typename Enum>
struct EnumName {
  Enum value;
  const char* name;
};
template <typename Enum>
EnumName(Enum, const char*) -> EnumName<Enum>;

/// Returns the names of a table, in its order.
template <typename Enum, std::size_t size>
[[nodiscard]] std::vector<std::string> names_in(const std::array<EnumName<Enum>, size>& table) {
  std::vector<std::string> names;
  for (const EnumName<Enum>& each : table) names.emplace_back(each.name);
  return names;
}

/// Returns the name of a value; "" if the table lacks it.
template <typename Enum, std::size_t size>
[[nodiscard]] std::string name_in(const std::array<EnumName<Enum>, size>& table, Enum value) {
  for (const EnumName<Enum>& each : table)
    if (each.value == value) return each.name;
  return "";
}

/// Returns the value of a name.
/// @param kind, field  as of index_of_name(): "fit method", "method"
/// @throws InputError as index_of_name() for a name that the table lacks
template <typename Enum, std::size_t size>
[[nodiscard]] Enum value_in(const std::array<EnumName<Enum>, size>& table, const std::string& name,
                            const std::string& kind, const std::string& field = "") {
  return table[index_of_name(name, names_in(table), kind, field)].value;
}

}  // namespace thenar
