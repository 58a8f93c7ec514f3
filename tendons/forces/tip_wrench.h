#pragma once

#include <Eigen/Core>

#include "tendons/tip_statics.h"

namespace thenar {

/// Options of tip_wrench().
struct TipWrenchOptions {
  /// Length that weighs a moment against a force in the norm that is minimised [m]. A hold of
  /// translational stiffness k and rotational stiffness k length^2 stores (|f|^2 + |m / length|^2)
  /// / 2k, so this is the radius of gyration of the hold's stiffness. Default: half the length of
  /// an index distal phalanx held in a thimble, 0.097 / 2 of a hand length of 0.19 m, rounded
  /// [Buchholz1992]. Only a `minimum_norm` result depends on it.
  double length = 0.01;
};

/// Wrench and torque of tendon tensions at a rigidly held fingertip.
struct TipWrench {
  Eigen::Vector3d m_W;           // moment of the tip on the world, about the tip [N m] (3)
  Eigen::Vector3d f_W;           // force of the tip on the world [N] (3)
  Eigen::VectorXd tau_residual;  // joint torque that no wrench can balance [N m] (n)
  double condition = 0;  // condition number of [length W; J]; infinite if its rank is below min(n,
                         // possible) [1]
  int rank = 0;          // rank of [length W; J] [1]
  /// True: rank < possible; many wrenches balance, this one has the smallest norm.
  bool minimum_norm = false;
  int possible = 6;  // number of load components that joints can feel: 3 in the plane of parallel
                     // axes, two forces and the moment about its normal; others are 0 [1]
};

/// Computes the static wrench of a rigidly held tip:  J' f + W' m = R' t + tau_0.
///
/// Six unknowns: with fewer than six independent joints the balance leaves the wrench open; the
/// solution of minimal |f|^2 + |m / length|^2 is returned and marked `minimum_norm`. With more
/// joints than six, or dependent ones, the fit is in least squares and `tau_residual` is the
/// remainder.
///
/// @param statics  Jacobians, moment arms and passive torque at one posture; W is needed
/// @param t        tendon tensions, each >= 0   m   [N]
/// @throws InputError if W is absent, shapes disagree, an entry is not finite, a tension is
/// negative, or length is not positive.
/// Source: [ValeroCuevas1998] for the static model; minimum norm as in [Penrose1955].
[[nodiscard]] TipWrench tip_wrench(const TipStatics& statics,
                                   const Eigen::Ref<const Eigen::VectorXd>& t,
                                   const TipWrenchOptions& options = {});

}  // namespace thenar
