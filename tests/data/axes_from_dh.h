#pragma once

/// Joint axes of a Denavit-Hartenberg table, the inverse of dh_from_axes().

#include <vector>

#include "data/io/dh.h"

namespace thenar {

/// Axes of a chain at joint angles zero, and the frame at its end.
struct DhAxes {
  std::vector<AxisLine> axes;        // one axis for each row
  std::vector<Pose<double>> frames;  // after each row
};

/// Returns the joint axes of a table of rows, in the frame in which `base` is given.
inline DhAxes axes_from_dh(const Pose<double>& base, const std::vector<DhRow>& rows) {
  DhAxes result;
  Pose<double> X = base;
  for (const DhRow& row : rows) {
    result.axes.push_back({X.p, X.R.col(2)});
    X = X * dh_motion(row);
    result.frames.push_back(X);
  }
  return result;
}

}  // namespace thenar
