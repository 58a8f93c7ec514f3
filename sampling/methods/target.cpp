#include "sampling/methods/target.h"

#include <cmath>

#include "base/numbers.h"

namespace thenar::internal {

TemperedDensity tempered_density(const Densities& at, Eigen::Index point, double beta) {
  const double prior = at.log_prior[point], likelihood = at.log_likelihood[point];
  // Ignore the likelihood where the prior is zero.
  if (prior == -kInfinity) return {-kInfinity, false};
  for (const double part : {prior, likelihood})
    if (std::isnan(part) || part == kInfinity) return {-kInfinity, true};
  if (likelihood == -kInfinity) return {-kInfinity, false};
  return {prior + beta * likelihood, false};
}

}  // namespace thenar::internal
