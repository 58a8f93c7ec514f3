#pragma once

/// A digit with its tendons taken from posture to posture, on whatever rung its hood is.

#include <vector>

#include "base/progress.h"
#include "tendons/net/net_sweep.h"
#include "tendons/tip_force.h"

namespace thenar {

/// One posture under given tensions.
struct DigitPoint {
  Eigen::VectorXd q;     // [rad] (coordinates)
  TendonPull pull;       // joint torque, moment arms, slips, trouble
  TipForce tip;          // of a pinned tip
  NetEquilibrium rest;   // of the net; without nodes on rungs that have none
  bool snapped = false;  // the net left the course it had followed since the point before
};

/// Every posture, in order. A net comes to the first one from the straight finger, and to each
/// other from the one before.
/// @param t         tension of each muscle [N] (muscles)
/// @param progress  may stop it: the points that are done come back
/// @throws InputError as DigitTendons::pull().
[[nodiscard]] std::vector<DigitPoint> sweep_digit(const DigitTendons& tendons,
                                                  const std::vector<Eigen::VectorXd>& postures,
                                                  const Eigen::VectorXd& t,
                                                  const Progress& progress = {});

}  // namespace thenar
