#include "bench/net_rivals/bone_reaction.h"

#include <algorithm>

namespace thenar::bench {

std::vector<BoneProbe> pressed(const PosedNet& net, const Eigen::Matrix3Xd& x,
                               const Eigen::Matrix3Xd& f) {
  std::vector<BoneProbe> bones;
  for (int pair = 0; pair < net.pairs(); ++pair) {
    const BoneProbe at = net.bone(pair, x);
    if (at.gap <= kTouch && at.normal.dot(f.col(at.node)) < 0) bones.push_back(at);
  }
  return bones;
}

Eigen::Matrix3Xd kept_out(const std::vector<BoneProbe>& bones, Eigen::Matrix3Xd v) {
  // One sweep is exact for one bone a node; between two bones a few settle the corner.
  constexpr int kSweeps = 3;
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (const BoneProbe& at : bones)
      v.col(at.node) -= std::min(0.0, at.normal.dot(v.col(at.node))) * at.normal;
  return v;
}

Eigen::Matrix3Xd settled(const PosedNet& net, Eigen::Matrix3Xd x,
                         const std::vector<BoneProbe>& held) {
  constexpr double kNear = 1e-4;  // a node that slid this far off has left its bone [m]
  std::size_t next = 0;           // `held` is in the order of pairs
  for (int pair = 0; pair < net.pairs(); ++pair) {
    const BoneProbe at = net.bone(pair, x);
    const bool is_held = next < held.size() && held[next].pair == pair;
    if (is_held) ++next;
    if (at.gap < 0 || (is_held && at.gap < kNear)) x.col(at.node) -= at.gap * at.normal;
  }
  return x;
}

Sunk sunk(const PosedNet& net, const Eigen::Matrix3Xd& x) {
  Sunk at{x, std::vector<Eigen::Matrix3d>(static_cast<std::size_t>(x.cols()),
                                          Eigen::Matrix3d::Identity())};
  for (int pair = 0; pair < net.pairs(); ++pair) {
    const BoneProbe bone = net.bone(pair, at.outside);
    if (bone.gap >= 0) continue;
    at.outside.col(bone.node) -= bone.gap * bone.normal;
    Eigen::Matrix3d& slope = at.slopes[static_cast<std::size_t>(bone.node)];
    slope = (Eigen::Matrix3d::Identity() - bone.normal * bone.normal.transpose() -
             bone.gap * bone.curvature) *
            slope;
  }
  return at;
}

Eigen::Matrix3Xd normal_map(const PosedNet& net, const Eigen::Matrix3Xd& x, double k) {
  const Eigen::Matrix3Xd outside = settled(net, x);
  return net.band_forces(outside) + k * (outside - x);
}

double largest_free(const PosedNet& net, const Eigen::Matrix3Xd& f) {
  double largest = 0;
  for (const int i : net.free_nodes()) {
    const double norm = f.col(i).norm();
    if (!(norm <= largest)) largest = norm;  // a NaN is larger than all
  }
  return largest;
}

}  // namespace thenar::bench
