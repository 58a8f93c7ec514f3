#include "data/io/world/make_body.h"

#include <cmath>
#include <utility>

#include "base/error.h"

namespace thenar {
namespace {

ShapeSpec shape_of(ShapeKind kind, const Eigen::Vector3d& size) {
  ShapeSpec shape;
  shape.kind = kind;
  shape.size = size;
  return shape;
}

}  // namespace

ShapeSpec box_shape(const Eigen::Vector3d& edges) { return shape_of(ShapeKind::kBox, edges); }

ShapeSpec ball_shape(double radius) { return shape_of(ShapeKind::kSphere, {radius, 0, 0}); }

ShapeSpec cylinder_shape(double radius, double height) {
  return shape_of(ShapeKind::kCylinder, {radius, height, 0});
}

ShapeSpec mesh_shape(TriangleMesh mesh) {
  ShapeSpec shape = shape_of(ShapeKind::kMesh, {0, 0, 0});
  shape.mesh = std::move(mesh);
  return shape;
}

BodySpec make_body(std::string name, ShapeSpec shape, double mass, std::string material) {
  require(!name.empty(), "wanted the name of a body, got none");
  const Eigen::Vector3d& size = shape.size;
  for (int k = 0; k < size_entries(shape.kind); ++k)
    require(std::isfinite(size[k]) && size[k] > 0, "wanted a size of '{}' above 0, got {:g} m",
            name, size[k]);
  require(shape.kind != ShapeKind::kMesh || !shape.mesh.empty(),
          "wanted the triangles of '{}', got none", name);
  require(std::isfinite(mass) && mass >= 0, "wanted a mass of '{}' of 0 or more, got {:g} kg", name,
          mass);
  BodySpec body;
  body.name = std::move(name);
  body.source = "Scene";
  body.shapes = {std::move(shape)};
  body.uniform_mass = mass;
  body.material = std::move(material);
  return body;
}

}  // namespace thenar
