#include "dynamics/ligament/bushing_law.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "base/error.h"

namespace thenar {
namespace {

constexpr auto kFlexed = static_cast<Eigen::Index>(BushingWay::kFlexion);

}  // namespace

const std::vector<std::string>& bushing_way_names() {
  static const std::vector<std::string> names{"across",  "along",     "axial",
                                              "flexion", "abduction", "twist"};
  return names;
}

BushingAction bushing_action(const BushingLaw& law, const BushingVector& x,
                             const BushingVector& rate) {
  BushingAction out;
  for (Eigen::Index i = 0; i < kBushingWays; ++i) {
    const CapsuleLaw& way = law.ways[static_cast<std::size_t>(i)];
    if (way.stiffness == 0 && way.damping == 0) continue;
    // Displacement from where flexion puts the rest; g is its gradient.
    const double follows = law.follows[static_cast<std::size_t>(i)];
    BushingVector g = BushingVector::Zero();
    g[i] = 1;
    g[kFlexed] -= follows;
    // Force and slope of the way, spread by its gradient.
    const LigamentForce at = capsule_force(way, g.dot(x));
    out.effort -= (at.force + way.damping * g.dot(rate)) * g;
    out.stiffness += at.slope * g * g.transpose();
    out.damping += way.damping * g * g.transpose();
    out.energy += at.energy;
  }
  return out;
}

void check_law(const BushingLaw& law) {
  for (const CapsuleLaw& way : law.ways) check_law(way);
  for (const double follows : law.follows)
    require(std::isfinite(follows), "bushing: wanted finite numbers, got {}", follows);
  require(law.follows[kFlexed] == 0, "bushing: flexion cannot follow itself");
}

BushingPose bushing_pose(const Pose<double>& X_AB) {
  // Rotation as flexion about z, then abduction, then twist.
  const Eigen::Matrix3d& R = X_AB.R;
  const double flexion = std::atan2(-R(0, 1), R(1, 1));
  const double abduction = std::asin(std::clamp(R(2, 1), -1.0, 1.0));
  const double twist = std::atan2(-R(2, 0), R(2, 2));
  BushingPose out;
  out.x << X_AB.p, flexion, abduction, twist;
  // Axes of the three turns, in A.
  const double c = std::cos(flexion), s = std::sin(flexion);
  Eigen::Matrix3d axes;
  axes.col(0) = Eigen::Vector3d::UnitZ();
  axes.col(1) = Eigen::Vector3d(c, s, 0);
  axes.col(2) = R.col(1);
  out.turn = axes.inverse();
  return out;
}

}  // namespace thenar
