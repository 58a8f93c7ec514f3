#pragma once

/// Residuals of a fit, its constraints, and the least-squares problem that they make up.

#include "kinematics_fit/fit_problem.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Number of residuals that are data, three a trial and four a row of activations; the others are
/// priors.
[[nodiscard]] int data_rows(const FitProblem& problem);
/// Number of residuals of experiment `e` that are force components: three a trial, then three a row
/// of activations. What follows are the rows' widths (activation_residuals()).
[[nodiscard]] int force_rows(const FitProblem& problem, int e);
/// Number of force components that are fitted, two or three a trial or row of activations.
[[nodiscard]] int measured_numbers(const FitProblem& problem);

/// Data residuals of experiment `e`, (predicted - measured) / sd; with a robust scale c, r of each
/// trial is shrunk so that |r|^2 becomes c^2 log(1 + |r|^2 / c^2) (Cauchy's loss). A component that
/// is not fitted has residual 0. Rows of activations follow the trials: three residuals of each
/// row's force, then one of each row's width (activation_residuals()).
/// @param z  (size)
/// @return   r (3 trials), and with kYes its Jacobian by the entries of z that move the specimen:
///           population_entries(), then deviations() of that specimen (data rows, both)
[[nodiscard]] Residuals data_residuals(const FitProblem& problem, const Eigen::VectorXd& z, int e,
                                       WithJacobian want);

/// The residual of one force of which a robust loss of scale c made r, (3): the inverse of
/// |r|^2 -> c^2 log(1 + |r|^2 / c^2). c = 0: plain squares.
[[nodiscard]] Eigen::Vector3d plain_residual(const Eigen::Vector3d& r, double c);

/// Force components among data_residuals() of all experiments of a specimen, one below the other; J
/// by the entries of z that move it, entries_of_specimen().
[[nodiscard]] Residuals specimen_residuals(const FitProblem& problem, const Eigen::VectorXd& z,
                                           int specimen);

/// All residuals: data of every experiment in turn, then the priors r = z.
/// @throws InputError if z has another size or is not finite.
[[nodiscard]] Residuals fit_residuals(const FitProblem& problem, const Eigen::VectorXd& z,
                                      WithJacobian want);

/// Axis distances of every specimen in turn, scaled as in force_jacobian.h; empty if none is
/// wanted.
[[nodiscard]] ConstraintValues axis_constraints(const FitProblem& problem,
                                                const Eigen::VectorXd& z);
/// Their lower bounds; the upper ones are 1 (axis distances x specimens) [1].
[[nodiscard]] Eigen::VectorXd axis_constraint_lower(const FitProblem& problem);

/// The problem  min 1/2 |r(z)|^2  for solve(), in blocks where there are several specimens; refers
/// to `problem`, which must outlive it.
[[nodiscard]] LeastSquares least_squares(const FitProblem& problem);
LeastSquares least_squares(const FitProblem&& problem) = delete;

}  // namespace thenar
