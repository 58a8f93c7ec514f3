#pragma once

/// Quantities that vary over the rows of an answer: columns of tables, titles of pictures, curves
/// of charts.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "api/named/posture.h"
#include "report/json.h"

namespace thenar {

/// Values of everything that varies, row by row; nothing varies in an answer of one row.
struct SweepAxes {
  std::vector<std::string> names;  // names of joints; the last one varies fastest
  std::vector<std::string> units;  // unit of each: "deg" or "mm"
  Eigen::MatrixXd values;          // values in these units (rows, names)
  std::size_t row = 1;             // rows that differ in the last one only

  [[nodiscard]] bool single() const { return names.empty(); }
};

/// Returns the joints of a grid that vary. @param done  postures that have an answer
[[nodiscard]] SweepAxes axes_of(const PostureGrid& grid, const std::vector<std::string>& joints,
                                std::size_t done);

/// Returns "PIP3_deg" of each that varies.
[[nodiscard]] std::vector<std::string> header_of(const SweepAxes& axes);
/// Returns their values at a row as cells.
[[nodiscard]] std::vector<std::string> cells_of(const SweepAxes& axes, std::size_t row);
/// Returns "PIP3 = 30 deg, DIP3 = 10 deg"; "" of an answer of one row.
[[nodiscard]] std::string title_of(const SweepAxes& axes, std::size_t row);

/// One quantity over all rows; NaN where there is none.
struct Curve {
  std::string name;
  Eigen::VectorXd y;  // (rows)
};

/// Returns a chart of curves over what varies fastest, a family of them where two vary. Values
/// below 1e-9 are 0.
[[nodiscard]] Json curve_chart(const SweepAxes& axes, const std::string& caption,
                               const std::string& y_label, const std::vector<Curve>& curves);

/// Returns rows to draw, evenly spread, the first and the last among them.
[[nodiscard]] std::vector<std::size_t> drawn_rows(std::size_t count, std::size_t most);

}  // namespace thenar
