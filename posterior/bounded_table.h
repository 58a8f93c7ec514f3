#pragma once

/// The map of base/bounded_normal.h from a table, many points at once.

#include <vector>

#include "base/bounded_normal.h"
#include "posterior/simd_loops.h"

namespace thenar {

/// The map of a BoundedNormal from a table: polynomials of degree 5 in cells of 1/64, which meet
/// with equal value, slope and curvature. Off by less than 1e-10 [prior sds]; beyond |x| = 8.5
/// exact.
class BoundedTable {
 public:
  explicit BoundedTable(const BoundedNormal& exact);

  struct Image {
    double z, by_x;
  };
  [[nodiscard]] Image at(double x) const;
  /// scale z and scale dz/dx of eight points.
  void at_block(const double* x, double scale, double* y, double* by_x) const;
  [[nodiscard]] double inverse(double z) const;

 private:
  BoundedNormal exact_;
  std::vector<double> coefficients_;
};

}  // namespace thenar
