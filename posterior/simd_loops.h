#pragma once

/// Inner loops of a posterior over blocks of eight points, compiled for several processors.

#include <vector>

namespace thenar::internal {

inline constexpr int kBlockPoints = 8;  // Points of a block: a register of the widest unit

/// Row i of points 8 b .. 8 b + 7 is contiguous. Points beyond the last fill up the last block.
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

// The processor is asked at run time. All versions give the same bits: no sum is reordered, and no
// multiplication is fused (-ffp-contract=off).

/// A map in cells of equal width, each a polynomial of degree 5.
struct PiecewisePolynomial {
  const double* coefficients;  // six of each cell, constant term first
  double start, per_unit;      // where the first cell begins; cells per unit
  double last;                 // where the last one ends
};

/// y = scale z(x), by_x = scale dz/dx at eight points; beyond the cells, the values at their ends.
void map_block(const PiecewisePolynomial& map, const double* x, double scale, double* y,
               double* by_x);

/// y = scale x.
void scale_block(const double* x, double scale, double* y, double* by_x);

/// sum -= x^2 / 2 at eight points.
void subtract_half_square(const double* x, double* sum);

/// A von Mises-Fisher prior of two tilts relative to a normal prior, see TiltDensity.
struct TiltPriorBlock {
  double mean[2], sd;    // [rad]
  double concentration;  // [1/rad^2]
};
/// Adds to `sum` the part of its logarithm without -3/2 log w, multiplies `product` by w = 1 +
/// |t|^2 and gives the derivatives by y, the tilts' displacements.
void tilt_block(const TiltPriorBlock& prior, const double* y0, const double* y1, double* sum,
                double* product, double* by_y0, double* by_y1);

/// Returns sum (measured - predicted)^2 precision, and gives weight = (measured - predicted)
/// precision scale.
double weigh_residuals(int count, const double* measured, const double* predicted,
                       const double* precision, double scale, double* weight);

}  // namespace thenar::internal
