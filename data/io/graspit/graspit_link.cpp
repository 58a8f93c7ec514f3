#include "data/io/graspit/graspit_link.h"

#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "base/words.h"
#include "data/io/graspit/graspit_transform.h"
#include "data/io/graspit/xml_file.h"

namespace thenar {
namespace {

bool is_xml(const std::string& path) {
  return lower_case(std::filesystem::path(path).extension()) == ".xml";
}

/// Inertia per mass [m^2]; the file states it in mm^2.
std::optional<Eigen::Matrix3d> inertia_per_mass(const XmlFile& file, const pugi::xml_node& node,
                                                std::vector<std::string>& warnings) {
  const std::vector<double> v = file.numbers(node);
  if (v.size() == 9)
    return kGraspitLength * kGraspitLength * Eigen::Map<const Eigen::Matrix3d>(v.data());
  warnings.push_back(fmt::format("{}:{}: wanted 9 numbers in <inertia_matrix>, got {}: left out",
                                 file.path(), file.line(node), v.size()));
  return {};
}

double unit_of(const XmlFile& file, const pugi::xml_node& geometry) {
  static const std::map<std::string, double> units{
      {"mm", kGraspitLength}, {"cm", 1e-2}, {"m", 1}, {"in", 0.0254}};
  // The first of both spellings that is there.
  for (const char* name : {"Units", "units"})
    if (const pugi::xml_attribute attribute = geometry.attribute(name)) {
      const auto found = units.find(attribute.value());
      if (found == units.end())
        file.fail(geometry,
                  fmt::format("wanted {} mm, cm, m or in, got '{}'", name, attribute.value()));
      return found->second;
    }
  return kGraspitLength;
}

void read_geometry(const XmlFile& file, GraspitLink& body) {
  const pugi::xml_node geometry = file.root().child("geometryFile");
  if (!geometry) return;
  // The mesh file, beside this one.
  body.geometry_file =
      (std::filesystem::path(file.path()).parent_path() / file.text(geometry)).string();
  body.geometry_scale = unit_of(file, geometry) * geometry.attribute("scale").as_double(1);
  // Scales multiply.
  for (const char* name : {"geometryScaling", "geometryScale"})
    if (const pugi::xml_node scaling = file.root().child(name))
      body.geometry_scale *= file.numbers(scaling, 1)[0];
  if (!(body.geometry_scale > 0)) file.fail(geometry, "wanted its scale > 0");
  // Pose of the mesh in the link: a transform, or three lengths.
  const pugi::xml_node offset = file.root().child("geometryOffset");
  if (!offset.child("transform").empty())
    body.X_LG = graspit_transform(file, offset, body.warnings);
  else if (offset)
    body.X_LG.p = kGraspitLength * file.vector3(offset);
}

/// Reads one element of a body; unknown elements become warnings.
void read_element(const XmlFile& file, const pugi::xml_node& node, GraspitLink& body) {
  const std::string name = node.name();
  if (name.rfind("geometry", 0) == 0) return;  // see read_geometry()
  if (name == "material") {
    body.material = file.text(node);
  } else if (name == "mass") {
    body.mass = kGraspitMass * file.numbers(node, 1)[0];
  } else if (name == "cog") {
    body.com = kGraspitLength * file.vector3(node);
  } else if (name == "inertia_matrix") {
    body.inertia = inertia_per_mass(file, node, body.warnings);
  } else if (node.type() == pugi::node_element) {
    body.warnings.push_back(file.not_understood(node));
  }
}

}  // namespace

GraspitLink read_graspit_link(const std::string& path) {
  GraspitLink body;
  // A mesh file is a body of geometry alone.
  if (!is_xml(path)) {
    body.geometry_file = path;
    return body;
  }
  const XmlFile file(path);
  for (const pugi::xml_node& node : file.root().children()) read_element(file, node, body);
  read_geometry(file, body);
  // Inertia needs a mass.
  if (body.mass < 0) file.fail(file.root().child("mass"), "wanted a <mass> >= 0");
  if (body.mass == 0) body.inertia.reset();
  if (body.inertia) *body.inertia *= body.mass;
  return body;
}

}  // namespace thenar
