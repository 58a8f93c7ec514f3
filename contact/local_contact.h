#pragma once

/// One block alone: the impulse that answers it while all other impulses stand.

#include <Eigen/Core>

#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// A contact's own matrix, prepared for many velocities.
///
/// With the normal row eliminated, slip at  ut = -kappa ft,  kappa >= 0, leaves
///   (S + kappa I) ft = -c,   S = A_tt - A_tn A_nt / A_nn,   c = q_t - A_tn q_n / A_nn,
/// and with the eigenvectors of S one equation in kappa:  mu fn(kappa) = |ft(kappa)|. It has a root
/// wherever the bodies approach and stick does not hold: at kappa = 0 the force is outside the
/// cone, at kappa = infinity inside. So one block alone always has an answer.
class LocalContact {
 public:
  /// @param A  the block's rows of ScaledContacts (3, 3) or (4, 4)
  void assign(const Eigen::Ref<const Eigen::MatrixXd>& A);

  /// Impulse with  f in K _|_ û,  u = A f + q.  Where S is singular, ft stays near the former.
  /// @param q       velocity without this impulse (3) or (4)
  /// @param mu      > 0 [1]
  /// @param former  impulse before (3) or (4)
  [[nodiscard]] Eigen::Vector4d solve(const Eigen::Ref<const Eigen::VectorXd>& q, double mu,
                                      const Eigen::Ref<const Eigen::VectorXd>& former) const;

 private:
  int tangents_ = 2;
  double A_nn_ = 1;
  Eigen::Vector3d A_tn_ = Eigen::Vector3d::Zero();   // in the axes of S, zero beyond `tangents_`
  Eigen::Vector3d sigma_ = Eigen::Vector3d::Ones();  // eigenvalues of S
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
};

/// Solves a block whose impulse has an interval: returns the f in [lower, upper] nearest to  -q /
/// A;  where A is 0, the end to which q leads, and `former` if there is none.
[[nodiscard]] double solve_interval(const ScaledBlock& block, double A, double q, double former);

}  // namespace thenar::internal
