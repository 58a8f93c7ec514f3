#include "api/mesh_facts.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/words.h"
#include "geometry/mesh_parts.h"
#include "geometry/shape_mass.h"

namespace thenar {
namespace {

/// Longest edge of the box of a mesh [m].
double extent_of(const TriangleMesh& mesh) {
  return (mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff()).maxCoeff();
}

/// Longest edge of the box of a shape in its own frame [m].
double extent_of(const ShapeSpec& shape) {
  const Eigen::Vector3d& size = shape.size;
  switch (shape.kind) {
    case ShapeKind::kMesh:
      return shape.mesh.vertices.cols() == 0 ? 0 : extent_of(shape.mesh);
    case ShapeKind::kBox:
      return size.maxCoeff();
    case ShapeKind::kCylinder:
      return std::max(2 * size[0], size[1]);
    case ShapeKind::kCapsule:
      return 2 * size[0] + size[1];
    case ShapeKind::kTaperedCapsule:
      return size[0] + size[1] + size[2];
    case ShapeKind::kSphere:
      return 2 * size[0];
    default:
      return 2 * size.maxCoeff();
  }
}

/// Empty if there is none.
std::string mesh_size_warning(const TriangleMesh& mesh) {
  const double across = extent_of(mesh);
  if (!(across > kMaxObjectSize)) return "";
  return fmt::format("{:.4g} m across: are its numbers millimetres?", across);
}

/// Returns reasons why the surface bounds no volume, causes first, and their remedies.
std::vector<std::string> surface_warnings(const MeshReport& found, const MeshFaults& faults) {
  std::vector<std::string> warnings;
  // A flat surface has no inside, so that no other fault matters.
  if (faults.flat)
    return {
        "the surface is flat: all its triangles lie in one plane, so that it has no volume, and "
        "no repair gives it one"};
  // Open boundaries and seams come first, since they are why the surface has no volume.
  if (faults.holes > 0)
    warnings.push_back(
        fmt::format("the surface is open in {}: it has no volume; repairing closes it",
                    counted(static_cast<std::size_t>(faults.holes), "place")));
  if (faults.seams > 0)
    warnings.push_back(
        fmt::format("corners of triangles lie on edges of others in {}: the surface does not close "
                    "there, and has no volume; repairing cuts these triangles",
                    counted(static_cast<std::size_t>(faults.seams), "place")));
  if (faults.flaps > 0)
    warnings.push_back(fmt::format(
        "{} of fins or sheets that enclose nothing: with them the surface has no volume; "
        "repairing leaves them out",
        counted(static_cast<std::size_t>(faults.flaps), "triangle")));
  // Faults that leave the surface closed follow.
  if (found.reversed_edges > 0)
    warnings.push_back(
        fmt::format("{} edges lie between triangles that face opposite ways; repairing turns them",
                    found.reversed_edges));
  if (faults.nonmanifold_edges > 0)
    warnings.push_back(fmt::format("{} {} more than two triangles; repairing mends this",
                                   counted(faults.nonmanifold_edges, "edge"),
                                   faults.nonmanifold_edges == 1 ? "has" : "have"));
  if (found.degenerate > 0)
    warnings.push_back(
        fmt::format("{} no area{}; repairing drops {}",
                    found.degenerate == 1 ? "1 triangle has"
                                          : fmt::format("{} triangles have", found.degenerate),
                    found.holes.empty() || faults.holes + faults.seams + faults.flaps > 0
                        ? ""
                        : ", which leaves the surface without a volume",
                    found.degenerate == 1 ? "it" : "them"));
  return warnings;
}

/// Volume and mass of the union of a mesh's parts; empty where a part has holes, non-manifold edges
/// or reversed edges.
struct MeshMass {
  bool closed = false;
  double enclosed = 0;  // signed, each part counted [m^3]
  UnionMass all;
};

MeshMass mass_of_parts(const TriangleMesh& mesh, const std::vector<TriangleMesh>& parts) {
  // The divergence theorem needs every part to be closed and consistently oriented.
  MeshMass found;
  for (const TriangleMesh& part : parts) {
    const MeshReport report = check_mesh(part);
    if (!report.holes.empty() || report.nonmanifold_edges > 0 || report.reversed_edges > 0)
      return {};
    found.enclosed += report.volume;
  }
  found.closed = true;
  // Parts may overlap, so weigh their union rather than their sum.
  if (!(found.enclosed > 0)) return found;
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh = mesh;
  try {
    found.all = union_mass({shape});
  } catch (const InputError&) {
    found.closed = false;  // as one of its parts is flat
  }
  return found;
}

/// Computes volume, centre and inertia of triangles, and doubts about them.
void weigh_triangles(const TriangleMesh& mesh, MeshFacts& facts) {
  // Weigh connected parts one by one: a mesh may hold several solids.
  const std::vector<TriangleMesh> parts = connected_parts(mesh);
  facts.parts = parts.size();
  const MeshMass found = mass_of_parts(mesh, parts);
  facts.unit_mass = found.all.mass;
  facts.solid = facts.unit_mass.mass > 0;
  if (found.closed && !facts.solid && !facts.faults.flat)
    facts.warnings.emplace_back(found.enclosed < 0
                                    ? "inside out: the surface faces inwards, repairing turns it"
                                    : "no volume: the surface encloses nothing");
  // Share of the volume in which parts may overlap by rounding [1]
  constexpr double kOverlapShare = 1e-6;
  if (facts.solid && found.enclosed > (1 + kOverlapShare) * facts.unit_mass.mass)
    facts.warnings.push_back(fmt::format(
        "parts overlap: volume, centre and inertia are of their union{}; their volumes add up to "
        "{:.3g} % more",
        found.all.error > 0 ? fmt::format(", to about {:.1g}", found.all.error) : "",
        100 * (found.enclosed / facts.unit_mass.mass - 1)));
}

/// Replaces mass and warnings of the triangles by those of the exact solids.
void weigh_exact(const MeshContent& content, MeshFacts& facts) {
  // Exact solids are weighed without triangles, whose warnings no longer matter.
  const UnionMass all = union_mass(content.exact);
  facts.unit_mass = all.mass;
  facts.solid = all.mass.mass > 0;
  facts.warnings.clear();
  if (const std::string size = mesh_size_warning(content.mesh); !size.empty())
    facts.warnings.push_back(size);
  if (all.error > 0)
    facts.warnings.push_back(
        fmt::format("parts overlap: volume, centre and inertia are of their union, to about {:.1g}",
                    all.error));
}

}  // namespace

MeshFacts compute_mesh_facts(const MeshContent& content) {
  // Look at the surface first: without a volume there is no mass.
  MeshFacts facts;
  facts.surface = check_mesh(content.mesh);
  facts.across = extent_of(content.mesh);
  facts.faults = find_mesh_faults(content.mesh);
  facts.warnings = surface_warnings(facts.surface, facts.faults);
  if (const std::string size = mesh_size_warning(content.mesh); !size.empty())
    facts.warnings.push_back(size);
  weigh_triangles(content.mesh, facts);
  // Exact shapes, where the format states them, replace the triangles.
  if (!content.exact.empty()) weigh_exact(content, facts);
  return facts;
}

std::vector<std::string> density_warnings(const BodySpec& body, const std::string& owner) {
  // Range of densities of known materials [kg/m^3]
  constexpr double kMinDensity = 10, kMaxDensity = 25'000;
  constexpr double kGramPerCm3 = 1000;  // A gram per cubic centimetre [kg/m^3]
  // Take the density from the mass over the volume, or as it is stated.
  const double mass = body.mass ? body.mass->mass : body.uniform_mass;
  double density = body.density;
  if (mass > 0) try {
      density = mass / union_mass(body.shapes).mass.mass;
    } catch (const InputError&) {
      return {};  // no volume
    }
  if (!(density > 0) || (density >= kMinDensity && density <= kMaxDensity)) return {};
  return {fmt::format("{}: {:.4g} g/cm3: is its {} or its size in another unit{}?", owner,
                      density / kGramPerCm3, mass > 0 ? "mass" : "density",
                      density > kMaxDensity && mass > 0 ? " (grams)" : "")};
}

std::vector<std::string> size_warnings(const std::vector<ShapeSpec>& shapes,
                                       const std::string& owner) {
  std::vector<std::string> warnings;
  for (const ShapeSpec& shape : shapes)
    if (const double across = extent_of(shape); across > kMaxObjectSize)
      warnings.push_back(fmt::format("{}: a {} of {:.4g} m: are its numbers millimetres?", owner,
                                     name_of(shape.kind), across));
  return warnings;
}

}  // namespace thenar
