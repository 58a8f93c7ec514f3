#pragma once

/// Residuals of activation rows: forces of muscles whose activation is known with an error.

#include "kinematics_fit/model/activation_plan.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Computes the residuals of one row and their derivatives. With the true tensions integrated out,
///   f ~ N(A t, S),   S = diag(sd^2) + A V A' = L L',
/// the negative log density is, up to a constant, half the sum of squares of
///   r = L^-1 (A t - f)   and   s = sqrt(log det S - log det diag(sd^2)),
/// so that a fit and a posterior use the same likelihood. s penalises explaining a force by large
/// errors of the tensions. A component of infinite sd is not fitted and has residual 0.
/// @param A     forces per unit pull, 0 where not fitted, one column per pull of the task [1] (3,
///         pulls)
/// @param A_u   derivatives of A by coordinates u, column by column of A; no columns: not requested
///              [1 / unit of u] (3 pulls, coordinates)
/// @return      r, then s (4), and J by u (4, coordinates)
[[nodiscard]] Residuals activation_residuals(const ActivationTask& task,
                                             const Eigen::Ref<const Eigen::Matrix3Xd>& A,
                                             const Eigen::Ref<const Eigen::MatrixXd>& A_u);

}  // namespace thenar
