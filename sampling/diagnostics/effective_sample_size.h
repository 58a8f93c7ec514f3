#pragma once

/// Effective sample size of one series and of ensembles; see convergence.h for several chains.

#include <vector>

#include <Eigen/Core>

namespace thenar {

/// Computes 1 + 2 sum of autocorrelations by the initial monotone sequence: the sum ends where the
/// sum of a pair of neighbours is no longer positive, and pair sums are made to decrease
/// [Geyer1992]. The even lag of the first omitted pair is added once, which covers antithetic
/// chains [Vehtari2021 sec. 3.2].
/// @param rho  autocorrelations at lags 0, 1, ...; rho(0) = 1 (n)
[[nodiscard]] double autocorrelation_time(const Eigen::VectorXd& rho);

/// Computes the effective sample size of one series [1]; NaN if it is constant or not finite.
[[nodiscard]] double series_ess(const Eigen::Ref<const Eigen::VectorXd>& x);

/// Computes the effective sample size for the mean of draws whose chains are walkers of ensembles
/// [1]. Walkers of one ensemble depend on each other, which affects the ensemble mean but no single
/// chain:
///   ESS = var(x) ESS(m) / var(m),   m the mean over the walkers of each group at each draw.
/// For independent walkers this is the sum of their sizes; for identical walkers the size of one.
/// @param x      draws (draws, chains)
/// @param group  group of each chain
[[nodiscard]] double ensemble_ess(const Eigen::Ref<const Eigen::MatrixXd>& x,
                                  const std::vector<int>& group);

}  // namespace thenar
