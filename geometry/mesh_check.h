#pragma once

/// Check whether a triangle mesh bounds a solid, and report of its defects.

#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// A loop of edges that belong to one triangle only.
struct MeshHole {
  std::vector<int> loop;            // vertices, in the order of the triangles' edges
  Eigen::Vector3d centre{0, 0, 0};  // mean of the loop's vertices [m] (3)
  double length = 0;                // [m]
};

/// Defects of a mesh; all empty or zero if it has none.
struct MeshReport {
  std::vector<MeshHole> holes;
  int nonmanifold_edges = 0;  // of more than two triangles
  int reversed_edges = 0;     // that two triangles walk in the same direction
  int degenerate = 0;         // triangles whose corners coincide or are in line
  double volume = 0;          // enclosed, if there is no hole; negative: inside out [m^3]

  /// Returns whether it is ready to bound a solid.
  [[nodiscard]] bool watertight() const {
    return holes.empty() && nonmanifold_edges == 0 && reversed_edges == 0 && degenerate == 0;
  }
};

/// @throws InputError if a corner is no vertex or a coordinate is not finite.
[[nodiscard]] MeshReport check_mesh(const TriangleMesh& mesh);

/// "2 hole(s): 4 edges, 32 mm long, about (10, 0, 5) mm, ..; .." and the like, eight holes at most;
/// empty if watertight.
[[nodiscard]] std::string describe(const MeshReport& report);

/// A repaired mesh, and the repairs.
struct MeshRepair {
  TriangleMesh mesh;
  int dropped = 0;  // triangles without area, or there twice
  int turned = 0;   // triangles
  int closed_holes = 0;
};

enum class MeshHoles { kClose, kKeep };

/// Drops triangles of no area and duplicates, turns triangles to agree with their neighbours and
/// the whole outwards, and closes each hole by a fan around its centre, if asked to. check_mesh()
/// tells what is still wrong afterwards.
[[nodiscard]] MeshRepair repair_mesh(const TriangleMesh& mesh, MeshHoles holes = MeshHoles::kClose);

}  // namespace thenar
