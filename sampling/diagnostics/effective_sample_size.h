#pragma once

/// Effective sample size of one series and of ensembles; convergence.h has those of several chains.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// 1 + 2 sum of autocorrelations, cut off where the sum of a pair of neighbours is no longer
/// positive, and pairs made to fall: the initial monotone sequence [Geyer1992]. The first pair left
/// out still lends its even half once, which lets antithetic chains win [Vehtari2021 sec. 3.2].
/// @param rho  at lags 0, 1, ...; rho(0) = 1 (n)
[[nodiscard]] double autocorrelation_time(const Eigen::VectorXd& rho);

/// Effective sample size of one series [1]; NaN if it is constant or not finite.
[[nodiscard]] double series_ess(const Eigen::Ref<const Eigen::VectorXd>& x);

/// Effective sample size for the mean of draws whose chains are walkers of ensembles [1]. Walkers
/// of one ensemble depend on each other, which shows in the mean over the ensemble and in no single
/// chain:
///   ESS = var(x) ESS(m) / var(m),   m the means over the walkers of each group at each draw.
/// For independent walkers this is the sum of their sizes; for identical walkers the size of one.
/// @param x      (draws, chains)
/// @param group  of each chain
[[nodiscard]] double ensemble_ess(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                  const std::vector<int>& group);

}  // namespace thenar
