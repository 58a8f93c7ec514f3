#pragma once

/// Corners, edges and faces of a body of triangles, prepared for contacts.

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "geometry/collision/collision_tree.h"
#include "geometry/triangle_mesh.h"

namespace thenar {

/// A convex edge: the angle between its faces is more than a degree.
struct PolyhedronEdge {
  Eigen::Vector3d from{0, 0, 0};             // [m] (3)
  Eigen::Vector3d axis{0, 0, 0};             // vector to the other corner [m] (3)
  std::array<Eigen::Vector3d, 2> normals{};  // normals of its faces, unit, outward (3)
};

/// A corner at which some part of the surface is convex.
struct PolyhedronCorner {
  Eigen::Vector3d p{0, 0, 0};  // [m] (3)
  int first = 0, count = 0;    // its entries of Polyhedron::directions
};

/// A triangle, with the corners and edges that belong to it and to no earlier triangle.
struct PolyhedronFace {
  Eigen::Matrix3d corners{};   // columns [m] (3, 3)
  Eigen::Vector3d n{0, 0, 0};  // unit, outward (3)
  int plane = 0;               // first triangle of the flat region to which it belongs
  std::array<int, 3> own_corners{-1, -1, -1};  // entries of Polyhedron::corners; -1: none
  std::array<int, 3> own_edges{-1, -1, -1};    // entries of Polyhedron::edges; -1: none
};

/// A closed surface of triangles, reduced to features that can touch: flat and concave parts cannot
/// touch before others.
struct Polyhedron {
  std::vector<PolyhedronCorner> corners;
  std::vector<Eigen::Vector3d> directions;  // unit, from corners along their edges (3)
  std::vector<PolyhedronEdge> edges;
  std::vector<PolyhedronFace> faces;
  std::vector<CollisionNode> nodes;  // bounding balls of faces; CollisionNode::triangle is a face
};

/// Builds the polyhedron of a mesh. @param mesh  closed; several vertices may have one position
/// @throws InputError if it has no triangle.
[[nodiscard]] std::shared_ptr<const Polyhedron> build_polyhedron(const TriangleMesh& mesh);

}  // namespace thenar
