#pragma once

/// Equilibrium of nets with Coulomb friction between nodes and bone.

#include <vector>

#include "tendons/net/solve_net.h"

namespace thenar {

/// Friction at a node pressed on a bone.
struct NodeFriction {
  int node;
  bool sticks;            // where it started
  double normal;          // force of the bone, >= 0 [N]
  Eigen::Vector3d force;  // of the bone on the node, along the surface; not larger than friction
                          // times `normal`, and equal to it against the slip if it slips [N] (3)
  double slip;            // distance from where it started [m]
};

struct NetFrictionOptions {
  NetSolverOptions solver;
  double tolerance = 1e-9;   // largest change of a friction force in the last round [N]
  int max_iterations = 200;  // rounds
};

struct [[nodiscard]] NetFrictionRest {
  bool settled = false;  // read this first: forces of friction and of the net agree
  double change = 0;     // of a friction force in the last round [N]
  int iterations = 0;    // rounds
  NetEquilibrium rest;   // of the given net; its status, residual and contacts, sticking nodes too
  std::vector<NodeFriction> nodes;  // nodes that are pressed on a bone
};

/// Equilibrium of a net with friction that lay at `start` without slipping: one step of incremental
/// Coulomb friction,
///   |f| <= mu N  where a node stays,   f = -mu N s / |s|  along the surface where it slips by s.
/// A node that sticks is held; one that slips is pulled to where it started by a band of constant
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
