#pragma once

/// Small scenes with known answers.

#include <cmath>
#include <memory>
#include <string>

#include "base/units.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/stepping/simulate_scene.h"

namespace thenar::sample {

inline constexpr double kG = 9.81;  // [m/s^2]

/// A primitive of one kind.
inline ShapeSpec primitive(ShapeKind kind, const Eigen::Vector3d& size) {
  ShapeSpec shape;
  shape.kind = kind;
  shape.size = size;
  return shape;
}

/// Adds a free or fixed body of one shape to a scene, which is rebuilt. @return its index
inline int add_body(MovingScene& scene, const std::string& name, const ShapeSpec& shape,
                    double mass, const Pose<double>& X_WB = {}) {
  PlacedBody placed;
  placed.body.name = name;
  placed.body.shapes = {shape};
  placed.body.uniform_mass = mass;
  placed.dynamic = mass > 0;
  placed.X_WB = X_WB;
  const Eigen::VectorXd q = scene.q, v = scene.v;
  const int body = append(scene.mechanism, body_mechanism(placed));
  scene.q = reference_position(scene.mechanism);
  scene.q.head(q.size()) = q;
  scene.v = Eigen::VectorXd::Zero(layout_of(scene.mechanism).v);
  scene.v.head(v.size()) = v;
  if (mass > 0) set_free_pose(scene.mechanism, body, X_WB, scene.q);
  return body;
}

/// Adds a body of one shape on a hinge, slide or ball joint, its axis through `point`.
/// @return its index
inline int add_on_joint(MovingScene& scene, const std::string& name, const ShapeSpec& shape,
                        double mass, JointKind kind, const Eigen::Vector3d& axis,
                        const Eigen::Vector3d& point) {
  PlacedBody placed;
  placed.body.name = name;
  placed.body.shapes = {shape};
  placed.body.uniform_mass = mass;
  Mechanism part = body_mechanism(placed);
  MechanismJoint& joint = part.joints.front();
  joint.kind = kind;
  const bool is_scalar = kind == JointKind::kHinge || kind == JointKind::kSlide;
  joint.coordinate = is_scalar ? 0 : -1;
  const Tangents sides = tangents(axis);
  joint.X_PF.R << sides.e1, sides.e2, axis;
  joint.X_PF.p = point;
  joint.X_BM = joint.X_PF;
  if (is_scalar) part.coordinates = {{name}};
  const Eigen::VectorXd q = scene.q, v = scene.v;
  const int body = append(scene.mechanism, part);
  scene.q = reference_position(scene.mechanism);
  scene.q.head(q.size()) = q;
  scene.v = Eigen::VectorXd::Zero(layout_of(scene.mechanism).v);
  scene.v.head(v.size()) = v;
  return body;
}

/// Position of a free body's centre of mass in a sample [m].
inline Eigen::Vector3d centre(const MovingScene& scene, int body, const SceneSample& at) {
  const int first = layout_of(scene.mechanism).first_q[static_cast<std::size_t>(body)];
  return at.q.segment<3>(first + 4);
}

/// A cube of 50 mm between two balls of 10 mm on slides, pushed together.
struct Pinch {
  MovingScene scene;
  int cube = 0;
};
struct PinchOptions {
  double force = 2;           // of each finger [N]
  double finger_mass = 0.02;  // [kg]
  double cube_mass = 0.1;     // [kg]
  double friction = 0.8;      // [1]
  double above = 0;           // of the grip's axis over the cube's centre [m]
  double gap = 0;             // at the start [m]
};
inline Pinch pinch(const PinchOptions& options) {
  Pinch out;
  for (const double side : {-1.0, 1.0}) {
    ShapeSpec ball = primitive(ShapeKind::kSphere, {0.01, 0, 0});
    ball.X_BS.p = {side * (0.035 + options.gap), 0, options.above};
    const int finger = add_on_joint(out.scene, side < 0 ? "left" : "right", ball,
                                    options.finger_mass, JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
    const int at = out.scene.mechanism.joints[static_cast<std::size_t>(finger)].coordinate;
    out.scene.drives.push_back({at, -side * options.force});
  }
  out.cube = add_body(out.scene, "cube", primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}),
                      options.cube_mass);
  out.scene.friction.coefficient = options.friction;
  return out;
}

/// A cube of 50 mm on a large floor whose normal is tilted by `slope` about y [rad].
struct Incline {
  MovingScene scene;
  int floor = 0, cube = 0;
};
inline Incline incline(double slope, double friction) {
  Incline out;
  Pose<double> X;
  X.R = rotation_about<double>({0, 1, 0}, slope);
  X.p = X.R * Eigen::Vector3d(0, 0, -0.05);
  out.floor = add_body(out.scene, "floor", primitive(ShapeKind::kBox, {4, 4, 0.1}), 0, X);
  X.p = X.R * Eigen::Vector3d(0, 0, 0.025);
  out.cube = add_body(out.scene, "cube", primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}), 0.1, X);
  out.scene.friction.coefficient = friction;
  return out;
}

}  // namespace thenar::sample
