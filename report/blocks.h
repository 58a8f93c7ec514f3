#pragma once

/// The blocks of a report as JSON; what each may hold is in viewer/README.md.

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace thenar {

using Json = nlohmann::json;

/// The number; null where it is not finite.
[[nodiscard]] inline Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

/// A column of a table.
struct Column {
  std::string name;
  std::string unit;  // empty: none
  int digits = -1;   // after the point; -1: four significant
};

[[nodiscard]] Json section(const std::string& id, const std::string& title, const std::string& text,
                           Json blocks);
[[nodiscard]] Json text_block(const std::string& text);
[[nodiscard]] Json row_block(Json blocks);
[[nodiscard]] Json table_block(const std::string& caption, const std::vector<Column>& columns,
                               Json rows);

/// A layer of a scene: what is drawn in one colour, and shown and hidden as one.
[[nodiscard]] Json layer(const std::string& name, const std::string& color, Json items);

/// [x, y, z] in millimetres, from metres.
[[nodiscard]] Json in_mm(const Eigen::Vector3d& p);
/// [x, y, z] as it is.
[[nodiscard]] Json list(const Eigen::Vector3d& v);

}  // namespace thenar
