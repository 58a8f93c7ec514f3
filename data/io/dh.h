#pragma once

/// Conversion between Denavit-Hartenberg parameters and joint axes.
///
/// Standard (distal) convention: joint i turns about z of frame i-1, and
///   X_(i-1,i) = Rz(theta + q) Tz(d) Tx(a) Rx(alpha).
/// Source: [Denavit1955].

#include <vector>

#include "base/spatial.h"

namespace thenar {

/// One row of a Denavit-Hartenberg table, at joint angle zero.
struct DhRow {
  double theta = 0;  // rotation about z of the previous frame [rad]
  double d = 0;      // translation along z of the previous frame [m]
  double a = 0;      // translation along the common normal [m]
  double alpha = 0;  // twist between the axes       [rad]
};

/// A joint axis as a line.
struct AxisLine {
  Eigen::Vector3d point{0, 0, 0};      // any point of it [m] (3)
  Eigen::Vector3d direction{0, 0, 1};  // unit (3)
};

/// A whole chain:  X_end = base * row_1 * .. * row_n * tool.
struct DhChain {
  Pose<double> base;        // base frame; its z is the first axis
  std::vector<DhRow> rows;  // one row for each axis
  Pose<double> tool;        // pose of the end frame in the last row's frame
};

class TomlTable;

/// Reads the four numbers of a row; absent ones are 0.
[[nodiscard]] DhRow read_dh_row(TomlTable& table);

/// Returns the displacement across one row, at joint angle zero.
[[nodiscard]] Pose<double> dh_motion(const DhRow& row);

/// Returns the table for given axes, by their common normals; exact for skew, parallel,
/// intersecting and coincident neighbours. The remaining freedom is fixed as follows: the base
/// includes theta and d of row 1, the last row reaches the tip point, and `tool` is a pure
/// rotation.
/// @param tip  end frame at joint angles zero
/// @throws InputError for no axes.
[[nodiscard]] DhChain dh_from_axes(const std::vector<AxisLine>& axes, const Pose<double>& tip);

}  // namespace thenar
