#pragma once

#include <Eigen/Core>

#include "base/fidelity.h"
#include "tendons/tip_statics.h"

namespace thenar {

/// Force and torque of tendon tensions at a pinned fingertip.
struct TipForce {
  Eigen::Vector3d f_W;           // force of the tip on the world, world frame [N] (3)
  Eigen::VectorXd tau_residual;  // joint torque that no tip force can balance [N m] (n)
  double condition = 0;          // condition number of J_W; infinite if rank < possible [1]
  int rank = 0;                  // rank of J_W [1]
  int possible = 3;  // rank in a regular posture: 2 in the plane of parallel axes, where no joint
                     // feels the force across it, which is 0 here [1]

  /// Returns whether the rank is below that of a regular posture: some force has no joint torque
  /// here that has one elsewhere.
  [[nodiscard]] bool singular() const { return rank < possible; }
};

/// Fidelity that a model needs for tip_force().
inline constexpr Fidelity kTipForceNeeds{Motion::kStatic, Path::kConstant};

/// Computes the static fingertip force  J' f = R' t  in least squares.
///
/// A finger has more joints than a point contact has force components, so some torque may be left
/// unbalanced; it is returned as `tau_residual`. Near a straight finger f_W is the minimum-norm
/// solution: check `condition` first.
///
/// @param J_W  tip position Jacobian, world frame            3 x n  [m/rad]
/// @param R    moment arms -d(length)/dq, flexion positive   m x n  [m/rad]
/// @param t    tendon tensions, each >= 0                    m      [N]
/// @throws InputError if shapes disagree, J_W or R is not finite, or t has a negative or non-finite
///         entry.
/// Source: [ValeroCuevas1998] for the static model, [An1983] for the sign of R.
[[nodiscard]] TipForce tip_force(const Eigen::Ref<const Eigen::Matrix3Xd>& J_W,
                                 const Eigen::Ref<const Eigen::MatrixXd>& R,
                                 const Eigen::Ref<const Eigen::VectorXd>& t);

/// Computes the static fingertip force with the passive torques of `statics`:  J' f = R' t + tau_0.
/// Its W, if known, identifies parallel axes, see plane_normal().
[[nodiscard]] TipForce tip_force(const TipStatics& statics,
                                 const Eigen::Ref<const Eigen::VectorXd>& t);

}  // namespace thenar
