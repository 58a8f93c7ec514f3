#pragma once

/// Inner loops of a posterior over blocks of eight points, compiled for several instruction sets.

#include <vector>

namespace thenar::internal {

inline constexpr int kBlockPoints = 8;  // points of a block: a register of the widest SIMD unit

/// Matrix stored by blocks of eight points: row i of points 8 b .. 8 b + 7 is contiguous. Points
/// beyond the last one pad the last block.
class SimdRows {
 public:
  SimdRows() = default;
  SimdRows(long rows, long points)
      : rows_(rows),
        blocks_((points + kBlockPoints - 1) / kBlockPoints),
        numbers_(static_cast<std::size_t>(rows * blocks_ * kBlockPoints)) {}

  [[nodiscard]] long rows() const { return rows_; }
  [[nodiscard]] long blocks() const { return blocks_; }
  [[nodiscard]] double* row(long block, long i) {
    return numbers_.data() + (block * rows_ + i) * kBlockPoints;
  }
  [[nodiscard]] const double* row(long block, long i) const {
    return numbers_.data() + (block * rows_ + i) * kBlockPoints;
  }
  [[nodiscard]] double& operator()(long i, long point) {
    return row(point / kBlockPoints, i)[point % kBlockPoints];
  }
  [[nodiscard]] double operator()(long i, long point) const {
    return row(point / kBlockPoints, i)[point % kBlockPoints];
  }

 private:
  long rows_ = 0, blocks_ = 0;
  std::vector<double> numbers_;
};

// The instruction set is chosen at run time. All versions give the same bits: no sum is reordered,
// and no multiplication is fused (-ffp-contract=off).

/// Piecewise polynomial of degree 5 on cells of equal width.
struct PiecewisePolynomial {
  const double* coefficients;  // six per cell, constant term first
  double start, per_unit;      // start of the first cell; number of cells per unit
  double last;                 // end of the last cell
};

/// Computes y = scale z(x), by_x = scale dz/dx at eight points; beyond the cells, uses the values
/// at their ends.
void map_block(const PiecewisePolynomial& map, const double* x, double scale, double* y,
               double* by_x);

/// Computes y = scale x, by_x = scale at eight points.
void scale_block(const double* x, double scale, double* y, double* by_x);

/// Computes sum -= x^2 / 2 at eight points.
void subtract_half_square(const double* x, double* sum);

/// Von Mises-Fisher prior of two tilts relative to a normal prior, see TiltDensity.
struct TiltPriorBlock {
  double mean[2], sd;    // [rad]
  double concentration;  // [1/rad^2]
};
/// Adds the log prior without its term -3/2 log w to `sum`, multiplies `product` by w = 1 + |t|^2,
/// and writes the derivatives by the displacements y of the tilts.
void tilt_block(const TiltPriorBlock& prior, const double* y0, const double* y1, double* sum,
                double* product, double* by_y0, double* by_y1);

/// Returns sum (measured - predicted)^2 precision, and writes weight = (measured - predicted)
/// precision scale.
double weigh_residuals(int count, const double* measured, const double* predicted,
                       const double* precision, double scale, double* weight);

}  // namespace thenar::internal
