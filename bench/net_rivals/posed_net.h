#pragma once

/// A net at one posture under one drive, as the rivals of the solver see it: written from the
/// energy in tendons/net/net.h alone, so that a shared answer is a check of both.

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "hand/chain.h"
#include "tendons/net/net.h"

namespace thenar::bench {

/// A band at some length.
struct BandPull {
  double tension;    // >= 0 [N]
  double stiffness;  // d tension / d length [N/m]
};

/// Force of a band on its two ends, and its slopes where they were asked for.
struct BandForce {
  BandPull pull;
  Eigen::Matrix<double, 6, 1> along;  // d length / d (a, b)
  Eigen::Matrix<double, 6, 1> force;  // on (a, b), stacked [N]
  Eigen::Matrix<double, 6, 6> slope;  // minus d force / d (a, b): a Hessian [N/m]
};

/// What a bone says about a node near it.
struct BoneProbe {
  int pair, node;
  double gap;                 // negative inside [m]
  Eigen::Vector3d normal;     // out of the bone, world (3)
  Eigen::Matrix3d curvature;  // of `gap`, world (3, 3) [1/m]
};

class PosedNet {
 public:
  PosedNet(const Net& net, const TreeState<double>& state, NetDrive drive);

  [[nodiscard]] const Net& net() const { return net_; }
  [[nodiscard]] const std::vector<int>& free_nodes() const { return free_; }
  [[nodiscard]] int pairs() const { return static_cast<int>(pairs_.size()); }

  /// All nodes, each with its link [m] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd with_links() const;
  /// `start` with its fixed nodes where their links are now [m] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd from(const Eigen::Matrix3Xd& start) const;

  [[nodiscard]] BandForce band(int index, const Eigen::Matrix3Xd& x) const;
  /// Force of all bands on all nodes [N] (3, nodes).
  [[nodiscard]] Eigen::Matrix3Xd band_forces(const Eigen::Matrix3Xd& x) const;
  /// Stiffness of a band when all its fibres are recruited; 0 for one of constant tension [N/m].
  [[nodiscard]] double recruited(int index) const;
  [[nodiscard]] Eigen::VectorXd tensions(const Eigen::Matrix3Xd& x) const;
  /// Pair of a free node and a surface that it may rest on; 0 <= pair < pairs().
  [[nodiscard]] BoneProbe bone(int pair, const Eigen::Matrix3Xd& x) const;

 private:
  [[nodiscard]] BandPull pull(int index, double length) const;
  [[nodiscard]] bool is_elastic(const NetBand& band) const;

  struct Pair {
    int node, surface;
  };
  const Net& net_;
  NetDrive drive_;
  std::vector<int> free_;
  std::vector<Pair> pairs_;
  std::vector<Pose<double>> surface_;  // X_WS now
  Eigen::Matrix3Xd linked_;            // nodes with their links
};

/// Sees the nodes of every step of a rival: for charts.
using Watch = std::function<void(const Eigen::Matrix3Xd& x)>;

/// Where a rival came to rest.
struct RivalRest {
  Eigen::Matrix3Xd x;     // all nodes, world [m] (3, nodes)
  double residual = 0;    // largest out-of-balance force of a free node [N]
  int iterations = 0;     // steps, in the rival's own sense
  bool balanced = false;  // residual below what was asked for
};

}  // namespace thenar::bench
