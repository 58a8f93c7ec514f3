#include "posterior/bounded_table.h"

#include <array>
#include <cmath>

namespace thenar {
namespace {

constexpr double kTableReach = 8.5;  // half width of the table's range about 0 [1]
constexpr int kCellsPerUnit = 64;    // number of cells per unit of x
constexpr int kCellCount = static_cast<int>(2 * kTableReach * kCellsPerUnit);

/// Returns the cells of a table.
internal::PiecewisePolynomial cells(const std::vector<double>& coefficients) {
  return {coefficients.data(), -kTableReach, kCellsPerUnit, kTableReach};
}

}  // namespace

BoundedTable::BoundedTable(const BoundedNormal& exact) : exact_(exact) {
  constexpr double kCellWidth = 1.0 / kCellsPerUnit;  // width of a cell [1]
  // z, z' = Z phi(x) / phi(z) and z'' = z' (z z' - x) at the ends of the cells, in cell widths.
  const auto node = [&](int i) -> std::array<double, 3> {
    const double x = -kTableReach + i * kCellWidth;
    const BoundedNormal::Image at = exact.evaluate(x);
    return {at.z, at.by_x * kCellWidth, at.by_x * (at.z * at.by_x - x) * kCellWidth * kCellWidth};
  };
  std::array<double, 3> a = node(0);
  for (int i = 0; i < kCellCount; ++i) {
    // Compute the far end of this cell.
    const std::array<double, 3> b = node(i + 1);
    // Residuals at the far end determine the terms of degree 3 to 5.
    const double p = b[0] - a[0] - a[1] - a[2] / 2, q = b[1] - a[1] - a[2], r = b[2] - a[2];
    for (const double c :
         {a[0], a[1], a[2] / 2, 10 * p - 4 * q + r / 2, -15 * p + 7 * q - r, 6 * p - 3 * q + r / 2})
      coefficients_.push_back(c);
    a = b;
  }
  // Append a constant cell for the last node.
  for (const double c : {a[0], a[1], a[2] / 2, 0.0, 0.0, 0.0}) coefficients_.push_back(c);
}

void BoundedTable::evaluate_block(const double* x, double scale, double* y, double* by_x) const {
  internal::map_block(cells(coefficients_), x, scale, y, by_x);
  for (int k = 0; k < internal::kBlockPoints; ++k) {
    if (std::abs(x[k]) <= kTableReach) continue;
    const BoundedNormal::Image image = exact_.evaluate(x[k]);
    y[k] = scale * image.z;
    by_x[k] = scale * image.by_x;
  }
}

BoundedTable::Image BoundedTable::evaluate(double x) const {
  std::array<double, internal::kBlockPoints> same, z, by_x;
  same.fill(x);
  evaluate_block(same.data(), 1, z.data(), by_x.data());
  return {z[0], by_x[0]};
}

double BoundedTable::inverse(double z) const {
  const double start = exact_.inverse(z);
  // One Newton step corrects the error of the table.
  const Image near = evaluate(start);
  return near.by_x > 0 ? start + (exact_.evaluate(start).z - near.z) / near.by_x : start;
}

}  // namespace thenar
