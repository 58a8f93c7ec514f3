#pragma once

/// Smooth surfaces of bones and pulleys, over which tendons slide.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "data/io/subject.h"
#include "hand/chain.h"

namespace thenar {

/// Surface carried by a link. In its own frame, S:
///   cylinder   radius size[0] about z, unbounded; size[1] half length, for drawing only
///   sphere     radius size[0]
///   ellipsoid  semi-axes size[0..2] along x, y, z
///   capsule    radius size[0] about the segment |z| <= size[1]
///   torus      tube of radius size[0] about the ring of radius size[1] in the plane z = 0
struct BoneSurface {
  std::string name;
  int link = -1;  // link that carries it; -1: the base
  SurfaceShape shape = SurfaceShape::kSphere;
  Eigen::Vector3d size{0, 0, 0};  // dimensions by shape, see above [m] (3)
  Pose<double> X;                 // X_0S: pose of frame S at the reference posture
};

/// Returns the present pose of a surface, X_WS.
[[nodiscard]] inline Pose<double> surface_pose(const BoneSurface& surface,
                                               const TreeState<double>& state) {
  return surface.link < 0 ? surface.X : state[surface.link].X * surface.X;
}

/// Signed distance of a point from a surface, with its derivatives.
struct SurfaceProbe {
  double gap = 0;             // signed distance, negative inside [m]
  Eigen::Vector3d normal;     // gradient of `gap`, unit (3)
  Eigen::Matrix3d curvature;  // Hessian of `gap` (3, 3) [1/m]
};

/// Computes the signed distance of a point from a surface.
/// @param p_S  any point off the surface's medial axis (centre, axis, ring); there the normal is
/// some unit vector [m] (3)
[[nodiscard]] SurfaceProbe probe(const BoneSurface& surface, const Eigen::Vector3d& p_S);

/// Computes the point of the surface nearest to p (3) [m].
[[nodiscard]] Eigen::Vector3d nearest_point(const BoneSurface& surface, const Eigen::Vector3d& p_S);

}  // namespace thenar
