#pragma once

/// Pairs of Simbody surfaces that represent the contacts of a scene.

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "dynamics/mechanism/tree_model.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Contact geometries of Simbody.
enum class SurfaceKind { kHalfSpace, kBall, kEllipsoid, kBrick, kMesh };

/// Surface of one body of a pair.
struct SimbodySurface {
  int body = 0;                           // index of the body
  std::size_t part = 0;                   // index of the part in the body's solid
  SurfaceKind kind = SurfaceKind::kBall;  // geometry
  Pose<double> X_BS;                      // pose in the body; a half space is at z < 0 in its frame
  Eigen::Vector3d size{0, 0, 0};          // radius, semi-axes or half edges [m] (3)
  Eigen::Vector2d extent{0, 0};  // half edges along x and y of the box face that a half space
                                 // represents [m] (2)
};

/// Two surfaces that have contacts with each other and with no other surface.
struct SimbodyPair {
  SimbodySurface a, b;  // surfaces of bodies a < b
};

/// Returns the surface pairs of all parts of bodies that may meet.
///
/// Simbody has contacts of half spaces with all geometries, of balls, ellipsoids and meshes with
/// each other (but not of ellipsoids with meshes), and of boxes ("bricks") with half spaces alone.
/// Therefore a box is replaced by the half space of the face that is turned most towards the other
/// part at the start. Of two boxes this is the fixed one, else the one with the larger face. This
/// is valid while contacts stay within the face, see SimbodySurface::extent.
/// @throws InputError that names the bodies if Simbody has no contact of two parts, or the parts of
/// a solid are not known.
[[nodiscard]] std::vector<SimbodyPair> plan_simbody_pairs(const MovingScene& scene,
                                                          const TreeModel& model);

/// Returns contact cliques of the surfaces, such that two surfaces share no clique if and only if
/// they form a pair; surfaces of one clique have no contacts. Surfaces 2 k and 2 k + 1 form pair k.
/// There are 2 + 2 ceil(log2 pairs) cliques, and each surface is in about half of them: clique 0
/// holds all first and clique 1 all second surfaces; bit i of k selects which surface of pair k is
/// in clique 2 + 2 i, and the other one is in clique 3 + 2 i.
/// @return cliques of each surface (2 pairs)
[[nodiscard]] std::vector<std::vector<int>> separating_cliques(std::size_t pairs);

}  // namespace thenar
