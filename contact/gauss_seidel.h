#pragma once

/// Block Gauss-Seidel sweeps with exact answers of every block.

#include <vector>

#include <Eigen/Core>

#include "contact/local_contact.h"
#include "contact/scaled_contacts.h"

namespace thenar::internal {

/// Sweeps over the blocks in their order; each block's impulse becomes its own answer while the
/// others stand. Where impulses converge they are an answer of the whole problem; there is no
/// promise that they do. One sweep takes one product with A.
/// Source: [JourdanAlartJean1998].
class GaussSeidel {
 public:
  void assign(const ScaledContacts& contacts);

  /// `sweeps` sweeps on f (rows).
  void sweep(const ScaledContacts& contacts, int sweeps, Eigen::Ref<Eigen::VectorXd> f) const;

 private:
  std::vector<LocalContact> local_;  // of each cone, in order
};

}  // namespace thenar::internal
