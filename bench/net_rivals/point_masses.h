#pragma once

/// The same net as Simbody point masses with tension-only springs, integrated until it rests: what
/// one would do with a multibody program and nothing else.

#include <memory>

#include "bench/net_rivals/posed_net.h"

namespace thenar::bench {

struct PointMassOptions {
  double tolerance = 1e-6;   // largest out-of-balance force [N]
  double mass = 1e-4;        // of each node: a band of tendon weighs about so much [kg]
  double damping = 0.3;      // viscous, of each node; of those tried, this rests soonest [N s/m]
  double bone = 1e5;         // stiffness of bones against masses that sink in [N/m]
  double accuracy = 1e-7;    // of Runge and Kutta's steps; at the usual 1e-3 they never rest
  double fixed_step = 0;     // > 0: semi-explicit Euler by this step instead, no error control [s]
  double look_every = 1e-3;  // how often to look whether all is at rest [s]
  double give_up = 10;       // of simulated time [s]
};

/// One system, built once; a new posture moves the fixed ends. Bones are soft to the masses, and
/// bands pull at the point of the surface above a mass that has sunk in (bone_reaction.h): what
/// rests is the net on rigid bones.
class PointMasses {
 public:
  explicit PointMasses(const Net& net, const PointMassOptions& options = {});
  ~PointMasses();

  RivalRest solve(const PosedNet& net, const Eigen::Matrix3Xd& start, const Watch& watch = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace thenar::bench
