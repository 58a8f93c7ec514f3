#pragma once

/// SUNDIALS' KINSOL on the balance of forces: Newton with line search on |F|, dense Jacobian in
/// closed form. Source: [Hindmarsh2005].

#include <memory>

#include "bench/net_rivals/posed_net.h"

namespace thenar::bench {

/// The equations are the normal map of bone_reaction.h: contact is rigid, as it is for the solver.
/// What it cannot do: |F| is not the energy, so it may stop at a saddle, or where |F| has a local
/// minimum, as where bands go slack or nodes lift off; a node that nothing holds makes the Jacobian
/// singular, against which it gets a stiffness of 1e-6 N/m.
class KinsolBalance {
 public:
  explicit KinsolBalance(const Net& net, double tolerance = 1e-9);  // [N]
  ~KinsolBalance();

  RivalRest solve(const PosedNet& net, const Eigen::Matrix3Xd& start, const Watch& watch = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar::bench
