#pragma once

/// Equilibrium of nets with Coulomb friction between nodes and bone.

#include <vector>

#include "tendons/net/solve_net.h"

namespace thenar {

/// Friction at a node in contact with a bone.
struct NodeFriction {
  int node = 0;
  bool sticks = false;    // true: the node stays where it started
  double normal = 0;      // normal force of the bone, >= 0 [N]
  Eigen::Vector3d force;  // tangential force of the bone on the node: at most friction times
                          // `normal`; equal to it and against the slip if the node slips [N] (3)
  double slip = 0;        // distance from its start [m]
};

/// Options of solve_net_friction().
struct NetFrictionOptions {
  NetSolverOptions solver;
  double tolerance = 1e-9;   // largest change of a friction force in the last round [N]
  int max_iterations = 200;  // rounds
};

/// Equilibrium of a net with friction.
struct [[nodiscard]] NetFrictionRest {
  bool settled = false;  // read this first: forces of friction and of the net agree
  double change = 0;     // largest change of a friction force in the last round [N]
  int iterations = 0;    // rounds
  NetEquilibrium rest;   // equilibrium of the given net: status, residual and contacts, those of
                         // sticking nodes included
  std::vector<NodeFriction> nodes;  // nodes in contact with a bone
};

/// Solves for the equilibrium of a net with friction that was at `start` without slipping: one step
/// of incremental Coulomb friction,
///   |f| <= mu N  where a node stays,   f = -mu N s / |s|  along the surface where it slips by s.
/// A sticking node is held; a slipping one is pulled towards its start by a band of constant
/// tension. Rounds repeat until normal forces and these tensions agree.
/// The slip of a step should be small compared with the radius of the bone: it is taken as
/// straight. Derivation: docs/theory/net_friction.md.
///
/// @param net    with friction mu = net.friction >= 0
/// @param start  nodes before the step, carried by the bones to `state`, world [m] (3, nodes);
///               absent: each with its link. Those inside a bone start on its surface.
/// @throws InputError as NetSolver and its solve(), or if friction is negative or not finite.
NetFrictionRest solve_net_friction(const Net& net, const TreeState<double>& state,
                                   const NetDrive& drive, const Eigen::Matrix3Xd* start = nullptr,
                                   const NetFrictionOptions& options = {});

}  // namespace thenar
