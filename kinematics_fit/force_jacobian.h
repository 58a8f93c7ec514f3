#pragma once

/// Predicted forces and distances between axes with exact derivatives. The fence of Ceres'
/// automatic differentiation.

#include <memory>

#include "kinematics_fit/kernel/force_kernel.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Forces and their derivatives by the displacements u of the free coordinates.
struct ForceJacobian {
  Eigen::Matrix3Xd force;  // [N] (3, trials)
  Eigen::MatrixXd J;       // [N per SI] (3 trials, coordinates)
};

/// The force model of an experiment, compiled, for copies of its problem to share; null where only
/// the templates of predict_forces.h know it: with an extensor net, or forces measured at other
/// segments than the tip.
[[nodiscard]] std::shared_ptr<const ForceKernel> compile_forces(const TendonDigit& digit,
                                                                const FitParameters& parameters,
                                                                const ExperimentPlan& plan);

/// @param u       (coordinates)
/// @param kernel  compile_forces() of the same, or null: the values are the same to rounding, and
///                Jacobians take several times as long
[[nodiscard]] Eigen::Matrix3Xd force_values(const TendonDigit& digit,
                                            const FitParameters& parameters,
                                            const ExperimentPlan& plan, const Eigen::VectorXd& u,
                                            const ForceKernel* kernel = nullptr);

[[nodiscard]] ForceJacobian force_jacobian(const TendonDigit& digit,
                                           const FitParameters& parameters,
                                           const ExperimentPlan& plan, const Eigen::VectorXd& u,
                                           const ForceKernel* kernel = nullptr);

/// c = (distance / upper)^2 of every pair, wanted in (lower / upper)^2 .. 1, and dc/du.
[[nodiscard]] ConstraintValues axis_constraints(const TendonDigit& digit,
                                                const FitParameters& parameters,
                                                const std::vector<AxisPair>& pairs,
                                                const Eigen::VectorXd& u);

}  // namespace thenar
