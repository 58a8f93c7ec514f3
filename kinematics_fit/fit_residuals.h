#pragma once

/// Residuals of a fit, its constraints, and the least-squares problem that consists of them.

#include "kinematics_fit/fit_problem.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Returns the number of data residuals, three per trial and four per activation row; the others
/// are priors.
[[nodiscard]] int data_rows(const FitProblem& problem);
/// Returns the number of residuals of experiment `e` that are force components: three per trial,
/// then three per activation row. The rows' widths follow (activation_residuals()).
[[nodiscard]] int force_rows(const FitProblem& problem, int e);
/// Returns the number of fitted force components, two or three per trial or activation row.
[[nodiscard]] int measured_numbers(const FitProblem& problem);

/// Computes the data residuals of experiment `e`, (predicted - measured) / sd. With a robust scale
/// c, the r of each trial is shrunk so that |r|^2 becomes c^2 log(1 + |r|^2 / c^2) (Cauchy loss). A
/// component that is not fitted has residual 0. Activation rows follow the trials: three residuals
/// of each row's force, then one of each row's width (activation_residuals()).
/// @param z  (size)
/// @return   r (3 trials), and with kYes its Jacobian by the entries of z that move the specimen:
///           population_entries(), then deviations() of that specimen (data rows, both)
[[nodiscard]] Residuals data_residuals(const FitProblem& problem, const Eigen::VectorXd& z, int e,
                                       WithJacobian want);

/// Inverts the Cauchy loss of scale c, |r|^2 -> c^2 log(1 + |r|^2 / c^2), for the residual of one
/// force (3). c = 0: returns r.
[[nodiscard]] Eigen::Vector3d plain_residual(const Eigen::Vector3d& r, double c);

/// Stacks the force components of data_residuals() of all experiments of a specimen; J by the
/// entries of z that move it, entries_of_specimen().
[[nodiscard]] Residuals specimen_residuals(const FitProblem& problem, const Eigen::VectorXd& z,
                                           int specimen);

/// Computes all residuals: data of every experiment in turn, then the priors r = z.
/// @throws InputError if z has another size or is not finite.
[[nodiscard]] Residuals fit_residuals(const FitProblem& problem, const Eigen::VectorXd& z,
                                      WithJacobian want);

/// Computes the axis-distance constraints of every specimen in turn, scaled as in force_jacobian.h;
/// empty if there are none.
[[nodiscard]] ConstraintValues axis_constraints(const FitProblem& problem,
                                                const Eigen::VectorXd& z);
/// Returns their lower bounds; the upper bounds are 1 (axis distances x specimens) [1].
[[nodiscard]] Eigen::VectorXd axis_constraint_lower(const FitProblem& problem);

/// Returns the problem  min 1/2 |r(z)|^2  for solve(), in blocks if there are several specimens.
/// Keeps a reference to `problem`, which must outlive it.
[[nodiscard]] LeastSquares least_squares(const FitProblem& problem);
LeastSquares least_squares(const FitProblem&& problem) = delete;

}  // namespace thenar
