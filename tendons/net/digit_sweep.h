#pragma once

/// Sweep of a digit through postures under given tensions, with or without a net.

#include <vector>

#include <Eigen/Core>

#include "base/progress.h"
#include "tendons/digit_tendons.h"
#include "tendons/forces/tip_force.h"
#include "tendons/net/solve_net.h"

namespace thenar {

/// State of a digit at one posture of a sweep.
struct DigitPoint {
  Eigen::VectorXd q;     // [rad] (coordinates)
  TendonTorque pull;     // joint torque, moment arms, slips, warning
  TipForce tip;          // force of a pinned tip
  NetEquilibrium rest;   // equilibrium of the net; without nodes if there is no net
  bool snapped = false;  // the net has snapped on its way from the straight finger
};

/// Solves all postures in order. A net is followed to each from the straight finger, so that the
/// result at a posture does not depend on the others.
/// @param t         tension of each muscle [N] (muscles)
/// @param progress  progress; where it stops the sweep, the points so far are returned
/// @throws InputError as DigitTendons::evaluate().
[[nodiscard]] std::vector<DigitPoint> sweep_digit(const DigitTendons& tendons,
                                                  const std::vector<Eigen::VectorXd>& postures,
                                                  const Eigen::VectorXd& t,
                                                  const Progress& progress = {});

}  // namespace thenar
