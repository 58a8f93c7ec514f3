#pragma once

/// Sweep of a net from posture to posture.

#include <vector>

#include "base/progress.h"
#include "tendons/net/net_continuation.h"

namespace thenar {

/// State of a net at one posture of a sweep.
struct SweepPoint {
  Eigen::VectorXd q;  // [rad] (coordinates)
  NetEquilibrium rest;
  SlipTension slips;     // [N]
  Eigen::VectorXd tau;   // joint torque of all tendons [N m] (coordinates)
  double moved = 0;      // largest displacement of a floating node since the previous point [m]
  double carried = 0;    // largest displacement of a bone point that holds the net [m]
  int mover = -1;        // node that moved farthest; -1: none
  bool snapped = false;  // true: the net has snapped since the previous point, see follow_net()
};

/// Interpolates postures between two, both included, evenly spaced. @param steps  intervals, > 0
[[nodiscard]] std::vector<Eigen::VectorXd> postures_between(const Eigen::VectorXd& from,
                                                            const Eigen::VectorXd& to, int steps);

/// Solves a net at one posture after another by follow_net() from the previous one: neither the
/// equilibrium nor the snaps of a finger moved this way depend on the spacing of the postures.
/// @param t      tension of each muscle [N] (muscles)
/// @param start  initial nodes at the first posture; empty: each with its link
/// @throws InputError as DigitTendons::evaluate().
[[nodiscard]] std::vector<SweepPoint> sweep_net(const NetTendons& tendons,
                                                const std::vector<Eigen::VectorXd>& postures,
                                                const Eigen::VectorXd& t,
                                                const NetContinuationOptions& options = {},
                                                const Eigen::Matrix3Xd& start = {});

/// Computes the next point of a sweep.
/// @param before  previous point; null: the net starts where its links carry it
[[nodiscard]] SweepPoint next_sweep_point(const NetTendons& tendons, const SweepPoint* before,
                                          const Eigen::VectorXd& q, const Eigen::VectorXd& t,
                                          const NetContinuationOptions& options = {});

/// Computes initial nodes at q by follow_from_straight(); empty for tendons without a net (3,
/// nodes).
[[nodiscard]] Eigen::Matrix3Xd start_from_straight(const DigitTendons& tendons,
                                                   const Eigen::VectorXd& q,
                                                   const Eigen::VectorXd& t);

}  // namespace thenar
