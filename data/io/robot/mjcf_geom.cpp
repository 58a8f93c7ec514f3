#include "base/lists.h"
#include "data/io/robot/mjcf_parts.h"

#include <filesystem>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "data/io/mesh/repair_shape.h"
#include "data/io/robot/import_mesh.h"
#include "solvers/convex_hull.h"

namespace thenar::internal {
namespace {

/// Converts MuJoCo's sizes (half lengths) to ours.
void set_primitive(ShapeSpec& shape, const MjcfElement& geom, const std::string& type,
                   const std::vector<double>& size) {
  const auto want = [&](std::size_t count) {
    if (size.size() < count)
      geom.fail(fmt::format("a geom of type {} wants {} size{}, got {}", type, count,
                            count == 1 ? "" : "s", size.size()));
  };
  // Each type has its number of sizes.
  want(type == "box" || type == "ellipsoid" ? 3 : type == "sphere" ? 1 : 2);
  if (type == "sphere") {
    shape.kind = ShapeKind::kSphere;
    shape.size.x() = size[0];
  } else if (type == "box") {
    shape.kind = ShapeKind::kBox;
    shape.size = 2 * Eigen::Vector3d(size[0], size[1], size[2]);
  } else if (type == "ellipsoid") {
    shape.kind = ShapeKind::kEllipsoid;
    shape.size = {size[0], size[1], size[2]};
  } else {
    shape.kind = type == "capsule" ? ShapeKind::kCapsule : ShapeKind::kCylinder;
    shape.size = {size[0], 2 * size[1], 0};
  }
}

/// Pose and half length of a geom between two points.
void apply_from_to(const MjcfElement& geom, Pose<double>& X, std::vector<double>& size) {
  const std::vector<double> ends = geom.numbers("fromto");
  if (ends.size() != 6) geom.fail(fmt::format("fromto wants 6 numbers, got {}", ends.size()));
  const Eigen::Vector3d from(ends[0], ends[1], ends[2]), to(ends[3], ends[4], ends[5]);
  if ((from - to).isZero(0)) geom.fail("fromto wants two different points");
  if (size.empty()) geom.fail("fromto wants size=\"RADIUS\"");
  // z along the line, at its middle.
  X = {rotation_to(from - to), (from + to) / 2};
  const double half = (from - to).norm() / 2;
  const std::string type = geom.text("type", "sphere");
  // Radius first, half length last.
  size.resize(1);
  if (type == "box" || type == "ellipsoid") size.push_back(size[0]);
  size.push_back(half);
}

/// Triangles of the convex hull of points, counterclockwise from outside (3, triangles); none of
/// points in a plane.
std::vector<double> hull_faces(const std::vector<double>& corners) {
  if (corners.size() < 12) return {};
  const ConvexHull hull =
      convex_hull(Eigen::Map<const Eigen::Matrix3Xd>(corners.data(), 3,
                                                     static_cast<Eigen::Index>(corners.size() / 3))
                      .transpose());
  std::vector<double> faces;
  for (const HullFacet& facet : hull.facets)
    for (std::size_t i = 2; i < facet.ring.size(); ++i)
      for (const int corner : {facet.ring[0], facet.ring[i - 1], facet.ring[i]})
        faces.push_back(corner);
  return faces;
}

/// Sets a mesh from vertices and triangles in the file itself; of vertices alone their convex hull,
/// as MuJoCo takes them. @returns false if there are no faces, and no hull as all vertices are in a
/// plane
bool set_written_mesh(ShapeSpec& shape, const MjcfElement& mesh, const MeshPlacement& placement) {
  const std::vector<double> corners = mesh.numbers("vertex");
  std::vector<double> faces = mesh.numbers("face");
  if (faces.empty() && corners.size() % 3 == 0) faces = hull_faces(corners);
  if (corners.empty() || faces.empty()) return false;
  if (corners.size() % 3 != 0 || faces.size() % 3 != 0)
    mesh.fail("vertex and face want three numbers each");
  const std::size_t vertices = corners.size() / 3;
  const auto is_vertex = [&](double face) {
    return face >= 0 && face < static_cast<double>(vertices);
  };
  // Faces refer to existing vertices.
  if (!all_of(faces, is_vertex)) mesh.fail("a face names a vertex that is not there");
  shape.kind = ShapeKind::kMesh;
  shape.mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(
      corners.data(), 3, static_cast<Eigen::Index>(corners.size() / 3));
  shape.mesh.triangles = Eigen::Map<const Eigen::Matrix3Xd>(
                             faces.data(), 3, static_cast<Eigen::Index>(faces.size() / 3))
                             .cast<int>();
  // Placed like a mesh from a file.
  shape.mesh.vertices = (placement.A * shape.mesh.vertices).colwise() + placement.b;
  if (placement.A.determinant() < 0) shape.mesh.triangles.row(1).swap(shape.mesh.triangles.row(2));
  return true;
}

/// Map of a mesh,  v -> S R' (v - refpos).
MeshPlacement placement_of(const MjcfElement& mesh) {
  const Eigen::Vector3d scale = mesh.vector3("scale", Eigen::Vector3d::Ones());
  const Eigen::Vector3d moved = mesh.vector3("refpos", Eigen::Vector3d::Zero());
  MeshPlacement placement;
  placement.A = scale.asDiagonal();
  const std::vector<double> q = mesh.numbers("refquat");
  if (q.size() == 4)
    placement.A *=
        Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix().transpose();
  placement.b = -(placement.A * moved);
  return placement;
}

bool set_mesh(ShapeSpec& shape, const MjcfSource& source, const MjcfMeshes& meshes,
              const MjcfElement& geom, const std::string& body,
              std::vector<std::string>& warnings) {
  const std::string name = geom.text("mesh");
  const auto found = meshes.find(name);
  if (found == meshes.end()) geom.fail(fmt::format("there is no mesh '{}' in <asset>", name));
  const MjcfElement mesh(source, found->second, "");
  const MeshPlacement placement = placement_of(mesh);
  // Written in the file itself, or in a file of its own.
  if (!mesh.has("file")) {
    if (set_written_mesh(shape, mesh, placement)) return true;
    warnings.push_back(
        mesh.numbers("vertex").empty()
            ? fmt::format("MISSING MESH '{}', which has neither file nor vertices: link '{}' goes "
                          "without it",
                          name, body)
            : fmt::format("LEFT OUT mesh '{}' of link '{}': the mesh is flat: all its vertices lie "
                          "in one plane, so that their hull has no thickness",
                          name, body));
    return false;
  }
  std::filesystem::path file = mesh.text("file");
  if (source.compiler.strip_path) file = file.filename();
  const std::string path = (std::filesystem::path(source.compiler.mesh_folder) / file).string();
  return try_mesh(shape, path, placement, {source.file.path(), source.meshes}, body, warnings);
}

bool set_shape(ShapeSpec& shape, const MjcfSource& source, const MjcfMeshes& meshes,
               const MjcfElement& geom, const std::string& body,
               std::vector<std::string>& warnings) {
  const std::string type = geom.text("type", "sphere");
  // Meshes, and primitives fitted to meshes.
  if (type == "mesh" || geom.has("mesh")) {
    if (type != "mesh")
      warnings.push_back(
          fmt::format("a {} fitted to a mesh, of link '{}': the mesh itself is taken", type, body));
    return set_mesh(shape, source, meshes, geom, body, warnings);
  }
  // Unbounded or sampled shapes are left out.
  if (type == "plane" || type == "hfield" || type == "sdf") {
    warnings.push_back(
        fmt::format("a {} of link '{}' is left out (line {})", type, body, geom.line()));
    return false;
  }
  if (type != "sphere" && type != "box" && type != "ellipsoid" && type != "capsule" &&
      type != "cylinder")
    geom.fail(fmt::format("unknown type of geom: '{}'", type));
  std::vector<double> size = geom.numbers("size");
  if (geom.has("fromto")) apply_from_to(geom, shape.X_BS, size);
  set_primitive(shape, geom, type, size);
  return true;
}

/// The shape as it will be repaired, so that a mesh that bounds no solid has a mass.
ShapeSpec solid(ShapeSpec shape) {
  if (shape.kind != ShapeKind::kMesh || mass_at_unit_density(shape).mass > 0) return shape;
  std::vector<std::string> told_later;
  if (!repair_shape(shape, "", told_later)) shape.mesh = {};
  return shape;
}

/// Notes contact settings of MuJoCo that a material does not have.
void note_contact(const MjcfSource& source, const MjcfElement& geom) {
  const pugi::xml_node node = geom.node();
  if (geom.has("friction"))
    source.unread.note(node,
                       "friction of a <geom> is not read: that of its link's material counts");
  for (const char* attribute : {"condim", "solref", "solimp", "margin", "gap"})
    if (geom.has(attribute))
      source.unread.note(node, fmt::format("{} of a <geom> is not read", attribute));
}

MassProperties read_inertial(const MjcfInertial& stated) {
  const MjcfElement& inertial = stated.element;
  if (!inertial.has("mass")) inertial.fail("<inertial> wants mass=\"..\"");
  Eigen::Matrix3d I = Eigen::Matrix3d::Zero();
  // A full tensor, or its diagonal.
  const std::vector<double> full = inertial.numbers("fullinertia");
  if (!full.empty()) {
    if (full.size() != 6) inertial.fail("fullinertia wants 6 numbers");
    I << full[0], full[3], full[4],  //
        full[3], full[1], full[5],   //
        full[4], full[5], full[2];
  } else {
    I = inertial.vector3("diaginertia", Eigen::Vector3d::Zero()).asDiagonal();
  }
  // In the frame of the body.
  const Pose<double> X = stated.X_BF * inertial.pose();
  return {inertial.number("mass", 0), X.p, X.R * I * X.R.transpose()};
}

}  // namespace

MjcfMeshes find_meshes(const MjcfSource& source) {
  MjcfMeshes meshes;
  for (const pugi::xml_node asset : source.file.root().children("asset"))
    for (const pugi::xml_node node : asset.children()) {
      // Other assets are only noted.
      if (std::string(node.name()) != "mesh") {
        if (node.type() == pugi::node_element)
          source.unread.note(node, fmt::format("<{}> in <asset> is not read", node.name()));
        continue;
      }
      std::string name = node.attribute("name").value();
      if (name.empty()) name = std::filesystem::path(node.attribute("file").value()).stem();
      meshes[name] = node;
    }
  return meshes;
}

MjcfGeom read_geom(const MjcfSource& source, const MjcfMeshes& meshes, const MjcfElement& geom,
                   const Pose<double>& X_BF, const std::string& body,
                   std::vector<std::string>& warnings) {
  MjcfGeom result;
  // Contact settings, and whether it collides at all.
  note_contact(source, geom);
  result.collides = geom.number("contype", 1) != 0 || geom.number("conaffinity", 1) != 0;
  ShapeSpec shape;
  shape.X_BS = geom.pose();
  if (!set_shape(shape, source, meshes, geom, body, warnings)) return result;
  shape.X_BS = X_BF * shape.X_BS;
  // Mass of geoms in the groups that count.
  const double group = geom.number("group", 0);
  if (group >= source.compiler.min_group && group <= source.compiler.max_group) {
    result.mass = mass_at_unit_density(solid(shape));
    const double volume = result.mass.mass;
    // A stated mass, or a density.
    const double density = geom.has("mass")
                               ? (volume > 0 ? geom.number("mass", 0) / volume : 0)
                               : geom.number("density", 1000);  // water, MuJoCo's default [kg/m^3]
    result.mass.mass *= density;
    result.mass.inertia *= density;
  }
  result.shape = std::move(shape);
  return result;
}

MassProperties mass_of_body(const MjcfCompiler& compiler,
                            const std::optional<MjcfInertial>& inertial,
                            const std::vector<MassProperties>& geoms) {
  MassProperties mass;
  // The compiler's settings decide where the mass comes from.
  if (compiler.inertia_from_geom == "true" || (compiler.inertia_from_geom == "auto" && !inertial)) {
    mass = sum_of_masses(geoms);
  } else if (inertial) {
    mass = read_inertial(*inertial);
  }
  // A lower bound of the mass.
  if (mass.mass < compiler.bound_mass) mass.mass = compiler.bound_mass;
  return mass;
}

}  // namespace thenar::internal
