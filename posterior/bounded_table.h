#pragma once

/// Tabulated map of base/bounded_normal.h, for many points at once.

#include <vector>

#include "base/bounded_normal.h"
#include "posterior/simd_loops.h"

namespace thenar {

/// The map of a BoundedNormal from a table: polynomials of degree 5 in cells of width 1/64, which
/// join with equal value, slope and curvature. The error is below 1e-10 [prior sds]; beyond
/// |x| = 8.5 the map is exact.
class BoundedTable {
 public:
  explicit BoundedTable(const BoundedNormal& exact);

  struct Image {
    double z, by_x;  // z(x) and dz/dx [1]
  };
  [[nodiscard]] Image at(double x) const;
  /// y = scale z(x) and by_x = scale dz/dx at eight points.
  void at_block(const double* x, double scale, double* y, double* by_x) const;
  [[nodiscard]] double inverse(double z) const;

 private:
  BoundedNormal exact_;
  std::vector<double> coefficients_;
};

}  // namespace thenar
