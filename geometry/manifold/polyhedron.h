#pragma once

/// Corners, edges and faces of a body of triangles, as contacts need them.

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/collision_tree.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// A convex edge: its faces bend away from each other by more than a degree.
struct PolyhedronEdge {
  Eigen::Vector3d from{0, 0, 0};             // [m] (3)
  Eigen::Vector3d way{0, 0, 0};              // to the other corner [m] (3)
  std::array<Eigen::Vector3d, 2> normals{};  // of its faces, unit, outward (3)
};

/// A corner where the surface bends outwards somewhere.
struct PolyhedronCorner {
  Eigen::Vector3d p{0, 0, 0};  // [m] (3)
  int first = 0, count = 0;    // its ways in Polyhedron::ways
};

/// A triangle, with the corners and edges of which it is the first.
struct PolyhedronFace {
  Eigen::Matrix3d corners{};                   // columns [m] (3, 3)
  Eigen::Vector3d n{0, 0, 0};                  // unit, outward (3)
  int plane = 0;                               // the first triangle of its flat neighbourhood
  std::array<int, 3> own_corners{-1, -1, -1};  // of Polyhedron::corners; -1: none
  std::array<int, 3> own_edges{-1, -1, -1};    // of Polyhedron::edges; -1: none
};

/// A closed surface of triangles in parts that can touch: where it is flat or bends inwards nothing
/// does before something else.
struct Polyhedron {
  std::vector<PolyhedronCorner> corners;
  std::vector<Eigen::Vector3d> ways;  // unit, from corners along their edges (3)
  std::vector<PolyhedronEdge> edges;
  std::vector<PolyhedronFace> faces;
  std::vector<CollisionNode> nodes;  // balls around faces; CollisionNode::triangle is a face
};

/// @param mesh  closed; corners at the same place may be several vertices
/// @throws InputError if it has no triangle.
[[nodiscard]] std::shared_ptr<const Polyhedron> build_polyhedron(const TriangleMesh& mesh);

}  // namespace thenar
