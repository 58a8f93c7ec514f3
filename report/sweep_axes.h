#pragma once

/// Quantities that vary over the rows of a result: columns of tables, titles of pictures, curves of
/// charts.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "api/named/posture.h"
#include "report/json.h"

namespace thenar {

/// Values of all varied joints, row by row; a result with one row has none.
struct SweepAxes {
  std::vector<std::string> names;  // names of joints; the last one varies fastest
  std::vector<std::string> units;  // unit of each: "deg" or "mm"
  Eigen::MatrixXd values;          // values in these units (rows, names)
  std::size_t row_length = 1;      // number of consecutive rows that differ in the last joint only

  [[nodiscard]] bool single() const { return names.empty(); }
};

/// Returns the joints of a grid that vary. @param done  number of postures with a result
[[nodiscard]] SweepAxes axes_of(const PostureGrid& grid, const std::vector<std::string>& joints,
                                std::size_t done);

/// Returns the column names of the joints that vary: "PIP3_deg".
[[nodiscard]] std::vector<std::string> header_of(const SweepAxes& axes);
/// Returns the values of these joints in a row as cells.
[[nodiscard]] std::vector<std::string> cells_of(const SweepAxes& axes, std::size_t row);
/// Returns a title for a row: "PIP3 = 30 deg, DIP3 = 10 deg"; "" if nothing varies.
[[nodiscard]] std::string title_of(const SweepAxes& axes, std::size_t row);

/// One quantity over all rows; NaN where it has no value.
struct Curve {
  std::string name;
  Eigen::VectorXd y;  // (rows)
};

/// Returns a chart of curves over the joint that varies fastest, a family of curves if two vary.
/// Values below 1e-9 are 0.
[[nodiscard]] Json curve_chart(const SweepAxes& axes, const std::string& caption,
                               const std::string& y_label, const std::vector<Curve>& curves);

/// Returns the indices of at most `most` evenly spread rows, including the first and the last.
[[nodiscard]] std::vector<std::size_t> drawn_rows(std::size_t count, std::size_t most);

}  // namespace thenar
