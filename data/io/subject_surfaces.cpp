#include <Eigen/Geometry>

#include "base/spatial.h"
#include "data/io/subject_parts.h"

namespace thenar::internal {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

SurfaceShape read_shape(TomlTable& table) {
  const std::string shape =
      table.choice("shape", {"cylinder", "sphere", "ellipsoid", "capsule", "torus"});
  if (shape == "cylinder") return SurfaceShape::kCylinder;
  if (shape == "sphere") return SurfaceShape::kSphere;
  if (shape == "ellipsoid") return SurfaceShape::kEllipsoid;
  return shape == "capsule" ? SurfaceShape::kCapsule : SurfaceShape::kTorus;
}

Vector3d read_size(TomlTable& table, SurfaceShape shape) {
  const auto positive = [&](const char* key) {
    return table.number(Dimension::kLength, key, Range::kPositive);
  };
  if (shape == SurfaceShape::kEllipsoid) {
    const std::vector<double> s =
        table.numbers(Dimension::kLength, "semi_axes", 3, Range::kPositive);
    return {s[0], s[1], s[2]};
  }
  const double radius = positive("radius");
  if (shape == SurfaceShape::kSphere) return {radius, 0, 0};
  if (shape == SurfaceShape::kTorus) return {radius, positive("ring_radius"), 0};
  if (shape == SurfaceShape::kCapsule) return {radius, positive("half_length"), 0};
  return {radius, table.number_or(Dimension::kLength, "half_length", 0, Range::kPositive), 0};
}

/// `axis` alone, with x and y anywhere across it, or `x_axis` and `z_axis` for an ellipsoid.
Matrix3d read_axes(TomlTable& table, SurfaceShape shape) {
  if (shape == SurfaceShape::kSphere) return Matrix3d::Identity();
  Matrix3d axes;
  if (shape != SurfaceShape::kEllipsoid) {
    const Vector3d z = table.direction("axis");
    const Tangents across = tangents(z);
    axes << across.e1, across.e2, z;
    return axes;
  }
  const Vector3d x = table.direction("x_axis"), z = table.direction("z_axis");
  if (std::abs(x.dot(z)) > 1e-6) table.fail("wanted 'x_axis' perpendicular to 'z_axis'", "x_axis");
  const Vector3d y = z.cross(x).normalized();
  axes << y.cross(z), y, z;
  return axes;
}

Surface read_surface(TomlTable& table, const SubjectDraft& draft) {
  Surface surface;
  surface.name = new_name(table, names_of(draft.subject.surfaces));
  surface.segment = segment_reference(table, "segment", draft);
  surface.shape = read_shape(table);
  surface.size = read_size(table, surface.shape);
  if (surface.shape == SurfaceShape::kTorus && surface.size[1] <= surface.size[0])
    table.fail(
        fmt::format("a torus with a hole needs 'ring_radius' above 'radius', got {:g} and "
                    "{:g} m",
                    surface.size[1], surface.size[0]));
  surface.center = table.vector(Dimension::kLength, "center");
  surface.axes = read_axes(table, surface.shape);
  table.done();
  return surface;
}

}  // namespace

void read_surfaces(TomlTable& top, SubjectDraft& draft) {
  for (TomlTable& table : top.tables("surface"))
    draft.subject.surfaces.push_back(read_surface(table, draft));
}

}  // namespace thenar::internal
