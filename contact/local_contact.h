#pragma once

/// Exact solution of one block of a contact problem with all other impulses fixed.

#include <Eigen/Core>

#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// Local problem of one contact, prepared for many right-hand sides.
///
/// With the normal row eliminated, slip  ut = -kappa ft,  kappa >= 0, satisfies
///   (S + kappa I) ft = -c,   S = A_tt - A_tn A_nt / A_nn,   c = q_t - A_tn q_n / A_nn,
/// which the eigenvectors of S reduce to one equation for kappa:  mu fn(kappa) = |ft(kappa)|. It
/// has a root whenever the bodies approach and the contact does not stick: the impulse is outside
/// the cone at kappa = 0, and inside as kappa tends to infinity. So a local problem always has a
/// solution.
class LocalContact {
 public:
  /// Sets the matrix of the block.
  /// @param A  rows and columns of the block in ScaledContacts::A() (3, 3) or (4, 4)
  void assign(const Eigen::Ref<const Eigen::MatrixXd>& A);

  /// Returns the impulse with  f in K _|_ û,  u = A f + q.  If S is singular, ft stays near the
  /// previous one.
  /// @param q         velocity without this impulse (3) or (4)
  /// @param mu        coefficient of friction, > 0 [1]
  /// @param previous  previous impulse (3) or (4)
  [[nodiscard]] Eigen::Vector4d solve(const Eigen::Ref<const Eigen::VectorXd>& q, double mu,
                                      const Eigen::Ref<const Eigen::VectorXd>& previous) const;

 private:
  int tangents_ = 2;  // number of tangential rows
  double A_nn_ = 1;
  Eigen::Vector3d A_tn_ =
      Eigen::Vector3d::Zero();  // coupling in the axes of S, zero beyond `tangents_`
  Eigen::Vector3d sigma_ = Eigen::Vector3d::Ones();  // eigenvalues of S
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();
};

/// Solves a block with an interval: returns the f in [lower, upper] that is nearest to  -q / A;  if
/// A is 0, the bound in the direction of -q, or `previous` if that is infinite.
[[nodiscard]] double solve_interval(const ScaledBlock& block, double A, double q, double previous);

}  // namespace thenar::internal
