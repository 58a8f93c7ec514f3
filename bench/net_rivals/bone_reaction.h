#pragma once

/// Rigid contact of nodes with bones, two ways.
///
/// Rivals that step along forces keep nodes outside, and take from forces and velocities what
/// presses on a bone. Rivals that know nothing but equations or springs let nodes sink in, as deep
/// as they press: bands then pull at the point P(x) of the surface above, and the bone pushes back
/// with k (P(x) - x). That is Robinson's normal map [Robinson1992]: where it vanishes, P(x) is at
/// rest on a rigid bone, whatever k.

#include "bench/net_rivals/posed_net.h"

namespace thenar::bench {

inline constexpr double kTouch = 1e-9;  // a node nearer than this to a bone lies on it [m]

/// Bones that are pressed by the forces `f` at the nodes that lie on them.
[[nodiscard]] std::vector<BoneProbe> pressed(const PosedNet& net, const Eigen::Matrix3Xd& x,
                                             const Eigen::Matrix3Xd& f);

/// Vectors at the nodes without their parts into those bones: what is left of a force once bones
/// carry their share, or of a velocity (3, nodes).
[[nodiscard]] Eigen::Matrix3Xd kept_out(const std::vector<BoneProbe>& bones, Eigen::Matrix3Xd v);

/// Nodes inside a bone, moved to its surface; nodes of `held` pairs are moved there from outside as
/// well, if they are not far.
[[nodiscard]] Eigen::Matrix3Xd settled(const PosedNet& net, Eigen::Matrix3Xd x,
                                       const std::vector<BoneProbe>& held = {});

/// Nodes of the normal map.
struct Sunk {
  Eigen::Matrix3Xd outside;             // P(x) [m] (3, nodes)
  std::vector<Eigen::Matrix3d> slopes;  // d P / d x of each node
};
[[nodiscard]] Sunk sunk(const PosedNet& net, const Eigen::Matrix3Xd& x);

/// Bands at P(x) and bones:  f(P(x)) + k (P(x) - x)  [N] (3, nodes).
[[nodiscard]] Eigen::Matrix3Xd normal_map(const PosedNet& net, const Eigen::Matrix3Xd& x, double k);

/// Largest force of a free node that neither bands nor bones balance [N].
[[nodiscard]] double largest_free(const PosedNet& net, const Eigen::Matrix3Xd& f);

}  // namespace thenar::bench
