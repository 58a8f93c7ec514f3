#pragma once

/// Small linear matrix inequalities, by a barrier method.

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

/// Constraint that C + sum of y_k M_k is positive semidefinite.
struct MatrixInequality {
  Eigen::MatrixXd C;                                   // symmetric (d, d)
  std::vector<std::pair<int, Eigen::MatrixXd>> terms;  // k and M_k, symmetric (d, d)
};

/// Returns C + sum of y_k M_k (d, d).
[[nodiscard]] Eigen::MatrixXd evaluate(const MatrixInequality& inequality,
                                       const Eigen::VectorXd& y);

/// Result of maximising one unknown.
struct MaximisedComponent {
  Eigen::VectorXd y;     // strictly feasible point
  bool reached = false;  // y[index] > target
};

/// Raises one unknown subject to inequalities until it exceeds `target`, or until its maximum is
/// known to be smaller. Applies Newton's method to  -weight y[index] - sum of log det with growing
/// weight; the minimum is within (rows of all inequalities) / weight of the largest value. The
/// feasible set must be bounded in the directions that matter. Nothing is certified: the caller
/// verifies y.
/// @param y  strictly feasible initial point
/// Source: [BoydVandenberghe2004], chapter 11.
[[nodiscard]] MaximisedComponent maximise_component(
    const std::vector<MatrixInequality>& inequalities, Eigen::VectorXd y, int index, double target);

}  // namespace thenar::internal
