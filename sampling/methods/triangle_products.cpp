#include "sampling/methods/triangle_products.h"

#include "base/for_all_processors.h"

namespace thenar::internal {
namespace {

constexpr long kBlockColumns = 4;   // number of columns computed at a time
constexpr long kRegisterLanes = 8;  // number of doubles in a register of the widest SIMD unit

/// Adds four columns times y to x, from row `first` on.
THENAR_FOR_ALL_PROCESSORS
void add_columns(const double* F, long n, long first, const double* y, double* x) {
  const double *a = F, *b = F + n, *c = F + 2 * n, *d = F + 3 * n;
  const double y0 = y[0], y1 = y[1], y2 = y[2], y3 = y[3];
  for (long i = first; i < n; ++i) x[i] += (a[i] * y0 + b[i] * y1) + (c[i] * y2 + d[i] * y3);
}

/// Eight doubles, in as many registers as necessary.
using Lanes =
    double __attribute__((vector_size(kRegisterLanes * sizeof(double)), aligned(8), may_alias));

/// Computes products of four columns with g, from row `first` on, each by eight partial sums.
THENAR_FOR_ALL_PROCESSORS
void column_products(const double* F, long n, long first, const double* g, double* out) {
  const double *a = F, *b = F + n, *c = F + 2 * n, *d = F + 3 * n;
  Lanes sums[kBlockColumns] = {};
  long i = first;
  for (; i + kRegisterLanes <= n; i += kRegisterLanes) {
    const Lanes value = *reinterpret_cast<const Lanes*>(g + i);
    sums[0] += *reinterpret_cast<const Lanes*>(a + i) * value;
    sums[1] += *reinterpret_cast<const Lanes*>(b + i) * value;
    sums[2] += *reinterpret_cast<const Lanes*>(c + i) * value;
    sums[3] += *reinterpret_cast<const Lanes*>(d + i) * value;
  }
  // Add the remaining rows, and combine the partial sums in fixed order.
  for (long column = 0; column < kBlockColumns; ++column) {
    double s[kRegisterLanes];
    for (long k = 0; k < kRegisterLanes; ++k) s[k] = sums[column][k];
    for (long row = i, k = 0; row < n; ++row, ++k) s[k] += F[column * n + row] * g[row];
    out[column] = ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
  }
}

}  // namespace

void add_product(const Eigen::MatrixXd& F, Shape shape, const Eigen::VectorXd& y,
                 Eigen::VectorXd& x) {
  const long n = F.rows();
  long column = 0;
  for (; column + kBlockColumns <= n; column += kBlockColumns)
    add_columns(F.data() + column * n, n, shape == Shape::kLower ? column : 0, y.data() + column,
                x.data());
  for (; column < n; ++column) x += F.col(column) * y[column];
}

void transposed_product(const Eigen::MatrixXd& F, Shape shape, const Eigen::VectorXd& g,
                        Eigen::VectorXd& out) {
  // Number of rows below which the combination of partial sums is too expensive
  constexpr long kMinSummedRows = 64;
  const long n = F.rows();
  if (n < kMinSummedRows) {
    out.noalias() = F.transpose() * g;
    return;
  }
  out.resize(n);
  long column = 0;
  for (; column + kBlockColumns <= n; column += kBlockColumns)
    column_products(F.data() + column * n, n, shape == Shape::kLower ? column : 0, g.data(),
                    out.data() + column);
  for (; column < n; ++column) out[column] = F.col(column).dot(g);
}

}  // namespace thenar::internal
