#pragma once

/// Equilibrium of a net.
///
/// Minimises  E(x) = sum_bands phi(L) + sum_muscles t L  over the floating nodes, which may not be
/// inside a bone; phi is the elastic energy of a band [J], L a length [m], t a tension [N]. Without
/// bones E is convex: every minimum is the global one, and it is found from any start. With bones E
/// is not convex: the minimum depends on the initial nodes (a band can lie on either side of a
/// joint), so sweeps start each solution from the previous one. Derivation:
/// docs/theory/extensor_net.md.

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/net/net.h"

namespace thenar {

/// Outcome of a solution.
enum class NetStatus {
  kBalanced,       // residual below tolerance at a minimum
  kUnstable,       // balanced, but at a saddle: any disturbance moves it elsewhere
  kNodeCollapsed,  // balanced only because a muscle has collapsed a node into its exit: the net
                   // does not hold the pull
  kStalled,        // not balanced: see the residual
  kFarSideWrap,    // not balanced: a band has turned to the far side of its cylinder, where its
                   // length jumps (`far_side_bands`); there is no minimum on this side
  kOverstrained    // balanced, but passive bands exceed Net::max_load or NetBand::max_strain
                   // (`overstrained`), beyond what tissue tolerates
};

/// Options of NetSolver.
struct NetSolverOptions {
  double tolerance = 1e-9;   // largest out-of-balance force of a floating node [N]
  int max_iterations = 500;  // Newton steps, and steps off saddles; a search restarted from
                             // stronger pulls takes at most three times as many
};

/// Contact of a node with a bone.
struct NetContact {
  int node = 0;      // index in Net::nodes
  int surface = 0;   // index in Net::surfaces
  double force = 0;  // normal force on the node [N]; where bands that wrap over the bone hold the
                     // node on it, it may be negative: with S the sum of their tensions and r the
                     // radius, not below -S max(sqrt(2e-11 m / r), 4e-17 m S / (tolerance r))
  Eigen::Vector3d normal;  // outward normal of the bone, world (3)
};

/// Band of constant pull that has collapsed its node into its exit, or two nodes together.
struct CollapsedBand {
  int band = 0;           // index in Net::bands
  Eigen::Vector3d force;  // force of the band on its end a, opposite to that on its end b; at most
                          // the pull; world [N] (3)
};

/// Equilibrium of a net at one posture and drive.
struct [[nodiscard]] NetEquilibrium {
  NetStatus status = NetStatus::kStalled;  // read this first
  double residual = 0;                     // largest out-of-balance force of a floating node [N]
  int iterations = 0;                      // Newton steps, and steps off saddles
  int evaluations = 0;                     // evaluations of the energy: cost of the search
  Eigen::Matrix3Xd x;                      // all nodes, world [m] (3, nodes)
  Eigen::VectorXd length;                  // length of each band [m] (bands)
  Eigen::VectorXd tension;                 // tension of each band, 0 where slack [N] (bands)
  std::vector<NetContact> contacts;
  std::vector<int> undetermined;  // floating nodes without a determined position: no band at them
                                  // has a tension above ten times the tolerance
  std::vector<CollapsedBand> collapsed;  // bands of zero length under a pull: kNodeCollapsed
  std::vector<int> far_side_bands;       // bands on the far side of a cylinder: kFarSideWrap
  std::vector<int> overstrained;         // bands loaded beyond their limits: kOverstrained
  std::vector<int> pushed_out;  // nodes that started inside a bone and were moved to its surface
  double energy = 0;            // E [J]
};

/// Returns whether the search found no equilibrium.
[[nodiscard]] inline bool is_unbalanced(const NetEquilibrium& rest) {
  return rest.status == NetStatus::kStalled || rest.status == NetStatus::kFarSideWrap;
}

/// Solver of one net, of which it keeps a copy, at any posture and load. It holds the elimination
/// order and a workspace, which do not affect results: use one solver per thread.
class NetSolver {
 public:
  /// Plans the solution.
  /// @throws InputError naming the node or band that is wrong: an index out of range, a passive
  /// band without stiffness or slack length, a non-finite number.
  explicit NetSolver(const Net& net, const NetSolverOptions& options = {});
  ~NetSolver();
  NetSolver(NetSolver&&) noexcept;
  NetSolver& operator=(NetSolver&&) noexcept;

  /// Solves for the equilibrium.
  /// @param state  pose of the links, from pose_tree()
  /// @param start  initial nodes, world [m] (3, nodes); null: each where its link carries
  ///         NetNode::p
  /// @throws InputError if shapes disagree, or a tension is negative or not finite.
  NetEquilibrium solve(const TreeState<double>& state, const NetDrive& drive,
                       const Eigen::Matrix3Xd* start = nullptr);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> work_;
};

}  // namespace thenar
