#pragma once

/// Dynamic relaxation with kinetic damping: nodes get fictitious masses and move freely until their
/// kinetic energy peaks, are stopped there, and start again. The usual way to find the shape of
/// cable nets. Source: [Barnes1999].

#include "bench/net_rivals/posed_net.h"

namespace thenar::bench {

struct RelaxationOptions {
  double tolerance = 1e-6;  // largest out-of-balance force [N]
  int max_steps = 1000000;
};

/// Masses are the least that keep the central-difference step stable, by Gershgorin's bound on the
/// stiffness at the last stop: m = sum |K| / 4 per direction at a time step of 1. Bones take the
/// inward part of forces and velocities, and nodes inside them are moved out.
/// @param start  all nodes [m] (3, nodes)
[[nodiscard]] RivalRest relax(const PosedNet& net, const Eigen::Matrix3Xd& start,
                              const RelaxationOptions& options = {}, const Watch& watch = {});

}  // namespace thenar::bench
