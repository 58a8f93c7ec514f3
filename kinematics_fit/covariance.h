#pragma once

/// Laplace approximation of the posterior at the fit, and how much the data say of each coordinate.

#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include "kinematics_fit/fit_problem.h"
#include "solvers/arrow_factor.h"

namespace thenar {

/// Estimate of one coordinate with its posterior sd.
struct CoordinateEstimate {
  std::string name;   // of the entry of z
  double z;           // estimate, in prior sds [1]
  double sd;          // posterior sd, in prior sds: 1 = nothing learnt [1]
  double null_share;  // share of the coordinate in null directions, 0..1 [1]
  bool at_bound;      // the estimate sits on a bound, which the sd ignores: the posterior ends
                      // there, and where data push against the bound z is no optimum
};

/// A direction of z along which the data have no curvature: it is not identifiable.
struct NullDirection {
  std::string text;                       // "axis/MCP3_FE/point/along: not identifiable"
  Eigen::SparseVector<double> direction;  // unit, in z (size)
};

/// Gaussian approximation of the posterior at z:  C = (J'J)^-1 with J of data and priors. Bounds
/// and axis distances are left out: see CoordinateEstimate::at_bound.
struct Covariance {
  ArrowMatrix C;                           // of z; of two specimens' own entries it is not held [1]
  std::vector<CoordinateEstimate> learnt;  // one per entry of z
  std::vector<NullDirection> null_directions;  // data curvature below 1e-9 of a prior's
  double effective_parameters = 0;             // trace of data curvature times C [1]
  std::vector<Eigen::MatrixXd> leverage;       // W of each experiment, its data rows J having
                                               // J C J' = W'W to the last digits (., data rows) [1]
};

/// Covariance::C alone: who only predicts needs no names of directions.
[[nodiscard]] ArrowMatrix laplace_blocks(const FitProblem& problem, const Eigen::VectorXd& z);

/// @param z  the fitted point (size)
[[nodiscard]] Covariance posterior_covariance(const FitProblem& problem, const Eigen::VectorXd& z);

/// Entries of z by rising posterior sd: the best known first.
[[nodiscard]] std::vector<int> sorted_by_sd(const Covariance& covariance);

}  // namespace thenar
