#include "sampling/methods/triangle_products.h"

// Sanitizers of addresses and threads are not awake yet when the loader picks a version.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define THENAR_FOR_ALL_PROCESSORS __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define THENAR_FOR_ALL_PROCESSORS
#endif

namespace thenar::internal {
namespace {

constexpr long kColumns = 4;  // at a time
constexpr long kLanes = 8;    // numbers of a register of the widest unit

/// x += sum of four columns, from row `first` on.
THENAR_FOR_ALL_PROCESSORS
void add_columns(const double* F, long n, long first, const double* y, double* x) {
  const double *a = F, *b = F + n, *c = F + 2 * n, *d = F + 3 * n;
  const double y0 = y[0], y1 = y[1], y2 = y[2], y3 = y[3];
  for (long i = first; i < n; ++i) x[i] += (a[i] * y0 + b[i] * y1) + (c[i] * y2 + d[i] * y3);
}

/// Products of four columns with g, from row `first` on, each as eight sums side by side.
THENAR_FOR_ALL_PROCESSORS
void column_products(const double* F, long n, long first, const double* g, double* out) {
  const double *a = F, *b = F + n, *c = F + 2 * n, *d = F + 3 * n;
  double sums[kColumns][kLanes] = {};
  long i = first;
  for (; i + kLanes <= n; i += kLanes)
    for (long k = 0; k < kLanes; ++k) {
      const double value = g[i + k];
      sums[0][k] += a[i + k] * value;
      sums[1][k] += b[i + k] * value;
      sums[2][k] += c[i + k] * value;
      sums[3][k] += d[i + k] * value;
    }
  // Rows beyond the last whole block.
  for (long k = 0; i < n; ++i, ++k) {
    sums[0][k] += a[i] * g[i];
    sums[1][k] += b[i] * g[i];
    sums[2][k] += c[i] * g[i];
    sums[3][k] += d[i] * g[i];
  }
  for (long column = 0; column < kColumns; ++column) {
    const double* s = sums[column];
    out[column] = ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
  }
}

}  // namespace

void add_product(const Eigen::MatrixXd& F, Shape shape, const Eigen::VectorXd& y,
                 Eigen::VectorXd& x) {
  const long n = F.rows();
  long column = 0;
  for (; column + kColumns <= n; column += kColumns)
    add_columns(F.data() + column * n, n, shape == Shape::kLower ? column : 0, y.data() + column,
                x.data());
  for (; column < n; ++column) x += F.col(column) * y[column];
}

void transposed_product(const Eigen::MatrixXd& F, Shape shape, const Eigen::VectorXd& g,
                        Eigen::VectorXd& out) {
  const long n = F.rows();
  out.resize(n);
  long column = 0;
  for (; column + kColumns <= n; column += kColumns)
    column_products(F.data() + column * n, n, shape == Shape::kLower ? column : 0, g.data(),
                    out.data() + column);
  for (; column < n; ++column) out[column] = F.col(column).dot(g);
}

}  // namespace thenar::internal
