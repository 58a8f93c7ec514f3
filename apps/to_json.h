#pragma once

/// Vectors, matrices and named numbers as JSON. Infinite numbers become null.

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

}  // namespace thenar
