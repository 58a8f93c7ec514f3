#pragma once

/// How a held object yields to loads.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "grasp/contact/soft_pads.h"
#include "grasp/contact/wrench_set.h"

namespace thenar {

/// Joints that yield behind the pads.
struct JointStiffness {
  Eigen::MatrixXd J;  // velocity along n, t1, t2 [m], and about n [rad], of each contact
                      // (4 contacts, joints)
  Eigen::VectorXd k;  // of each joint [N m/rad]; infinite: locked (joints)
};

/// ScaledWrench on the object per displacement, both with torques and turns in units of force and
/// length: turns are multiplied by the torque scale.
struct GraspStiffness {
  Eigen::Matrix<double, 6, 6> K;  // [N/m]
  double least;                   // eigenvalue: the softest direction [N/m]
  ScaledWrench softest;           // unit: motion, turn times scale (6)
};

/// K = G (C_pads + J K_q^-1 J')^-1 G',  C_pads the inverse pad stiffness: springs in series.
///
/// Components a pad does not resist are left out. Forces that already act are not counted: their
/// part of the stiffness, linear in the squeezing force and in the curvatures, may soften a grasp.
/// @param pads    one a contact
/// @param joints  nothing: fingers that do not yield
/// @throws InputError if shapes disagree, a stiffness is negative or NaN, a joint stiffness is
///         zero, or a rigid pad has no joints behind it that yield.
/// Source: [Cutkosky1989].
[[nodiscard]] GraspStiffness grasp_stiffness(const std::vector<Contact>& contacts,
                                             const Eigen::Vector3d& centre, double torque_scale,
                                             const std::vector<PadStiffness>& pads,
                                             const std::optional<JointStiffness>& joints = {});

}  // namespace thenar
