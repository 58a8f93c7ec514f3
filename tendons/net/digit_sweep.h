#pragma once

/// Postures of a digit under given tensions, with or without a net.

#include <vector>

#include <Eigen/Core>

#include "base/progress.h"
#include "tendons/digit_tendons.h"
#include "tendons/forces/tip_force.h"
#include "tendons/net/solve_net.h"

namespace thenar {

/// One posture under given tensions.
struct DigitPoint {
  Eigen::VectorXd q;     // [rad] (coordinates)
  TendonTorque pull;     // joint torque, moment arms, slips, warning
  TipForce tip;          // of a pinned tip
  NetEquilibrium rest;   // of the net; without nodes on rungs that have none
  bool snapped = false;  // on its way from the straight finger the net has left its course
};

/// Solves all postures in order. A net comes to each from the straight finger, so that a posture in
/// a row is told what it is told alone; sweep_net() follows a net from one to the next.
/// @param t         tension of each muscle [N] (muscles)
/// @param progress  may stop it: the points that are done come back
/// @throws InputError as DigitTendons::evaluate().
[[nodiscard]] std::vector<DigitPoint> sweep_digit(const DigitTendons& tendons,
                                                  const std::vector<Eigen::VectorXd>& postures,
                                                  const Eigen::VectorXd& t,
                                                  const Progress& progress = {});

}  // namespace thenar
