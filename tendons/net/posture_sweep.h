#pragma once

/// Equilibria of a net followed from posture to posture.

#include <vector>

#include "base/progress.h"
#include "tendons/net/net_continuation.h"

namespace thenar {

/// One equilibrium of a sweep.
struct SweepPoint {
  Eigen::VectorXd q;  // [rad] (coordinates)
  NetEquilibrium rest;
  SlipTension slips;     // [N]
  Eigen::VectorXd tau;   // joint torque of all tendons [N m] (coordinates)
  double moved = 0;      // furthest way of a floating node since the point before [m]
  double carried = 0;    // furthest way of a point of the bones that holds the net [m]
  int mover = -1;        // node that moved furthest; -1: none
  bool snapped = false;  // a knot has jumped since the point before: follow_net()
};

/// Postures between two, both included, evenly spaced.  @param steps  intervals, > 0
[[nodiscard]] std::vector<Eigen::VectorXd> postures_between(const Eigen::VectorXd& from,
                                                            const Eigen::VectorXd& to, int steps);

/// Solves a net at one posture after another, each time by follow_net() from the one before: the
/// equilibrium is that of a finger moved this way, and neither it nor its snaps depend on how close
/// the postures are.
/// @param t      tension of each muscle [N] (muscles)
/// @param start  nodes to start from at the first posture; empty: each with its link
/// @throws InputError as DigitTendons::evaluate().
[[nodiscard]] std::vector<SweepPoint> sweep_net(const NetTendons& tendons,
                                                const std::vector<Eigen::VectorXd>& postures,
                                                const Eigen::VectorXd& t,
                                                const NetContinuationOptions& options = {},
                                                const Eigen::Matrix3Xd& start = {});

/// One step of such a sweep.
/// @param before  the point before, from which the net comes; null: it comes from its links
[[nodiscard]] SweepPoint sweep_on(const NetTendons& tendons, const SweepPoint* before,
                                  const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                  const NetContinuationOptions& options = {});

/// Nodes to start from at q, by follow_from_straight(); empty for tendons without a net
/// (3, nodes).
[[nodiscard]] Eigen::Matrix3Xd start_from_straight(const DigitTendons& tendons,
                                                   const Eigen::VectorXd& q,
                                                   const Eigen::VectorXd& t);

/// Moment arm of one band about a coordinate,  -dL/dq  at fixed floating nodes, flexion positive
/// [m/rad].
[[nodiscard]] double band_arm(const NetTendons& tendons, const SweepPoint& point, int band,
                              int coordinate);

}  // namespace thenar
