#include "data/io/world/graspit_body.h"

#include <filesystem>
#include <map>
#include <set>

#include <pugixml.hpp>

#include "base/error.h"
#include "base/file_io.h"
#include "base/lists.h"
#include "base/outside_path.h"
#include "data/io/graspit/graspit_transform.h"

namespace thenar {
namespace {

namespace fs = std::filesystem;

/// The exact shapes of a geometry file, otherwise one mesh.
std::vector<ShapeSpec> read_shapes(const std::string& path, double scale, MeshReader& meshes) {
  const MeshContent& content = meshes.content(path, scale);
  if (!content.exact.empty()) return content.exact;
  ShapeSpec shape;
  shape.kind = ShapeKind::kMesh;
  shape.mesh_file = fs::absolute(path).lexically_normal().string();
  shape.mesh_scale = scale;
  shape.mesh = content.mesh;
  return {shape};
}

/// Length of one unit of a geometry file [m].
double unit_of(const XmlFile& file, const pugi::xml_node& geometry) {
  static const std::map<std::string, double> units{
      {"", kGraspitLength}, {"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}, {"in", 0.0254}};
  std::string name = geometry.attribute("Units").as_string();
  if (name.empty()) name = geometry.attribute("units").as_string();
  const auto found = units.find(name);
  if (found == units.end())
    file.fail(geometry, fmt::format("wanted 'Units' to be mm, cm, m or in, got '{}'", name));
  return found->second;
}

/// Reads a scale: one number, or three equal ones.
double scaling(const XmlFile& file, const pugi::xml_node& node) {
  const std::vector<double> v = file.numbers(node);
  const bool even = v.size() == 1 || (v.size() == 3 && v[0] == v[1] && v[1] == v[2]);
  if (!even || v[0] <= 0)
    file.fail(node,
              fmt::format("wanted one scale > 0 in <{}>, got '{}'", node.name(), file.text(node)));
  return v[0];
}

double scale_of(const XmlFile& file, const pugi::xml_node& geometry) {
  // Unit, attribute and elements multiply.
  double scale = unit_of(file, geometry);
  if (const pugi::xml_attribute attribute = geometry.attribute("scale")) {
    if (!(attribute.as_double() > 0))
      file.fail(geometry, fmt::format("wanted 'scale' > 0, got '{}'", attribute.as_string()));
    scale *= attribute.as_double();
  }
  for (const char* name : {"geometryScaling", "geometryScale"})
    if (const pugi::xml_node node = file.root().child(name)) scale *= scaling(file, node);
  return scale;
}

std::vector<ShapeSpec> read_geometry(const XmlFile& file, MeshReader& meshes,
                                     std::vector<std::string>& warnings) {
  const pugi::xml_node geometry = file.root().child("geometryFile");
  if (!geometry)
    file.fail(file.root(),
              fmt::format("wanted <robot> (URDF, GraspIt!), <mujoco>, <world> or a GraspIt! body "
                          "with a <geometryFile>, got <{}>",
                          file.root_name()));
  // The file beside the body.
  std::string path;
  try {
    path = linked_path(fs::path(file.path()).parent_path().string(), file.text(geometry));
  } catch (const InputError& error) {
    file.fail(geometry, error.what());
  }
  if (!is_file(path)) file.fail(geometry, fmt::format("there is no geometry file '{}'", path));
  std::vector<ShapeSpec> shapes = read_shapes(path, scale_of(file, geometry), meshes);
  // Its pose in the body.
  if (const pugi::xml_node offset = file.root().child("geometryOffset")) {
    const Pose<double> X_BG = graspit_transform(file, offset, warnings);
    for (ShapeSpec& shape : shapes) shape.X_BS = X_BG * shape.X_BS;
  }
  return shapes;
}

void read_mass(const XmlFile& file, BodySpec& body) {
  const pugi::xml_node mass = file.root().child("mass"), cog = file.root().child("cog"),
                       inertia = file.root().child("inertia_matrix");
  if (!mass) return;
  const double kilograms = kGraspitMass * file.numbers(mass, 1)[0];
  if (kilograms <= 0) file.fail(mass, "wanted a mass > 0");
  // Without centre and inertia the mass is spread evenly.
  if (!cog || !inertia) {
    body.uniform_mass = kilograms;
    return;
  }
  // Inertia per mass, made symmetric.
  const std::vector<double> c = file.numbers(cog, 3), v = file.numbers(inertia, 9);
  const Eigen::Matrix3d over_mass =
      kGraspitLength * kGraspitLength * Eigen::Map<const Eigen::Matrix3d>(v.data());
  body.mass = BodyMass{kilograms, kGraspitLength * Eigen::Vector3d(c[0], c[1], c[2]),
                       kilograms / 2 * (over_mass + over_mass.transpose())};
}

std::string read_material(const XmlFile& file, std::vector<std::string>& warnings) {
  const pugi::xml_node node = file.root().child("material");
  std::string name = file.text(node);
  if (find_named(built_in_materials().materials, name) != nullptr) return name;
  if (node)
    warnings.push_back(fmt::format("{}:{}: material '{}' is not known and was left out",
                                   file.path(), file.line(node), name));
  return "";
}

}  // namespace

GraspitBody read_graspit_body(const std::string& path) {
  MeshReader meshes;
  return read_graspit_body(path, meshes);
}

GraspitBody read_graspit_body(const std::string& path, MeshReader& meshes) {
  GraspitBody read;
  read.body.name = fs::path(path).stem().string();
  // A mesh file is a body by itself.
  if (fs::path(path).extension() != ".xml") {
    read.body.shapes = read_shapes(path, kGraspitLength, meshes);
    return read;
  }
  const XmlFile file(path);
  // Elements that are read; others become warnings.
  static const std::set<std::string> known{"material",       "mass",          "cog",
                                           "inertia_matrix", "geometryFile",  "geometryScaling",
                                           "geometryScale",  "geometryOffset"};
  for (const pugi::xml_node& node : file.root().children())
    if (node.type() == pugi::node_element && known.count(node.name()) == 0)
      read.warnings.push_back(file.not_understood(node));
  read.body.material = read_material(file, read.warnings);
  read_mass(file, read.body);
  read.body.shapes = read_geometry(file, meshes, read.warnings);
  return read;
}

}  // namespace thenar
