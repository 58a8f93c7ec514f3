#include "geometry/mesh_faults.h"

#include <cmath>

#include <fmt/format.h>

#include "base/lists.h"
#include "geometry/mesh_check.h"
#include "geometry/mesh_parts.h"

namespace thenar {
namespace {

// Flat meshes are thinner, over the extent; above rounding of single precision [1]
constexpr double kFlatShare = 1e-6;

/// A hole that a corner on an edge leaves: all its corners are in line.
bool is_seam(const TriangleMesh& mesh, const MeshHole& hole) {
  const Eigen::Matrix3Xd loop = mesh.vertices(Eigen::all, hole.loop);
  // Take the line from the first corner to the farthest one.
  Eigen::Index far = 0;
  const Eigen::Matrix3Xd r = loop.colwise() - loop.col(0);
  const double length = std::sqrt(r.colwise().squaredNorm().maxCoeff(&far));
  if (!(length > 0)) return true;
  const Eigen::Vector3d along = r.col(far) / length;
  return (r - along * (along.transpose() * r)).colwise().norm().maxCoeff() <= kFlatShare * length;
}

}  // namespace

bool is_flat(const TriangleMesh& mesh) {
  if (mesh.empty()) return true;
  const Eigen::VectorXi corners = mesh.triangles.reshaped();
  const Eigen::Vector3d extent = principal_extents(mesh.vertices(Eigen::all, corners));
  return extent.minCoeff() <= kFlatShare * extent.maxCoeff();
}

bool any_is_flat(const std::vector<ShapeSpec>& shapes) {
  return any_of(shapes,
                [](const ShapeSpec& shape) { return !shape.mesh.empty() && is_flat(shape.mesh); });
}

MeshFaults find_mesh_faults(const TriangleMesh& mesh) {
  MeshFaults faults;
  const MeshReport whole = check_mesh(mesh);
  faults.flat = is_flat(mesh);
  if (faults.flat) return faults;
  faults.nonmanifold_edges = whole.nonmanifold_edges;
  if (whole.holes.empty()) return faults;
  faults.degenerate = whole.degenerate;
  const TriangleMesh kept = repair_mesh(mesh, MeshHoles::kKeep).mesh;
  faults.nonmanifold_edges = check_mesh(kept).nonmanifold_edges;
  int flat_holes = 0;
  bool all_flat = true;
  for (const TriangleMesh& part : connected_parts(kept)) {
    const bool flat = is_flat(part);
    all_flat = all_flat && flat;
    const MeshReport report = check_mesh(part);
    for (const MeshHole& hole : report.holes)
      ++(flat ? flat_holes : is_seam(part, hole) ? faults.seams : faults.holes);
    if (flat) faults.flaps += static_cast<int>(part.triangles.cols());
  }
  // Report only holes if no face is joined to another: together they may be a solid.
  if (all_flat) {
    faults.holes = flat_holes;
    faults.flaps = 0;
  }
  return faults;
}

std::string describe(const MeshFaults& faults) {
  if (faults.flat)
    return "it is flat: all its triangles lie in one plane, and no repair gives it a thickness";
  std::string text;
  const auto add = [&](int count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : "; ", count, what);
  };
  add(faults.flaps, "triangle(s) of fins or sheets that enclose nothing");
  add(faults.seams, "seam(s) where corners of triangles lie on edges of others");
  if (faults.flaps + faults.seams + faults.holes == 0)
    add(faults.degenerate, "triangle(s) of no area, which leave edges open");
  return text;
}

}  // namespace thenar
