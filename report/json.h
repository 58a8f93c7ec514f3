#pragma once

/// Vectors, matrices and named numbers as JSON, and JSON as text. Infinite numbers become null.

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace thenar {

using Json = nlohmann::json;                 // members in alphabetic order: pages
using OrderedJson = nlohmann::ordered_json;  // members in the order they were added: answers

/// Returns the number; null where it is not finite.
[[nodiscard]] inline Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

/// Returns a vector as a list, a matrix as a list of rows.
template <typename Derived>
[[nodiscard]] Json to_json(const Eigen::MatrixBase<Derived>& values) {
  Json list = Json::array();
  if constexpr (Derived::IsVectorAtCompileTime) {
    for (Eigen::Index i = 0; i < values.size(); ++i) list.push_back(values(i));
  } else {
    for (Eigen::Index i = 0; i < values.rows(); ++i) list.push_back(to_json(values.row(i)));
  }
  return list;
}

/// Returns an object in the order of the names: {"FDP": 10, ...}.
template <typename Derived>
[[nodiscard]] OrderedJson to_json(const std::vector<std::string>& names,
                                  const Eigen::MatrixBase<Derived>& values) {
  OrderedJson object = OrderedJson::object();
  for (std::size_t i = 0; i < names.size(); ++i)
    object[names[i]] = values(static_cast<Eigen::Index>(i));
  return object;
}

/// Returns a list with the result of a function for each item, or a member of each.
template <typename List = Json, typename Items, typename Make>
[[nodiscard]] List list_of_each(const Items& items, const Make& make) {
  List list = List::array();
  for (const auto& item : items) list.push_back(std::invoke(make, item));
  return list;
}

/// Returns JSON as text. Bytes that are not UTF-8, for example in file names, become U+FFFD.
/// @param indent  spaces a level; -1: all on one line
template <typename AnyJson>
[[nodiscard]] std::string json_text(const AnyJson& json, int indent = 2) {
  return json.dump(indent, ' ', false, AnyJson::error_handler_t::replace);
}

}  // namespace thenar
