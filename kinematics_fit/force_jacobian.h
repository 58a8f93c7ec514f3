#pragma once

/// Predicted forces and distances between axes with exact derivatives. The only code that includes
/// Ceres' automatic differentiation.

#include <memory>

#include "kinematics_fit/kernel/force_kernel.h"
#include "solvers/least_squares.h"

namespace thenar {

/// Forces and their derivatives by the displacements u of the free coordinates.
struct ForceJacobian {
  Eigen::Matrix3Xd force;  // [N] (3, trials)
  Eigen::MatrixXd J;       // [N per SI] (3 trials, coordinates)
};

/// Compiles the force model of an experiment, to be shared by copies of its problem. Returns null
/// if only the templates of predict_forces.h support it: with an extensor net, or if forces are
/// measured at segments other than the tip.
[[nodiscard]] std::shared_ptr<const ForceKernel> compile_forces(const TendonDigit& digit,
                                                                const FitParameters& parameters,
                                                                const ExperimentPlan& plan);

/// Predicts the forces of all trials [N] (3, trials).
/// @param u       displacements of the free coordinates [SI] (coordinates)
/// @param kernel  compile_forces() of the same arguments, or null: values are equal to rounding,
///                and Jacobians take several times as long
[[nodiscard]] Eigen::Matrix3Xd force_values(const TendonDigit& digit,
                                            const FitParameters& parameters,
                                            const ExperimentPlan& plan, const Eigen::VectorXd& u,
                                            const ForceKernel* kernel = nullptr);

/// Predicts the forces and their derivatives; arguments as for force_values().
[[nodiscard]] ForceJacobian force_jacobian(const TendonDigit& digit,
                                           const FitParameters& parameters,
                                           const ExperimentPlan& plan, const Eigen::VectorXd& u,
                                           const ForceKernel* kernel = nullptr);

/// Computes c = (distance / upper)^2 of every pair, bounded by (lower / upper)^2 .. 1, and dc/du.
[[nodiscard]] ConstraintValues axis_constraints(const TendonDigit& digit,
                                                const FitParameters& parameters,
                                                const std::vector<AxisPair>& pairs,
                                                const Eigen::VectorXd& u);

}  // namespace thenar
