#include "posterior/bounded_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace thenar {
namespace {

using Coefficients = std::array<double, 8>;

// clang-format off
// Numerators and denominators of [Wichura1988], constant term first: about 1/2, tails, far tails.
constexpr Coefficients kCentreTop = {3.3871328727963666080e0, 1.3314166789178437745e+2, 1.9715909503065514427e+3, 1.3731693765509461125e+4,
    4.5921953931549871457e+4, 6.7265770927008700853e+4, 3.3430575583588128105e+4, 2.5090809287301226727e+3};
constexpr Coefficients kCentreBottom = {1, 4.2313330701600911252e+1, 6.8718700749205790830e+2, 5.3941960214247511077e+3,
    2.1213794301586595867e+4, 3.9307895800092710610e+4, 2.8729085735721942674e+4, 5.2264952788528545610e+3};
constexpr Coefficients kTailTop = {1.42343711074968357734e0, 4.63033784615654529590e0, 5.76949722146069140550e0, 3.64784832476320460504e0,
    1.27045825245236838258e0, 2.41780725177450611770e-1, 2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr Coefficients kTailBottom = {1, 2.05319162663775882187e0, 1.67638483018380384940e0, 6.89767334985100004550e-1,
    1.48103976427480074590e-1, 1.51986665636164571966e-2, 5.47593808499534494600e-4, 1.05075007164441684324e-9};
constexpr Coefficients kFarTop = {6.65790464350110377720e0, 5.46378491116411436990e0, 1.78482653991729133580e0, 2.96560571828504891230e-1,
    2.65321895265761230930e-2, 1.24266094738807843860e-3, 2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr Coefficients kFarBottom = {1, 5.99832206555887937690e-1, 1.36929880922735805310e-1, 1.48753612908506148525e-2,
    7.86869131145613259100e-4, 1.84631831751005468180e-5, 1.42151175831644588870e-7, 2.04426310338993978564e-15};
// clang-format on

double polynomial(const Coefficients& c, double r) {
  double sum = c[7];
  for (int k = 6; k >= 0; --k) sum = sum * r + c[k];
  return sum;
}

double ratio(const Coefficients& top, const Coefficients& bottom, double r) {
  return polynomial(top, r) / polynomial(bottom, r);
}

/// Quantile of p <= 1/2.
double lower_quantile(double p) {
  const double q = p - 0.5;
  if (q >= -0.425) return q * ratio(kCentreTop, kCentreBottom, 0.180625 - q * q);
  const double r = std::sqrt(-std::log(p));
  return r <= 5 ? -ratio(kTailTop, kTailBottom, r - 1.6) : -ratio(kFarTop, kFarBottom, r - 5);
}

}  // namespace

double normal_quantile(double p) {
  if (!(p > 0 && p < 1)) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return p == 0 ? -kInfinity : p == 1 ? kInfinity : std::nan("");
  }
  return p <= 0.5 ? lower_quantile(p) : -lower_quantile(1 - p);
}

double normal_probability(double z) { return 0.5 * std::erfc(-z * 0.70710678118654752440); }

BoundedNormal::BoundedNormal(double lower, double upper)
    : lower_(lower),
      upper_(upper),
      below_(normal_probability(lower)),
      above_(normal_probability(-upper)),
      within_(1 - below_ - above_),
      density_lower_(std::exp(-0.5 * lower * lower)),
      density_upper_(std::exp(-0.5 * upper * upper)) {
  require(lower <= 0 && upper >= 0 && lower < upper,
          "bounds must enclose the prior mean, got {} .. {} prior sds", lower, upper);
}

BoundedNormal::Image BoundedNormal::at(double x) const {
  // Each tail is summed from its own end, so that nothing cancels near a bound.
  const double left = normal_probability(x), right = normal_probability(-x);
  const double p = below_ + within_ * left, q = above_ + within_ * right;
  double z = p <= q ? lower_quantile(p) : -lower_quantile(q);
  if (std::min(p, q) == 0 || std::isnan(x)) z = x;  // beyond all numbers, and no bound to keep it
  z = std::clamp(z, lower_, upper_);
  const double inverse_density = std::exp(0.5 * z * z);
  return {z, within_ * std::exp(0.5 * (z - x) * (z + x)), density_lower_ * right * inverse_density,
          density_upper_ * left * inverse_density};
}

double BoundedNormal::inverse(double z) const {
  const double margin = 1e-3 * std::min(1.0, upper_ - lower_);
  const double inside = std::clamp(z, lower_ + margin, upper_ - margin);
  const double left = (normal_probability(inside) - below_) / within_;
  if (left <= 0.5) return lower_quantile(left);
  return -lower_quantile((normal_probability(-inside) - above_) / within_);
}

}  // namespace thenar
