#include "tendons/net/world_surface.h"

#include <cmath>

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// From the centre of a sphere, or from the axis of a cylinder.
struct Radial {
  Vector3d normal;
  double distance, inverse;  // [m], [1/m]
};

bool is_round(const BoneSurface& bone) {
  return bone.shape == SurfaceShape::kSphere || bone.shape == SurfaceShape::kCylinder;
}

Radial radial(const BoneSurface& bone, const Pose<double>& X, const Vector3d& x) {
  Vector3d from = x - X.p;
  if (bone.shape == SurfaceShape::kCylinder) {
    const Vector3d d = X.R.col(2);
    from -= d.dot(from) * d;
  }
  const double distance = from.norm(), inverse = 1 / distance;
  return {inverse * from, distance, inverse};
}

}  // namespace

SurfaceGap gap_world(const Net& net, const NetScene& scene, int surface, const Vector3d& x) {
  const BoneSurface& bone = net.surfaces[surface];
  if (is_round(bone)) {
    const Radial at = radial(bone, scene.surface[surface], x);
    if (at.distance > 0) return {at.distance - bone.size[0], at.normal};
  }
  const SurfaceProbe at = probe_world(net, scene, surface, x);
  return {at.gap, at.normal};
}

SurfaceProbe probe_world(const Net& net, const NetScene& scene, int surface, const Vector3d& x) {
  const BoneSurface& bone = net.surfaces[surface];
  const Pose<double>& X = scene.surface[surface];
  if (is_round(bone)) {
    const Radial to = radial(bone, X, x);
    if (to.distance > 0) {
      Matrix3d across = Matrix3d::Identity() - to.normal * to.normal.transpose();
      if (bone.shape == SurfaceShape::kCylinder) {
        const Vector3d d = X.R.col(2);
        across -= d * d.transpose();
      }
      return {to.distance - bone.size[0], to.normal, to.inverse * across};
    }
  }
  SurfaceProbe at = probe(bone, X.R.transpose() * (x - X.p));
  at.normal = X.R * at.normal;
  at.curvature = X.R * at.curvature * X.R.transpose();
  return at;
}

}  // namespace thenar::internal
