#pragma once

/// A net at rest followed from one posture and load to another, however far apart they are.
///
/// Places are predicted by their slopes,  x + dx/dq dq + dx/dt dt,  and the way is halved until the
/// net is found where it was predicted: so it keeps its course, and what is found does not depend
/// on how far apart two postures are. Where no step is short enough the net has snapped.

#include "tendons/net/net_tendons.h"

namespace thenar {

struct NetContinuationOptions {
  double stray = 2e-4;     // from where a knot was predicted; more is halved, or a snap [m]
  double min_turn = 1e-5;  // of any joint in a step that is not halved [rad]
  double min_load = 1e-5;  // change of tension in such a step, per largest tension [1]
  int max_solves = 1000;   // then the rest of the way is gone in one step, and counts as a snap
};

/// The net where it is, and how it came there.
struct [[nodiscard]] NetContinuation {
  NetEquilibrium rest;
  int snaps = 0;   // jumps on the way
  int solves = 0;  // searches for rest
};

/// Follows a net from rest at (q, t). Where it finds no balance in the neighbourhood it is sought
/// from scratch; what is found then counts as a snap.
/// Where the net has no slopes, see why_not_differentiable(), or no muscle pulls it at either end,
/// so that nothing decides where its knots are, it is taken on in one step and no snap is judged.
/// @param rest   at `q` and `t`, as found before
/// @param to_q   (coordinates) [rad]
/// @param to_t   (muscles) [N]
/// @throws InputError as DigitTendons::pull().
NetContinuation follow_net(const NetTendons& tendons, const NetEquilibrium& rest,
                           const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                           const Eigen::VectorXd& to_q, const Eigen::VectorXd& to_t,
                           const NetContinuationOptions& options = {});

/// The rest that a net has at (q, t) when it comes there from the straight finger under these
/// tensions: the one that every question about a single posture means.
NetContinuation follow_from_straight(const NetTendons& tendons, const Eigen::VectorXd& q,
                                     const Eigen::VectorXd& t,
                                     const NetContinuationOptions& options = {});

/// Furthest way of a floating node that its bands hold in both, from x to where it rests [m].
[[nodiscard]] double largest_deviation(const Net& net, const std::vector<int>& loose_before,
                                       const Eigen::Matrix3Xd& x, const NetEquilibrium& rest);

}  // namespace thenar
