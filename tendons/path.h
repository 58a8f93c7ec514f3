#pragma once

/// Tendons as straight runs through via points fixed in bones, on any scalar.

#include <vector>

#include "hand/chain.h"

namespace thenar {

/// Via point of a tendon.
template <typename T>
struct PathNode {
  int link = -1;  // link that carries it; -1: the base
  Vec3<T> p;      // position at the reference posture [m] (3)
};

template <typename T>
using TendonPath = std::vector<PathNode<T>>;

/// Computes the length of a path,  L = sum |p_{k+1} - p_k|  [m].
template <typename T>
[[nodiscard]] T path_length(const TreeState<T>& state, const TendonPath<T>& path) {
  T length(0);
  for (std::size_t k = 1; k < path.size(); ++k)
    length +=
        (moved(state, path[k].link, path[k].p) - moved(state, path[k - 1].link, path[k - 1].p))
            .norm();
  return length;
}

/// Computes the moment arms of a path by virtual work,  R_j = -dL/dq_j: positive where the tendon
/// shortens in flexion. Only hinges between the two links of a run contribute to it. Runs of zero
/// length have no direction and must not connect different links (checked at build).
/// @return row of moment arms [m/rad] (coordinates)
/// Source: [An1983] for the sign.
template <typename T>
[[nodiscard]] Eigen::Matrix<T, 1, Eigen::Dynamic> moment_arms(const Tree<T>& tree,
                                                              const TreeState<T>& state,
                                                              const TendonPath<T>& path,
                                                              int coordinates) {
  Eigen::Matrix<T, 1, Eigen::Dynamic> R(coordinates);
  R.setZero();
  for (std::size_t k = 1; k < path.size(); ++k) {
    const int a = path[k - 1].link, b = path[k].link;
    if (a == b) continue;
    // Compute the direction of the run.
    const Vec3<T> p_a = moved(state, a, path[k - 1].p), p_b = moved(state, b, path[k].p);
    const Vec3<T> u = (p_b - p_a).normalized();
    // Climb from both links to their common ancestor.
    for_each_hinge_between(tree, a, b, [&](int i, bool on_b) {
      const T pull = u.dot(state[i].axis.cross((on_b ? p_b : p_a) - state[i].point));
      R[tree[i].coordinate] += T(tree[i].ratio) * (on_b ? -pull : pull);
    });
  }
  return R;
}

// Derivatives of the moment arms of straight runs by posture, in closed form.

/// Computes the derivatives of moment_arms(),  dR_j/dq_k = -d2L/(dq_j dq_k),  symmetric.
///
/// For one run r from a to b with direction u, only hinges between its links count. With axis z_j
/// through c_j, r_j = z_j x (b - c_j) on the side of b and -z_j x (a - c_j) on that of a,
///   d2|r| = r_j . (1 - u u') r_k / |r| + u . (z_j x r_k),
/// with j the hinge nearer the base; the last term only for two hinges on the same side.
/// @return [m/rad^2] (coordinates, coordinates)
[[nodiscard]] Eigen::MatrixXd arm_derivatives(const Tree<double>& tree,
                                              const TreeState<double>& state,
                                              const TendonPath<double>& path, int coordinates);

}  // namespace thenar
