#pragma once

/// Equilibrium of a net followed from one posture and load to another, however far apart.
///
/// Nodes are predicted by their derivatives,  x + dx/dq dq + dx/dt dt,  and the step is shortened
/// until the net is found where it was predicted: so it keeps its course, and the result does not
/// depend on how far apart two postures are. Where no step is short enough the net has snapped.
/// What a prediction is off grows with the square of the step, which tells how long the next one
/// may be.

#include "tendons/net/net_pull.h"

namespace thenar {

struct NetContinuationOptions {
  double stray = 2e-4;     // from where a knot was predicted; more is a shorter step, or a snap [m]
  double min_turn = 1e-5;  // of any joint in a step that is not shortened [rad]
  double min_load = 1e-5;  // change of tension in such a step, per largest tension [1]
  int max_solves = 1000;   // then the rest is gone in one step, and snaps are not judged
};

/// A snap on the way: of no length, but for the least step.
struct NetJump : NetSnap {
  double from = 0;  // share of the way before it, `share` behind it [1]
  NetEquilibrium before, after;
};

/// An equilibrium, and how it was reached.
struct [[nodiscard]] NetContinuation {
  NetEquilibrium rest;
  std::vector<NetJump> snaps;  // on the way, the first one first
  int solves = 0;              // searches for rest
  long effort = 0;             // evaluations of the net's energy in them
  bool followed = true;        // false: max_solves did not suffice
};

/// Follows a net from its equilibrium at one posture and load to another. Where no equilibrium is
/// found near the prediction, the solver starts from scratch; what it finds elsewhere is a snap.
/// Where the net is not differentiable, see why_not_differentiable(), or no muscle pulls it at
/// either end, so that nothing determines its knots, it is moved in one step and snaps are not
/// judged.
/// @param tendons  pulled by tensions
/// @param rest     at `from`, as found before
/// @throws InputError as DigitTendons::evaluate().
NetContinuation follow_net(const NetTendons& tendons, const NetEquilibrium& rest,
                           const PostureAndLoad& from, const PostureAndLoad& to,
                           const NetContinuationOptions& options = {});
NetContinuation follow_net(const NetPull& pull, const NetEquilibrium& rest,
                           const PostureAndLoad& from, const PostureAndLoad& to,
                           const NetContinuationOptions& options = {});

/// Equilibrium of a net at (q, t) that came there from the straight finger under these tensions:
/// the one that every question about a single posture means. Joints that are frozen bend on the way
/// as if they were free. If that is not balanced or more than tissue bears, other ways are tried,
/// see search_rest(); one that leads to a sound rest counts as a snap.
NetContinuation follow_from_straight(const NetTendons& tendons, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& t,
                                     const NetContinuationOptions& options = {});

/// Largest distance of a floating node, held by its bands in both, from x to its equilibrium [m].
[[nodiscard]] double largest_deviation(const Net& net, const std::vector<int>& loose_before,
                                       const Eigen::Matrix3Xd& x, const NetEquilibrium& rest);

}  // namespace thenar
