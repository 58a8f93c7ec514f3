#include "dynamics/ligament/bushing_law.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "base/error.h"

namespace thenar {
namespace {

constexpr auto kFlexionIndex = static_cast<Eigen::Index>(BushingCoordinate::kFlexion);

}  // namespace

const std::vector<std::string>& bushing_coordinate_names() {
  static const std::vector<std::string> names{"across",  "along",     "axial",
                                              "flexion", "abduction", "twist"};
  return names;
}

BushingAction bushing_action(const BushingLaw& law, const BushingVector& x,
                             const BushingVector& rate) {
  BushingAction out;
  for (Eigen::Index i = 0; i < kBushingCoordinates; ++i) {
    const CapsuleLaw& capsule = law.laws[i];
    if (capsule.stiffness == 0 && capsule.damping == 0) continue;
    // Gradient g of the displacement from rest,  x_i - ratio_i flexion.
    BushingVector g = BushingVector::Zero();
    g[i] = 1;
    g[kFlexionIndex] -= law.flexion_ratios[i];
    // Force along g, and its derivatives.
    const LigamentForce spring = capsule_force(capsule, g.dot(x));
    out.effort -= (spring.force + capsule.damping * g.dot(rate)) * g;
    out.stiffness += spring.slope * g * g.transpose();
    out.damping += capsule.damping * g * g.transpose();
    out.energy += spring.energy;
  }
  return out;
}

void check_law(const BushingLaw& law) {
  for (const CapsuleLaw& capsule : law.laws) check_law(capsule);
  for (const double ratio : law.flexion_ratios)
    require(std::isfinite(ratio), "bushing: wanted finite numbers, got {}", ratio);
  require(law.flexion_ratios[kFlexionIndex] == 0, "bushing: flexion cannot follow itself");
}

BushingPose bushing_pose(const Pose<double>& X_AB) {
  // Angles of  R = Rz(flexion) Rx(abduction) Ry(twist).
  const Eigen::Matrix3d& R = X_AB.R;
  const double flexion = std::atan2(-R(0, 1), R(1, 1));
  const double abduction = std::asin(std::clamp(R(2, 1), -1.0, 1.0));
  const double twist = std::atan2(-R(2, 0), R(2, 2));
  BushingPose out;
  out.x << X_AB.p, flexion, abduction, twist;
  // Rotation axes of the three angles in A; the inverse gives the rates.
  const double c = std::cos(flexion), s = std::sin(flexion);
  Eigen::Matrix3d axes;
  axes.col(0) = Eigen::Vector3d::UnitZ();
  axes.col(1) = Eigen::Vector3d(c, s, 0);
  axes.col(2) = R.col(1);
  out.rate_map = axes.inverse();
  return out;
}

}  // namespace thenar
