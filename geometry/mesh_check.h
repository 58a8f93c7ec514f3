#pragma once

/// Check of a triangle mesh for bounding a solid, and repair of its defects.

#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"

namespace thenar {

/// A loop of edges that belong to one triangle only.
struct MeshHole {
  std::vector<int> loop;            // vertices, in the order of the triangles' edges
  Eigen::Vector3d centre{0, 0, 0};  // mean of the loop's vertices [m] (3)
  double length = 0;                // length of the loop [m]
};

/// Defects of a mesh; all empty or zero if it has none.
struct MeshReport {
  std::vector<MeshHole> holes;
  int nonmanifold_edges = 0;  // edges of more than two triangles
  int reversed_edges = 0;     // edges that two triangles traverse in the same direction
  int degenerate = 0;         // triangles whose corners coincide or are collinear
  double volume = 0;          // enclosed volume, if there is no hole; negative: inside out [m^3]

  /// Returns whether the mesh bounds a solid.
  [[nodiscard]] bool watertight() const {
    return holes.empty() && nonmanifold_edges == 0 && reversed_edges == 0 && degenerate == 0;
  }
};

/// Finds the defects of a mesh.
/// @throws InputError if a corner is no vertex or a coordinate is not finite.
[[nodiscard]] MeshReport check_mesh(const TriangleMesh& mesh);

/// Returns a text like "2 hole(s): 4 edges, 32 mm long, about (10, 0, 5) mm, ..; ..", with at most
/// eight holes; empty if watertight.
[[nodiscard]] std::string describe(const MeshReport& report);

/// A repaired mesh, and the number of repairs.
struct MeshRepair {
  TriangleMesh mesh;
  int dropped = 0;       // triangles without area, or duplicates
  int turned = 0;        // reversed triangles
  int closed_holes = 0;  // holes closed by a fan
};

/// Treatment of holes in repair_mesh().
enum class MeshHoles { kClose, kKeep };

/// Removes triangles without area and duplicates, orients triangles consistently with their
/// neighbours and the whole outwards, and closes each hole by a fan around its centre, if
/// requested. check_mesh() finds the remaining defects.
[[nodiscard]] MeshRepair repair_mesh(const TriangleMesh& mesh, MeshHoles holes = MeshHoles::kClose);

}  // namespace thenar
