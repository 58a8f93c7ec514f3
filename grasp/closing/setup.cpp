#include "grasp/closing/setup.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include "base/error.h"
#include "base/lists.h"
#include "base/nearest_name.h"
#include "geometry/mass_properties.h"
#include "geometry/mesh_faults.h"
#include "geometry/shape_reach.h"

namespace thenar {
namespace {

/// Returns the centroid of a body's volume: of the union, if shapes or parts of meshes overlap [m]
/// (3)
Eigen::Vector3d volume_centre(const BodySpec& body) {
  BodySpec even = body;
  even.density = 1;
  even.uniform_mass = 0;
  return body_mass(even).com;
}

std::vector<std::string> names_of(const WorldSpec& world) {
  return transformed(world.bodies, [](const PlacedBody& placed) { return placed.body.name; });
}

/// Calls build_solid(), with the body and its meshes named in errors.
Solid solid_of(const BodySpec& body) {
  try {
    return build_solid(body.shapes);
  } catch (const InputError& error) {
    std::string files;
    for (const ShapeSpec& shape : body.shapes)
      if (!shape.mesh_file.empty()) files += (files.empty() ? "" : ", ") + shape.mesh_file;
    if (files.empty()) throw InputError(fmt::format("body '{}': {}", body.name, error.what()));
    throw InputError(
        fmt::format("body '{}' of {}: {}{}", body.name, files, error.what(),
                    any_is_flat(body.shapes) ? "" : "; `thenar import` with repairs mends a mesh"));
  }
}

bool is_object(const PlacedBody& placed, const std::string& name) {
  return name.empty() ? placed.dynamic : placed.body.name == name;
}

}  // namespace

GraspBody build_body(const PlacedBody& placed) {
  GraspBody body;
  body.name = placed.body.name;
  body.material = placed.body.material.empty() ? kDefaultMaterial : placed.body.material;
  body.solid = solid_of(placed.body);
  body.X_WB = placed.X_WB;
  // Centre of mass, or of volume if the mass is unknown.
  body.com = placed.body.mass ? placed.body.mass->com : volume_centre(placed.body);
  for (const ShapeSpec& shape : placed.body.shapes)
    body.torque_scale = std::max(body.torque_scale, reach_of(shape, body.com));
  body.box = body_box(body.solid.visual);
  return body;
}

GraspSetup build_setup(const WorldSpec& world, const std::string& object) {
  GraspSetup setup;
  bool found = false;
  // The object is the named body, or the only dynamic one; all others are obstacles.
  for (const PlacedBody& placed : world.bodies) {
    if (!is_object(placed, object)) {
      setup.obstacles.push_back(build_body(placed));
      continue;
    }
    require(placed.dynamic, "world '{}': body '{}' is an obstacle; wanted one of role \"object\"",
            world.name, object);
    require(!found, "world '{}' has more than one dynamic body{}: name the one to grasp",
            world.name, object.empty() ? "" : " '" + object + "'");
    setup.object = build_body(placed);
    found = true;
  }
  require(found || !object.empty(), "world '{}' has no dynamic body to grasp", world.name);
  require(found, "world '{}' has no body '{}'{}", world.name, object,
          did_you_mean(object, names_of(world)));
  setup.materials = world.materials;
  return setup;
}

namespace {

// Maximum ratio of volumes at which the box along principal axes is preferred [1]
constexpr double kMaxVolumeRatio = 0.99;

/// Returns the bounding box of points along given axes.
BodyBox box_along(const Eigen::Matrix3d& axes, const Eigen::Matrix3Xd& points) {
  const Eigen::Matrix3Xd along = axes.transpose() * points;
  return {axes, (along.rowwise().maxCoeff() - along.rowwise().minCoeff()) / 2};
}

/// Sorts the axes of a box by length, and keeps them right-handed.
BodyBox longest_first(const BodyBox& box) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return box.half[a] > box.half[b]; });
  BodyBox sorted;
  for (int i = 0; i < 3; ++i) {
    sorted.axes.col(i) = box.axes.col(order[i]);
    sorted.half[i] = box.half[order[i]];
  }
  if (sorted.axes.determinant() < 0) sorted.axes.col(2) *= -1;
  return sorted;
}

}  // namespace

BodyBox body_box(const TriangleMesh& picture) {
  // Boxes along the frame and along the principal axes of inertia.
  const BodyBox framed = box_along(Eigen::Matrix3d::Identity(), picture.vertices);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> inertia(mass_properties(picture, 1).inertia);
  const BodyBox turned = box_along(inertia.eigenvectors(), picture.vertices);
  const bool smaller = turned.half.prod() < kMaxVolumeRatio * framed.half.prod();
  return longest_first(smaller ? turned : framed);
}

}  // namespace thenar
