#pragma once

/// A net at equilibrium, linearised: the response of its nodes to small forces.

#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "hand/chain.h"
#include "hand/tree_velocity.h"
#include "tendons/net/net.h"
#include "tendons/net/net_energy.h"
#include "tendons/net/solve_net.h"
#include "tendons/wrapping/bone_surface.h"

namespace thenar::internal {

/// Matrices of at most three columns, or rows, without the heap.
using Columns3 = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
using Rows3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 3, 3>;

/// A floating node.
struct TangentNode {
  int node = -1;             // in the net
  std::vector<int> contact;  // in the equilibrium, at most three
  int exit = -1;             // node that it is collapsed into; -1: none
  int collapsed = 0;         // bands that collapsed it
  Columns3 free;  // directions in which it may move, orthonormal; none where it is collapsed or
                  // undetermined
  Rows3 bear;     // contact forces from a force on the node: inverse of the normals
  Eigen::Index column = 0;  // of the first of them in `stiffness`
};

/// Constant once built. The net and the equilibrium must outlive it: it keeps references.
struct TangentNet {
  /// @throws InputError if a band has collapsed two floating nodes together.
  TangentNet(const Net& of, const TreeState<double>& state, const NetDrive& drive,
             const NetEquilibrium& at);

  const Net& net;
  const NetEquilibrium& rest;
  NetScene scene;
  std::vector<BandState> band;
  std::vector<int> collapsed;       // entry of rest.collapsed of each band; -1: none
  std::vector<SurfaceProbe> probe;  // of each contact
  std::vector<int> row;             // of each node in `nodes`; -1: it does not float
  std::vector<TangentNode> nodes;   // that float

  /// Hessian of the Lagrangian  E - sum contact force gap,  along the free directions [N/m].
  Eigen::LDLT<Eigen::MatrixXd> stiffness;

  [[nodiscard]] Eigen::Vector3d x(int node) const { return rest.x.col(node); }

 private:
  void number_nodes();
  void let_go();
  void probe_contacts();
  void state_bands();
  void free_directions();
  void factor();
};

// Perturbations of a net at equilibrium, as rates.

/// Motion of everything by one input, the floating nodes excepted.
struct NetPerturbation : TreeVelocity {
  Eigen::VectorXd tension;  // of each band at a fixed length (bands)
  Eigen::Matrix3Xd node;    // of each fixed node in its link, world axes; floating: 0 (3, nodes)
  Eigen::VectorXd radius;   // of each sphere, cylinder or capsule; others: 0 (surfaces)
};

/// Returns whether the gap to a surface falls one to one with its radius, as of spheres, cylinders
/// and capsules.
[[nodiscard]] bool has_radius(const BoneSurface& surface);

/// The perturbation that moves nothing and changes no tension.
[[nodiscard]] NetPerturbation still(const Net& net, std::size_t links);

/// Adds rates of the pulls at fixed lengths of their bands [N] (muscles of the net).
void tighten(const Net& net, const Eigen::VectorXd& pull, NetPerturbation& input);

/// One joint coordinate turns by 1 rad.
[[nodiscard]] NetPerturbation joint_perturbation(const Net& net, const Tree<double>& tree,
                                                 const TreeState<double>& state, int coordinate);

// Response of a net at equilibrium to a perturbation.

/// Rate of one band.
struct BandRate {
  double length, tension;
  Eigen::Vector3d fa, fb;  // of the force on its ends (3)
};

/// @param v  of all nodes (3, nodes)
[[nodiscard]] BandRate band_rate(const TangentNet& tangent, Eigen::Index band,
                                 const NetPerturbation& input, const Eigen::Matrix3Xd& v);

/// Rate of the force that bands and bones leave on each floating node, without collapsed bands; in
/// equilibrium it is 0 along the free directions. (3, floating nodes)
[[nodiscard]] Eigen::Matrix3Xd force_rate(const TangentNet& tangent, const NetPerturbation& input,
                                          const Eigen::Matrix3Xd& v);

/// Velocity of all nodes, such that floating nodes stay on their bones and in equilibrium.
/// (3, nodes)
[[nodiscard]] Eigen::Matrix3Xd node_rates(const TangentNet& tangent, const NetPerturbation& input);

/// Rate of the joint torque  sum over links and their hinges of  ratio axis . (m - point x f).
/// @param v  from node_rates() (3, nodes)
[[nodiscard]] Eigen::VectorXd torque_rate(const TangentNet& tangent, const Tree<double>& tree,
                                          const TreeState<double>& state,
                                          const NetPerturbation& input, const Eigen::Matrix3Xd& v,
                                          int coordinates);

}  // namespace thenar::internal
