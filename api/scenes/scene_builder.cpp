#include "api/scenes/scene_builder.h"

#include <utility>

#include "base/error.h"
#include "base/lists.h"

namespace thenar {

SceneBuilder::SceneBuilder(std::string name) {
  require(!name.empty(), "wanted the name of a scene, got none");
  // Messages name the scene where those of a file have its path.
  spec_.path = name;
  spec_.source = "Scene";
  spec_.name = std::move(name);
}

void SceneBuilder::require_new(const std::string& name) const {
  for (const SceneBodySpec& body : spec_.bodies)
    require(body.placed.body.name != name, "'{}' is there already", name);
  for (const SceneHandSpec& hand : spec_.hands)
    require(hand.placed.name != name, "'{}' is there already", name);
}

SceneBodySpec& SceneBuilder::add_body(BodySpec body, const Eigen::Vector3d& at) {
  require_new(body.name);
  require(at.allFinite(), "wanted a place of '{}' in numbers, got ({:g}, {:g}, {:g}) m", body.name,
          at.x(), at.y(), at.z());
  SceneBodySpec added;
  added.placed.body = std::move(body);
  added.placed.X_WB.p = at;
  spec_.bodies.push_back(std::move(added));
  return spec_.bodies.back();
}

SceneBodySpec& SceneBuilder::add_box(const std::string& name, const Eigen::Vector3d& edges,
                                     double mass, const Eigen::Vector3d& at) {
  return add_body(make_body(name, box_shape(edges), mass), at);
}

SceneBodySpec& SceneBuilder::add_ball(const std::string& name, double radius, double mass,
                                      const Eigen::Vector3d& at) {
  return add_body(make_body(name, ball_shape(radius), mass), at);
}

SceneBodySpec& SceneBuilder::add_cylinder(const std::string& name, double radius, double height,
                                          double mass, const Eigen::Vector3d& at) {
  return add_body(make_body(name, cylinder_shape(radius, height), mass), at);
}

SceneBodySpec& SceneBuilder::add_mesh(const std::string& name, TriangleMesh mesh, double mass,
                                      const Eigen::Vector3d& at) {
  return add_body(make_body(name, mesh_shape(std::move(mesh)), mass), at);
}

SceneBodySpec& SceneBuilder::add_floor(double height) {
  SceneBodySpec& floor =
      add_body(make_body("floor", box_shape({2, 2, 0.1}), 0, "stone"), {0, 0, height - 0.05});
  floor.joint.kind = JointKind::kWeld;
  return floor;
}

SceneHandSpec& SceneBuilder::add_hand(const std::string& name, const Pose<double>& X_WH) {
  require_new(name);
  SceneHandSpec added;
  added.placed.name = name;
  added.placed.X_WH = X_WH;
  added.joint.kind = JointKind::kWeld;
  spec_.hands.push_back(std::move(added));
  return spec_.hands.back();
}

void SceneBuilder::set_contact(double friction, double restitution) {
  // One entry for all pairs; an earlier one is replaced.
  erase_where(spec_.frictions, [](const SceneFrictionSpec& each) { return each.between.empty(); });
  SceneFrictionSpec all;
  all.coefficient = friction;
  all.restitution = restitution;
  spec_.frictions.push_back(all);
}

}  // namespace thenar
