#pragma once

/// Vectors, matrices and named numbers as JSON, and JSON as text. Infinite numbers become null.

#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace thenar {

/// A vector as a list, a matrix as a list of rows.
template <typename Derived>
[[nodiscard]] nlohmann::json to_json(const Eigen::MatrixBase<Derived>& values) {
  nlohmann::json list = nlohmann::json::array();
  if constexpr (Derived::IsVectorAtCompileTime) {
    for (Eigen::Index i = 0; i < values.size(); ++i) list.push_back(values(i));
  } else {
    for (Eigen::Index i = 0; i < values.rows(); ++i) list.push_back(to_json(values.row(i)));
  }
  return list;
}

/// {"FDP": 10, ...} in the order of the names.
template <typename Derived>
[[nodiscard]] nlohmann::ordered_json to_json(const std::vector<std::string>& names,
                                             const Eigen::MatrixBase<Derived>& values) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < names.size(); ++i)
    object[names[i]] = values(static_cast<Eigen::Index>(i));
  return object;
}

/// JSON as text. Bytes that are not UTF-8, as in names of files of others, become U+FFFD.
/// @param indent  spaces a level; -1: all on one line
template <typename Json>
[[nodiscard]] std::string json_text(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace thenar
