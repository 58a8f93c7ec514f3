#include "geometry/manifold/polyhedron.h"

#include <numeric>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

using Eigen::Vector3d, Eigen::Vector3i;

// Sine of the angle up to which neighbouring triangles are one face, 0.1 deg [1]
constexpr double kFlatSine = 0.002;

/// Builder of a polyhedron from a mesh.
class PolyhedronBuilder {
 public:
  explicit PolyhedronBuilder(const TriangleMesh& mesh) : mesh_(mesh) {}

  std::shared_ptr<const Polyhedron> build() {
    add_faces();
    add_edges();
    add_corners();
    return std::move(built_);
  }

 private:
  /// Adds faces in the order of the tree's triangles.
  void add_faces() {
    CollisionTree tree = collision_tree({nullptr, {{mesh_, 0}}, {}, {}});
    built_->nodes = std::move(tree.nodes);
    place_.resize(mesh_.triangles.cols());
    for (const SweptTriangle& triangle : tree.triangles) {
      place_[triangle.source] = static_cast<int>(built_->faces.size());
      PolyhedronFace face;
      face.corners = triangle.corners;
      face.n = triangle.n;
      built_->faces.push_back(face);
    }
    plane_.resize(built_->faces.size());
    std::iota(plane_.begin(), plane_.end(), 0);
  }

  /// Returns the root of a face's plane in the forest plane_.
  int plane_of(int face) {
    while (plane_[face] != face) face = plane_[face];
    return face;
  }

  /// Adds convex edges, and merges the planes of flat ones.
  void add_edges() {
    corner_of_.assign(mesh_.vertices.cols(), -1);
    neighbours_.resize(mesh_.vertices.cols());
    for_each_edge(sides_by_edge(mesh_), [&](const MeshSide* first, const MeshSide* last) {
      neighbours_[first->low].push_back(first->high);
      neighbours_[first->high].push_back(first->low);
      if (last - first != 2) return add_edge(first[0], first[last - first > 1 ? 1 : 0]);
      // Merge planes at flat edges; skip concave ones, which cannot touch first.
      const int one = place_[first[0].triangle];
      const int other = place_[first[1].triangle];
      const Vector3d n = built_->faces[one].n;
      const Vector3d n_other = built_->faces[other].n;
      if (n.cross(n_other).norm() < kFlatSine && n.dot(n_other) > 0) {
        const int low = std::min(plane_of(one), plane_of(other));
        const int high = std::max(plane_of(one), plane_of(other));
        plane_[high] = low;
        return;
      }
      const Vector3d opposite =
          mesh_.vertices.col(mesh_.triangles((first[1].side + 2) % 3, first[1].triangle));
      if (n.dot(opposite - mesh_.vertices.col(first->low)) < 0) add_edge(first[0], first[1]);
    });
    for (std::size_t i = 0; i < built_->faces.size(); ++i)
      built_->faces[i].plane = plane_of(static_cast<int>(i));
  }

  void add_edge(const MeshSide& one, const MeshSide& other) {
    PolyhedronFace& face = built_->faces[place_[one.triangle]];
    PolyhedronEdge edge;
    add_corner(one.low);
    add_corner(one.high);
    edge.from = mesh_.vertices.col(one.low);
    edge.axis = mesh_.vertices.col(one.high) - mesh_.vertices.col(one.low);
    edge.normals = {face.n, built_->faces[place_[other.triangle]].n};
    face.own_edges[one.side] = static_cast<int>(built_->edges.size());
    built_->edges.push_back(edge);
  }

  /// Makes a vertex a corner, unless it is one.
  void add_corner(int vertex) {
    int& number = corner_of_[vertex];
    if (number >= 0) return;
    number = static_cast<int>(built_->corners.size());
    built_->corners.push_back({mesh_.vertices.col(vertex), 0, 0});
    vertex_of_.push_back(vertex);
  }

  /// Adds the directions of each corner's edges, and assigns it to a face.
  void add_corners() {
    for (std::size_t i = 0; i < built_->corners.size(); ++i) {
      PolyhedronCorner& corner = built_->corners[i];
      corner.first = static_cast<int>(built_->directions.size());
      for (const int to : neighbours_[vertex_of_[i]])
        built_->directions.push_back((mesh_.vertices.col(to) - corner.p).stableNormalized());
      corner.count = static_cast<int>(built_->directions.size()) - corner.first;
    }
    // Assign each corner to the first face that has it.
    std::vector<bool> owned(built_->corners.size(), false);
    for (int i = 0; i < static_cast<int>(mesh_.triangles.cols()); ++i)
      for (int k = 0; k < 3; ++k) {
        const int number = corner_of_[mesh_.triangles(k, i)];
        if (number < 0 || owned[number]) continue;
        owned[number] = true;
        built_->faces[place_[i]].own_corners[k] = number;
      }
  }

  const TriangleMesh& mesh_;
  std::shared_ptr<Polyhedron> built_ = std::make_shared<Polyhedron>();
  std::vector<int> place_;                    // index of each of the mesh's triangles in the faces
  std::vector<int> plane_;                    // another face in the plane of each face: a forest
  std::vector<int> corner_of_;                // corner of each vertex; -1: none
  std::vector<int> vertex_of_;                // vertex of each corner
  std::vector<std::vector<int>> neighbours_;  // neighbours of each vertex
};

}  // namespace

std::shared_ptr<const Polyhedron> build_polyhedron(const TriangleMesh& mesh) {
  require(!mesh.empty(), "a polyhedron has {} triangle or more", 1);
  return PolyhedronBuilder(mesh).build();
}

}  // namespace thenar
