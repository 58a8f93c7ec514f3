#pragma once

/// Energy of a net on posed bones, with gradient and Hessian.

#include <vector>

#include "hand/chain.h"
#include "solvers/block_matrix.h"
#include "tendons/net/band_geometry.h"
#include "tendons/net/band_law.h"
#include "tendons/net/net.h"
#include "tendons/wrapping/wrapped_string.h"

namespace thenar::internal {

// Constant while one net is solved: free nodes, which of them are joined, elimination order.

/// Band with its blocks in the stiffness matrix.
struct BandPlan {
  int ka = -1, kb = -1;  // rows of its ends; -1: not free
  int slot = -1;         // index of the block that couples them
  bool flip = false;     // true: the block is (kb, ka), not (ka, kb)
};

/// Structure of a net's stiffness matrix.
struct NetPlan {
  /// Plans the elimination. @throws InputError naming the node or band that is wrong.
  explicit NetPlan(const Net& given);

  Net net;
  BlockPattern pattern;
  std::vector<int> row;         // row of each node; -1: not free
  std::vector<int> node;        // node of each row
  std::vector<BandPlan> bands;  // in the order of the net's bands
  /// Bands that end at the node of each row and bend over a bone.
  std::vector<std::vector<int>> wrapping_bands;
};

/// Bones and drive of one solve.
struct NetScene {
  std::vector<RoundBone> bone;        // bone that each band bends over
  std::vector<Pose<double>> surface;  // X_WS of each surface
  std::vector<double> pull;   // constant tension of each band; < 0: the band follows its law [N]
  std::vector<double> slack;  // slack length of each band [m]
  /// Law of each band of a muscle on an elastic tendon; null: others.
  std::vector<std::shared_ptr<const TensionLaw>> law;
  // A constant pull t has no derivative at length zero, where the node is collapsed into the exit.
  // Its energy  t |d|, d = a - b,  is written as an augmented Lagrangian,
  //   max_{|p| <= t} p.d - |p - multiplier|^2 / (2 penalty).
  std::vector<double> penalty;              // [N/m]
  std::vector<Eigen::Vector3d> multiplier;  // force found on end a; zero: not held [N]
  std::vector<bool> collapsed;  // end in the exit, which counts as fixed: no force, no energy
};

/// Poses the bones of a net and applies its drive.
[[nodiscard]] NetScene pose_scene(const Net& net, const TreeState<double>& state,
                                  const NetDrive& drive);

/// Computes the response of a band that follows its law, with the net's blend.
[[nodiscard]] BandResponse elastic_response(const Net& net, const NetBand& band, double slack,
                                            double length);

/// Returns whether band i, straight and of constant pull, is so short that the penalty replaces its
/// energy.
[[nodiscard]] bool is_regularised(const NetScene& scene, int i, double length);

/// Poses the surfaces alone.
[[nodiscard]] NetScene pose_surfaces(const Net& net, const TreeState<double>& state);

/// Computes the string of band i from a to b, all in world axes.
[[nodiscard]] WrappedString band_string(const Net& net, const NetScene& scene, int i,
                                        const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Geometry and response of one band at its present ends.
struct BandState {
  WrappedString chord;  // string in world axes
  BandResponse pull;
};

/// Computes geometry and response of band i from a to b, world frame.
[[nodiscard]] BandState band_state(const Net& net, const NetScene& scene, int i,
                                   const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Energy E with its gradient and Hessian by the free nodes, rows in elimination order.
struct NetEnergy {
  explicit NetEnergy(const NetPlan& plan)
      : g(plan.pattern.size()),
        H(plan.pattern),
        length(plan.bands.size()),
        tension(plan.bands.size()) {}
  double energy = 0;               // [J]
  double size = 0;                 // sum of |energy| of all bands, the scale of rounding errors [J]
  std::vector<Eigen::Vector3d> g;  // gradient [N] (rows)
  BlockMatrix H;                   // Hessian [N/m]
  std::vector<double> length, tension;  // lengths and tensions of the bands [m], [N]
};

/// Evaluates energy, gradient and Hessian. @param x  all nodes, world [m]
void evaluate(const NetPlan& plan, const NetScene& scene, const std::vector<Eigen::Vector3d>& x,
              NetEnergy& out);

}  // namespace thenar::internal
