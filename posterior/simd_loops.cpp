#include "posterior/simd_loops.h"

#include <cmath>

#include "base/for_all_processors.h"

namespace thenar::internal {

THENAR_FOR_ALL_PROCESSORS
void map_block(const PiecewisePolynomial& map, const double* x, double scale, double* y,
               double* by_x) {
  const double* coefficients = map.coefficients;
  const double start = map.start, per_unit = map.per_unit, last = map.last;
  // Find the cell of each point, and the position within it.
  int cell[kBlockPoints];
  double f[kBlockPoints];
  for (int k = 0; k < kBlockPoints; ++k) {
    double at = x[k] > start ? x[k] : start;  // NaN becomes the start
    at = at < last ? at : last;
    const double t = (at - start) * per_unit;
    cell[k] = static_cast<int>(t);
    f[k] = t - static_cast<double>(cell[k]);
  }
  // Evaluate value and derivative of the cell's polynomial by Horner's scheme.
  for (int k = 0; k < kBlockPoints; ++k) {
    const double* c = coefficients + 6 * cell[k];
    const double t = f[k];
    y[k] = scale * (c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5])))));
    by_x[k] = scale * per_unit *
              (c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + t * (5 * c[5])))));
  }
}

THENAR_FOR_ALL_PROCESSORS
void scale_block(const double* x, double scale, double* y, double* by_x) {
  for (int k = 0; k < kBlockPoints; ++k) {
    y[k] = scale * x[k];
    by_x[k] = scale;
  }
}

THENAR_FOR_ALL_PROCESSORS
void subtract_half_square(const double* x, double* sum) {
  for (int k = 0; k < kBlockPoints; ++k) sum[k] -= 0.5 * x[k] * x[k];
}

THENAR_FOR_ALL_PROCESSORS
// NOLINTNEXTLINE(readability-function-size): columns of numbers in, columns of numbers out
void tilt_block(const TiltPriorBlock& prior, const double* y0, const double* y1, double* sum,
                double* product, double* by_y0, double* by_y1) {
  const double c0 = prior.mean[0], c1 = prior.mean[1], concentration = prior.concentration;
  const double precision = 1 / (prior.sd * prior.sd), w_c = 1 + c0 * c0 + c1 * c1;
  for (int k = 0; k < kBlockPoints; ++k) {
    // Tilts, and the weights of their solid angles.
    const double a = y0[k], b = y1[k], t0 = c0 + a, t1 = c1 + b;
    const double w = 1 + t0 * t0 + t1 * t1, dot = 1 + t0 * c0 + t1 * c1;
    // 1 - cos of the angle to the mean, by Lagrange's identity.
    const double root = std::sqrt(w * w_c), cross = t0 * c1 - t1 * c0, square = a * a + b * b;
    const double away = (square + cross * cross) / (root * (root + dot));
    // Log density over that of normal tilts; the logarithm of w is added at the end.
    sum[k] += 0.5 * precision * square - concentration * away;
    product[k] *= w;
    // Derivatives by both tilts.
    const double pull = concentration / root, along = (pull * dot + 3) / w;
    by_y0[k] = pull * c0 - along * t0 + precision * a;
    by_y1[k] = pull * c1 - along * t1 + precision * b;
  }
}

THENAR_FOR_ALL_PROCESSORS
double weigh_residuals(int count, const double* measured, const double* predicted,
                       const double* precision, double scale, double* weight) {
  // Accumulate eight partial sums in an order that depends only on the count.
  double sums[kBlockPoints] = {};
  int i = 0;
  for (; i + kBlockPoints <= count; i += kBlockPoints)
    for (int k = 0; k < kBlockPoints; ++k) {
      const double r = measured[i + k] - predicted[i + k], scaled = r * precision[i + k];
      weight[i + k] = scaled * scale;
      sums[k] += r * scaled;
    }
  // Add the remaining numbers.
  for (int k = 0; i < count; ++i, ++k) {
    const double r = measured[i] - predicted[i], scaled = r * precision[i];
    weight[i] = scaled * scale;
    sums[k] += r * scaled;
  }
  return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

}  // namespace thenar::internal
