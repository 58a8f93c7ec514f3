#pragma once

/// Laplace approximation of the posterior at the fit, and how well the data determine each
/// coordinate.

#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include "kinematics_fit/fit_problem.h"
#include "solvers/arrow_factor.h"

namespace thenar {

/// Estimate of one coordinate with its posterior sd.
struct CoordinateEstimate {
  std::string name;       // name of the entry of z
  double z = 0;           // estimate, in prior sds [1]
  double sd = 0;          // posterior sd, in prior sds: 1 = nothing learnt [1]
  double null_share = 0;  // share of the coordinate in null directions, 0..1 [1]
  /// The estimate lies on a bound, which the sd ignores: the posterior ends there, and if the data
  /// push against the bound, z is not a stationary point.
  bool at_bound = false;
};

/// Direction of z along which the data have no curvature: it is not identifiable.
struct NullDirection {
  std::string text;                       // "axis/MCP3_FE/point/along: not identifiable"
  Eigen::SparseVector<double> direction;  // unit vector in z (size)
};

/// Gaussian approximation of the posterior at z:  C = (J'J)^-1 with J of data and priors. Bounds
/// and axis distances are ignored: see CoordinateEstimate::at_bound.
struct Covariance {
  ArrowMatrix C;  // covariance of z, without entries between two specimens [1]
  std::vector<CoordinateEstimate> learnt;  // estimate of each entry of z
  std::vector<NullDirection>
      null_directions;              // directions with a data curvature below 1e-9 of a prior's
  double effective_parameters = 0;  // trace of data curvature times C [1]
  std::vector<Eigen::MatrixXd> leverage;  // W of each experiment: J C J' = W'W for its data rows J,
                                          // to the last digits (., data rows) [1]
};

/// Computes Covariance::C alone, which is sufficient for predictions.
[[nodiscard]] ArrowMatrix laplace_blocks(const FitProblem& problem, const Eigen::VectorXd& z);

/// Computes the covariance and the estimates of all entries.
/// @param z  the fitted point (size)
[[nodiscard]] Covariance posterior_covariance(const FitProblem& problem, const Eigen::VectorXd& z);

/// Returns the entries of z by ascending posterior sd.
[[nodiscard]] std::vector<int> sorted_by_sd(const Covariance& covariance);

}  // namespace thenar
