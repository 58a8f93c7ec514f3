#pragma once

/// Continuation: the equilibrium of a net followed from one posture and load to another, however
/// far apart.
///
/// Nodes are predicted by their derivatives,  x + dx/dq dq + dx/dt dt,  and the step is shortened
/// until the equilibrium is close to the prediction. So the net stays on one branch, and the result
/// does not depend on how far apart two postures are. Where no step is short enough the net has
/// snapped. The prediction error grows with the square of the step, which gives the length of the
/// next one.

#include "tendons/net/net_pull.h"

namespace thenar {

/// Options of follow_net().
struct NetContinuationOptions {
  double stray = 2e-4;     // largest distance of a node from its prediction; beyond it the step is
                           // shortened, or the net has snapped [m]
  double min_turn = 1e-5;  // smallest step: largest rotation of any joint [rad]
  double min_load = 1e-5;  // smallest step: change of tension over the largest tension [1]
  int max_solves = 1000;   // limit of searches; then one step covers the rest of the way and snaps
                           // are not detected
};

/// Snap on the way, located to within the smallest step.
struct NetJump : NetSnap {
  double from = 0;  // fraction of the way just before it; `share` is just after it [1]
  NetEquilibrium before, after;
};

/// Equilibrium, and the way by which it was reached.
struct [[nodiscard]] NetContinuation {
  NetEquilibrium rest;
  std::vector<NetJump> snaps;  // snaps on the way, in order of occurrence
  int solves = 0;              // number of equilibrium searches
  long effort = 0;             // evaluations of the net's energy in them
  bool followed = true;        // false: max_solves did not suffice
};

/// Follows a net from its equilibrium at one posture and load to another. Where no equilibrium is
/// found near the prediction, the solver starts without one; an equilibrium found elsewhere is a
/// snap. Where the net is not differentiable, see why_not_differentiable(), or no muscle pulls it
/// at either end, so that nothing determines its nodes, one step covers the whole way and snaps are
/// not detected.
/// @param tendons  driven by tensions
/// @param rest     equilibrium at `from`
/// @throws InputError as DigitTendons::evaluate().
NetContinuation follow_net(const NetTendons& tendons, const NetEquilibrium& rest,
                           const PostureAndLoad& from, const PostureAndLoad& to,
                           const NetContinuationOptions& options = {});
NetContinuation follow_net(const NetPull& pull, const NetEquilibrium& rest,
                           const PostureAndLoad& from, const PostureAndLoad& to,
                           const NetContinuationOptions& options = {});

/// Computes the equilibrium of a net at (q, t) that is reached from the straight finger under these
/// tensions: the one meant by all results for a single posture. Frozen joints bend on the way as if
/// they were free. If it is not balanced or overstrained, other ways are tried, see search_rest();
/// one that leads to a sound equilibrium counts as a snap.
NetContinuation follow_from_straight(const NetTendons& tendons, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& t,
                                     const NetContinuationOptions& options = {});

/// Computes the largest distance between x and the equilibrium over the floating nodes that bands
/// determine in both [m].
[[nodiscard]] double largest_deviation(const Net& net, const std::vector<int>& loose_before,
                                       const Eigen::Matrix3Xd& x, const NetEquilibrium& rest);

}  // namespace thenar
