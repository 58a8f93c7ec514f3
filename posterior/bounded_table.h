#pragma once

/// Tabulated version of the map in base/bounded_normal.h, for many points at once.

#include <vector>

#include "base/bounded_normal.h"
#include "posterior/simd_loops.h"

namespace thenar {

/// Table of the map of a BoundedNormal: polynomials of degree 5 in cells of width 1/64, joined with
/// continuous value, slope and curvature. The error is below 1e-10 [prior sds]; beyond |x| = 8.5
/// the map is evaluated exactly.
class BoundedTable {
 public:
  explicit BoundedTable(const BoundedNormal& exact);

  /// Value and derivative of the map.
  struct Image {
    double z, by_x;  // z(x) and dz/dx [1]
  };
  /// Evaluates the map at one point.
  [[nodiscard]] Image evaluate(double x) const;
  /// Computes y = scale z(x) and by_x = scale dz/dx at eight points.
  void evaluate_block(const double* x, double scale, double* y, double* by_x) const;
  /// Returns the x with z(x) = z.
  [[nodiscard]] double inverse(double z) const;

 private:
  BoundedNormal exact_;
  std::vector<double> coefficients_;  // polynomials of the cells, six numbers each
};

}  // namespace thenar
