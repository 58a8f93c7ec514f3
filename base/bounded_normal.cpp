#include "base/bounded_normal.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/special_functions.h"

namespace thenar {

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

BoundedNormal::Image BoundedNormal::evaluate(double x) const {
  // Each tail is summed from its own end, so that nothing cancels near a bound.
  const double left = normal_probability(x), right = normal_probability(-x);
  const double p = below_ + within_ * left, q = above_ + within_ * right;
  double z = p <= q ? normal_quantile(p) : -normal_quantile(q);
  if (std::min(p, q) == 0 || std::isnan(x)) z = x;  // overflow without a bound
  z = std::clamp(z, lower_, upper_);
  // Derivatives of z by x and by both bounds, from P(z) = below + within Phi(x).
  const double inverse_density = std::exp(0.5 * z * z);
  return {z, within_ * std::exp(0.5 * (z - x) * (z + x)), density_lower_ * right * inverse_density,
          density_upper_ * left * inverse_density};
}

double BoundedNormal::inverse(double z, double margin) const {
  // Off the bounds, where x would be infinite.
  const double off = margin * std::min(1.0, upper_ - lower_);
  const double inside = std::clamp(z, lower_ + off, upper_ - off);
  // From the nearer tail.
  const double left = (normal_probability(inside) - below_) / within_;
  if (left <= 0.5) return normal_quantile(left);
  return -normal_quantile((normal_probability(-inside) - above_) / within_);
}

}  // namespace thenar
