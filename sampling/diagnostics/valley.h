#pragma once

/// A gap in a line of draws.

#include <Eigen/Core>

namespace thenar {

/// Where a density of one variable is lowest between two peaks.
struct Valley {
  double cut = 0;       // the place [unit of y]
  double depth = 1;     // density there over that of the lower peak; 1: there is no valley
  double contrast = 0;  // (lower peak - valley) (n h / ((peak + valley) / (2 sqrt(pi))))^1/2 [1]
};

/// The deepest valley of a normal-kernel density with Silverman's bandwidth
/// h = 0.9 min(sd, quartile range / 1.349) n^-1/5  [Silverman1986 eq. 3.31], that leaves
/// `least_share` of the draws on either side. `contrast` is in standard errors of the density's
/// estimate if the draws are independent: multiply by sqrt(ESS / n) if they are not.
/// @param y  at least 2, finite (n)
[[nodiscard]] Valley find_valley(const Eigen::Ref<const Eigen::VectorXd>& y, double least_share);

}  // namespace thenar
