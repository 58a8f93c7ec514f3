#include "data/io/graspit/graspit_body.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/error.h"
#include "data/io/graspit/graspit_transform.h"
#include "data/io/graspit/xml_file.h"

namespace thenar {
namespace {

bool is_xml(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".xml";
}

Eigen::Vector3d vector3(const XmlFile& file, const pugi::xml_node& node) {
  const std::vector<double> v = file.numbers(node, 3);
  return kGraspitLength * Eigen::Vector3d(v[0], v[1], v[2]);
}

/// The file is per mass and in mm^2.
std::optional<Eigen::Matrix3d> inertia_per_mass(const XmlFile& file, const pugi::xml_node& node,
                                                std::vector<std::string>& warnings) {
  const std::vector<double> v = file.numbers(node);
  if (v.size() == 9)
    return kGraspitLength * kGraspitLength * Eigen::Map<const Eigen::Matrix3d>(v.data());
  warnings.push_back(fmt::format("{}:{}: wanted 9 numbers in <inertia_matrix>, got {}: left out",
                                 file.path(), file.line(node), v.size()));
  return {};
}

void read_element(const XmlFile& file, const pugi::xml_node& node, GraspitBody& body) {
  const std::string name = node.name();
  if (name == "geometryFile") {
    body.geometry_file =
        (std::filesystem::path(file.path()).parent_path() / file.text(node)).string();
  } else if (name == "geometryScaling") {
    body.geometry_scale = kGraspitLength * file.numbers(node, 1)[0];
  } else if (name == "geometryOffset") {
    body.geometry_offset = vector3(file, node);
  } else if (name == "material") {
    body.material = file.text(node);
  } else if (name == "mass") {
    body.mass = kGraspitMass * file.numbers(node, 1)[0];
  } else if (name == "cog") {
    body.com = vector3(file, node);
  } else if (name == "inertia_matrix") {
    body.inertia = inertia_per_mass(file, node, body.warnings);
  } else if (node.type() == pugi::node_element) {
    body.warnings.push_back(file.not_understood(node));
  }
}

}  // namespace

GraspitBody read_graspit_body(const std::string& path) {
  GraspitBody body;
  if (!is_xml(path)) {
    body.geometry_file = path;
    return body;
  }
  const XmlFile file(path);
  for (const pugi::xml_node& node : file.root().children()) read_element(file, node, body);
  if (body.mass < 0) file.fail(file.root().child("mass"), "wanted a <mass> >= 0");
  if (body.inertia && body.mass > 0) {
    *body.inertia *= body.mass;
  } else {
    body.inertia.reset();
  }
  return body;
}

}  // namespace thenar
