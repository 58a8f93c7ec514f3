#pragma once

/// Small linear matrix inequalities, by a barrier.

#include <utility>
#include <vector>

#include <Eigen/Core>

namespace thenar::internal {

/// The constraint that C + sum of y_k M_k is positive semidefinite.
struct MatrixInequality {
  Eigen::MatrixXd C;                                   // symmetric (d, d)
  std::vector<std::pair<int, Eigen::MatrixXd>> terms;  // k and M_k, symmetric (d, d)
};

[[nodiscard]] Eigen::MatrixXd value_at(const MatrixInequality& inequality,
                                       const Eigen::VectorXd& y);

/// Result of raising one unknown.
struct MaximisedComponent {
  Eigen::VectorXd y;  // strictly obeys all inequalities
  bool reached;       // y[which] > enough
};

/// Raises one unknown under inequalities until it is above `enough`, or that is seen to be beyond
/// its largest value: Newton's method on  -weight y[which] - sum of log det, weight growing, whose
/// minimum is within (rows of all inequalities) / weight of the largest value.
/// The feasible set must be bounded in the directions that matter; nothing is certified here: who
/// asks checks y.
/// @param y  where all inequalities hold strictly
/// Source: [BoydVandenberghe2004], chapter 11.
[[nodiscard]] MaximisedComponent maximise_component(
    const std::vector<MatrixInequality>& inequalities, Eigen::VectorXd y, int which, double enough);

}  // namespace thenar::internal
