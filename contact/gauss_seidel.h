#pragma once

/// Block Gauss-Seidel method with exact local solutions.

#include <vector>

#include <Eigen/Core>

#include "contact/local_contact.h"
#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// Block Gauss-Seidel method: a sweep visits the blocks in their order, and solves each one exactly
/// with the other impulses fixed. Impulses that converge are a solution of the whole problem;
/// convergence is not guaranteed. One sweep costs one product with A.
/// Source: [JourdanAlartJean1998].
class GaussSeidel {
 public:
  /// Prepares the local problems of all cones.
  void assign(const ScaledContacts& contacts);

  /// Makes this number of sweeps on the scaled impulses f (rows).
  void sweep(const ScaledContacts& contacts, int sweeps, Eigen::Ref<Eigen::VectorXd> f) const;

 private:
  std::vector<LocalContact> local_;  // local problems (cones)
};

}  // namespace thenar::internal
