#pragma once

/// Linearisation of a net at equilibrium: response of its nodes to small forces.

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

/// Matrices of at most three columns, or rows, stored without heap allocation.
using Columns3 = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
using Rows3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 3, 3>;

/// Floating node of a linearised net.
struct TangentNode {
  int node = -1;             // index in the net
  std::vector<int> contact;  // contacts in the equilibrium, at most three
  int exit = -1;             // node into which it is collapsed; -1: none
  int collapsed = 0;         // number of bands that collapsed it
  Columns3 free;     // orthonormal directions in which it may move; none where it is collapsed or
                     // undetermined
  Rows3 to_contact;  // map from a force on the node to contact forces: inverse of the normals
  Eigen::Index column = 0;  // column of its first free direction in `stiffness`
};

/// Linearised net; constant once built. It refers to the net and the equilibrium, which must
/// outlive it.
struct TangentNet {
  /// Linearises the net. @throws InputError if a band has collapsed two floating nodes together.
  TangentNet(const Net& of, const TreeState<double>& state, const NetDrive& drive,
             const NetEquilibrium& at);

  const Net& net;
  const NetEquilibrium& rest;
  NetScene scene;
  std::vector<BandState> band;
  std::vector<int> collapsed;       // entry of rest.collapsed for each band; -1: none
  std::vector<SurfaceProbe> probe;  // surface at each contact
  std::vector<int> row;             // index in `nodes` of each node; -1: it does not float
  std::vector<TangentNode> nodes;   // floating nodes

  /// Factored Hessian of the Lagrangian  E - sum contact force gap,  along the free directions
  /// [N/m].
  Eigen::LDLT<Eigen::MatrixXd> stiffness;

  [[nodiscard]] Eigen::Vector3d x(int node) const { return rest.x.col(node); }

 private:
  void number_nodes();
  void release_penalties();
  void probe_contacts();
  void evaluate_bands();
  void find_free_directions();
  void factor();
};

// Perturbations of a net at equilibrium, as rates.

/// Rates caused by one input, except those of the floating nodes.
struct NetPerturbation : TreeVelocity {
  Eigen::VectorXd tension;  // tension rate of each band at fixed length (bands)
  /// Velocity of each fixed node relative to its link, world axes; floating: 0 (3, nodes).
  Eigen::Matrix3Xd node;
  Eigen::VectorXd radius;  // radius rate of each sphere, cylinder or capsule; others: 0 (surfaces)
};

/// Returns whether the gap to a surface decreases one to one with its radius, as for spheres,
/// cylinders and capsules.
[[nodiscard]] bool has_radius(const BoneSurface& surface);

/// Returns the zero perturbation.
[[nodiscard]] NetPerturbation zero_perturbation(const Net& net, std::size_t links);

/// Adds rates of the pulls at fixed lengths of their bands [N] (muscles of the net).
void add_pull_rates(const Net& net, const Eigen::VectorXd& pull, NetPerturbation& input);

/// Builds the perturbation by one joint coordinate that turns by 1 rad.
[[nodiscard]] NetPerturbation joint_perturbation(const Net& net, const Tree<double>& tree,
                                                 const TreeState<double>& state, int coordinate);

// Response of a net at equilibrium to a perturbation.

/// Rates of one band.
struct BandRate {
  double length, tension;
  Eigen::Vector3d fa, fb;  // rates of the forces on its ends (3)
};

/// Computes the rates of one band. @param v  velocity of all nodes (3, nodes)
[[nodiscard]] BandRate band_rate(const TangentNet& tangent, Eigen::Index band,
                                 const NetPerturbation& input, const Eigen::Matrix3Xd& v);

/// Computes the rate of the force of bands and bones on each floating node, without collapsed
/// bands; in equilibrium it is 0 along the free directions. (3, floating nodes)
[[nodiscard]] Eigen::Matrix3Xd force_rate(const TangentNet& tangent, const NetPerturbation& input,
                                          const Eigen::Matrix3Xd& v);

/// Computes the velocity of all nodes for which floating nodes stay on their bones and in
/// equilibrium. (3, nodes)
[[nodiscard]] Eigen::Matrix3Xd node_rates(const TangentNet& tangent, const NetPerturbation& input);

/// Computes the rate of the joint torque  sum over links and their hinges of  ratio axis . (m -
/// point x f).
/// @param v  from node_rates() (3, nodes)
[[nodiscard]] Eigen::VectorXd torque_rate(const TangentNet& tangent, const Tree<double>& tree,
                                          const TreeState<double>& state,
                                          const NetPerturbation& input, const Eigen::Matrix3Xd& v,
                                          int coordinates);

}  // namespace thenar::internal
