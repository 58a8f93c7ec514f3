#pragma once

/// Pairs of surfaces that meet in a scene in Simbody, and their geometries.

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "base/spatial.h"
#include "dynamics/mechanism/tree_model.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar {

/// Geometry that Simbody has contacts of.
enum class SurfaceKind { kHalfSpace, kBall, kEllipsoid, kBrick, kMesh };

/// One side of a pair.
struct SimbodySurface {
  int body = 0;
  std::size_t part = 0;  // of its solid
  SurfaceKind kind = SurfaceKind::kBall;
  Pose<double> X_BS;              // the surface in its body; a half space lies at z < 0 of it
  Eigen::Vector3d size{0, 0, 0};  // radius, semi-axes, half edges [m] (3)
  Eigen::Vector2d extent{0, 0};   // of the face that a half space stands for: half edges along x
                                  // and y, beyond which it does not exist [m] (2)
};

/// Two surfaces that meet each other and nothing else.
struct SimbodyPair {
  SimbodySurface a, b;  // of bodies a < b
};

/// All pairs of parts of bodies that may meet.
///
/// Simbody knows half spaces against all else, balls, ellipsoids and meshes among each other (but
/// no ellipsoid against a mesh), and boxes ("bricks") against half spaces alone. So a box is taken
/// for the half space of one of its faces where it meets anything: the face that looks most at the
/// other part at the start. Of two boxes it is the one that is fixed, else the one with the larger
/// face. That holds while contacts stay within the face, which SimbodySurface::extent tells.
/// @throws InputError naming both bodies if Simbody has no contact of two parts, or a solid does
/// not say what its parts are.
[[nodiscard]] std::vector<SimbodyPair> simbody_pairs(const MovingScene& scene,
                                                     const TreeModel& model);

/// Cliques of surfaces, such that two surfaces share none if and only if they are one pair: surface
/// 2 k and 2 k + 1 belong to pair k. Surfaces of a clique never meet. With C = 2 + 2 ceil(log2
/// pairs) cliques each surface is in about half of them: clique 0 and 1 hold all first and all
/// second surfaces; of clique 2 + 2 i and 3 + 2 i bit i of k tells which of both the pair gives.
/// @return the cliques of each surface (2 pairs)
[[nodiscard]] std::vector<std::vector<int>> separating_cliques(std::size_t pairs);

}  // namespace thenar
