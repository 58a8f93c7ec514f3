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

/// A band with its places in the stiffness matrix.
struct BandPlan {
  int ka, kb;     // rows of its ends; -1: not free
  int slot = -1;  // of the block that joins them
  bool flip;      // the block is (kb, ka), not (ka, kb)
};

struct NetPlan {
  /// @throws InputError naming the node or band that is wrong.
  explicit NetPlan(const Net& given);

  Net net;
  BlockPattern pattern;
  std::vector<int> row;         // of each node; -1: not free
  std::vector<int> node;        // of each row
  std::vector<BandPlan> bands;  // in the order of the net's
  std::vector<std::vector<int>>
      wrapping_bands;  // of each row: bands that end there and bend over a bone
};

/// Bones and drive of one solve.
struct NetScene {
  std::vector<RoundBone> bone;        // what each band bends over
  std::vector<Pose<double>> surface;  // world from S
  std::vector<double> pull;           // constant tension of each band; < 0: it follows its law [N]
  std::vector<double> slack;          // of each band [m]
  std::vector<std::shared_ptr<const TensionLaw>> law;  // of each band of a muscle on a tendon;
                                                       // null: others
  // A constant pull t has no derivative at length zero, where the node is collapsed into the exit.
  // Its energy  t |d|, d = a - b,  is written as an augmented Lagrangian,
  //   max_{|p| <= t} p.d - |p - multiplier|^2 / (2 penalty).
  std::vector<double> penalty;              // [N/m]
  std::vector<Eigen::Vector3d> multiplier;  // force on end a that was found; zero: not held [N]
  std::vector<bool> collapsed;  // its end lies in the exit and counts as fixed: no force, no energy
};

[[nodiscard]] NetScene pose_scene(const Net& net, const TreeState<double>& state,
                                  const NetDrive& drive);

/// Response of a band that follows its law, with the net's blend.
[[nodiscard]] BandResponse elastic_response(const Net& net, const NetBand& band, double slack,
                                            double length);

/// Returns whether band i, straight and of constant pull, is so short that the penalty replaces its
/// energy.
[[nodiscard]] bool is_regularised(const NetScene& scene, int i, double length);

/// Poses the surfaces alone.
[[nodiscard]] NetScene pose_surfaces(const Net& net, const TreeState<double>& state);

/// The string of band i from a to b, all in world axes.
[[nodiscard]] WrappedString band_string(const Net& net, const NetScene& scene, int i,
                                        const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Geometry and response of one band at its present ends.
struct BandState {
  WrappedString chord;  // in world axes
  BandResponse pull;
};

[[nodiscard]] BandState band_state(const Net& net, const NetScene& scene, int i,
                                   const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// E, its gradient and its Hessian by the free nodes, rows in elimination order.
struct NetEnergy {
  explicit NetEnergy(const NetPlan& plan)
      : g(plan.pattern.size()),
        H(plan.pattern),
        length(plan.bands.size()),
        tension(plan.bands.size()) {}
  double energy = 0;               // [J]
  double size = 0;                 // sum of |energy| of all bands: what rounding scales with [J]
  std::vector<Eigen::Vector3d> g;  // [N] (rows)
  BlockMatrix H;                   // [N/m]
  std::vector<double> length, tension;  // of the bands [m], [N]
};

/// @param x  all nodes, world [m]
void evaluate(const NetPlan& plan, const NetScene& scene, const std::vector<Eigen::Vector3d>& x,
              NetEnergy& out);

}  // namespace thenar::internal
