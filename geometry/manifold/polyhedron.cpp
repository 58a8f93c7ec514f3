#include "geometry/manifold/polyhedron.h"

#include "base/error.h"

namespace thenar {

std::shared_ptr<const Polyhedron> build_polyhedron(const TriangleMesh& mesh) {
  require(!mesh.empty(), "a polyhedron has {} triangles or more", 1);
  auto built = std::make_shared<Polyhedron>();
  CollisionTree tree = collision_tree({nullptr, {{mesh, 0}}, {}, {}});
  built->nodes = std::move(tree.nodes);
  return built;
}

}  // namespace thenar
