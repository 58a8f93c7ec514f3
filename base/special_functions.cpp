#include "base/special_functions.h"

#include <limits>

#include <unsupported/Eigen/SpecialFunctions>

namespace thenar {

double normal_quantile(double p) {
  // ndtri() is the inverse of the normal distribution function.
  return p >= 0 && p <= 1 ? Eigen::numext::ndtri(p) : std::numeric_limits<double>::quiet_NaN();
}

double chi_square_tail(double x, double dof) {
  // Regularised incomplete gamma function Q(dof / 2, x / 2).
  return x > 0 ? Eigen::numext::igammac(dof / 2, x / 2) : 1;
}

double beta_quantile(double p, double a, double b) {
  // Halve the interval until no number is inside.
  double below = 0, above = 1;
  while (true) {
    const double x = below + (above - below) / 2;
    if (x <= below || x >= above) return x;
    // Keep the half that brackets the quantile.
    (Eigen::numext::betainc(a, b, x) < p ? below : above) = x;
  }
}

}  // namespace thenar
