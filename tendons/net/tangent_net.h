#pragma once

/// A net at rest, made linear: how its nodes answer to small forces.

#include <vector>

#include <Eigen/Cholesky>

#include "tendons/net/net_energy.h"
#include "tendons/net/solve_net.h"
#include "tendons/wrapping/bone_surface.h"

namespace thenar::internal {

/// At most three columns, without the heap.
using Columns3 = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
using Rows3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor, 3, 3>;

/// A floating node.
struct TangentNode {
  int node = -1;             // in the net
  std::vector<int> contact;  // in the equilibrium, at most three
  int exit = -1;             // node that it is drawn into; -1: none
  int drawn = 0;             // bands that drew it
  Columns3 free;             // directions in which it may move, orthonormal; none where it is drawn
                             // in or loose
  Rows3 bear;                // contact forces from a force on the node: inverse of the normals
  Eigen::Index column = 0;   // of the first of them in `stiffness`
};

/// Constant once built; the net and the equilibrium must outlive it.
struct TangentNet {
  /// @throws InputError if a band has drawn two floating nodes together.
  TangentNet(const Net& of, const TreeState<double>& state, const NetDrive& drive,
             const NetEquilibrium& at);

  const Net& net;
  const NetEquilibrium& rest;
  NetScene scene;
  std::vector<BandState> band;
  std::vector<int> drawn;           // entry of rest.drawn of each band; -1: none
  std::vector<SurfaceProbe> probe;  // of each contact
  std::vector<int> row;             // of each node in `nodes`; -1: it does not float
  std::vector<TangentNode> nodes;   // that float

  /// Of the Lagrangian  E - sum contact force gap,  along the free directions [N/m].
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

}  // namespace thenar::internal
