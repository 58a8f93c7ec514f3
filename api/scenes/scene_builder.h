#pragma once

/// Scenes built in a program, without a file.
/// Example: examples/12_falling_cube.cpp.

#include <string>

#include "data/io/scene/scene.h"
#include "data/io/world/make_body.h"

namespace thenar {

/// Builder of a scene, part by part:
///
///     SceneBuilder scene("a cube that falls");
///     scene.add_floor();
///     scene.add_box("cube", {0.05, 0.05, 0.05}, 0.1, {0, 0, 0.2});
///     const SceneResult fall = simulate_scene(scene.spec());
///
/// References returned by add_..() are valid until the next part of the same kind is added: joints,
/// velocities, materials and postures may be changed through them.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::string name);

  /// Adds a free body whose frame is at a place of the world, unrotated.
  /// @param at  origin of its frame, world [m] (3)
  /// @throws InputError if the name is taken, or the place is not finite.
  SceneBodySpec& add_body(BodySpec body, const Eigen::Vector3d& at = {0, 0, 0});

  /// Adds a free body of one shape; arguments as of box_shape() .. and make_body().
  /// @throws InputError as make_body() and add_body().
  SceneBodySpec& add_box(const std::string& name, const Eigen::Vector3d& edges, double mass,
                         const Eigen::Vector3d& at);
  SceneBodySpec& add_ball(const std::string& name, double radius, double mass,
                          const Eigen::Vector3d& at);
  SceneBodySpec& add_cylinder(const std::string& name, double radius, double height, double mass,
                              const Eigen::Vector3d& at);
  SceneBodySpec& add_mesh(const std::string& name, TriangleMesh mesh, double mass,
                          const Eigen::Vector3d& at);

  /// Adds the body "floor": a slab of stone of 2 m x 2 m, 0.1 m thick, that does not move.
  /// @param height  height of its top [m]
  SceneBodySpec& add_floor(double height = 0);

  /// Adds a hand, welded to the world: a robot ("barrett", a file) or a human one
  /// ("human:tendons"), as hand_by_name() has them.
  /// @throws InputError if the name is taken
  SceneHandSpec& add_hand(const std::string& name, const Pose<double>& X_WH = {});

  /// Sets the friction and the restitution of all pairs without their own values.
  void set_contact(double friction, double restitution = 0);

  /// Returns the scene; forces, drives, muscles and options may be added to it.
  [[nodiscard]] SceneSpec& spec() { return spec_; }
  [[nodiscard]] const SceneSpec& spec() const { return spec_; }

 private:
  void require_new(const std::string& name) const;

  SceneSpec spec_;
};

}  // namespace thenar
