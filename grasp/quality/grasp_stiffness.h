#pragma once

/// Grasp stiffness: the displacement of a held object under loads.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "grasp/contact/soft_pads.h"
#include "grasp/contact/wrench_set.h"

namespace thenar {

/// Stiffness of the joints behind the pads.
struct JointStiffness {
  /// Velocity of each contact along n, t1, t2 [m] and about n [rad] (4 contacts, joints).
  Eigen::MatrixXd J;
  Eigen::VectorXd k;  // stiffness of each joint [N m/rad]; infinite: locked (joints)
};

/// Stiffness of a grasp: wrench on the object per displacement. Torques are divided and rotations
/// multiplied by the torque scale, so that all are forces and lengths.
struct GraspStiffness {
  Eigen::Matrix<double, 6, 6> K = Eigen::Matrix<double, 6, 6>::Zero();  // [N/m]
  double min_eigenvalue = 0;  // stiffness of the softest direction [N/m]
  ScaledMotion softest;       // unit displacement of the softest direction, rotation times scale
};

/// Computes K = G (C_pads + J K_q^-1 J')^-1 G',  C_pads the inverse pad stiffness: springs in
/// series.
///
/// Components that a pad does not resist are left out. Also neglected is the stiffness due to
/// existing forces, linear in the grasp force and in curvatures, which may soften a grasp.
/// @param pads    stiffness of the pad of each contact
/// @param joints  nothing: rigid fingers
/// @throws InputError if shapes disagree, a stiffness is negative or NaN, a joint stiffness is
///         zero, or a rigid pad has no compliant joints behind it.
/// Source: [Cutkosky1989].
[[nodiscard]] GraspStiffness grasp_stiffness(const std::vector<Contact>& contacts,
                                             const Eigen::Vector3d& centre, double torque_scale,
                                             const std::vector<PadStiffness>& pads,
                                             const std::optional<JointStiffness>& joints = {});

}  // namespace thenar
