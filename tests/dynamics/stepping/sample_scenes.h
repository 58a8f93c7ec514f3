#pragma once

/// Small scenes with known answers.

#include <cmath>
#include <memory>
#include <string>

#include "base/units.h"
#include "dynamics/mechanism/build_mechanism.h"
#include "dynamics/stepping/moving_scene.h"

namespace thenar::sample {

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

/// Adds a body of one shape on a hinge or slide along `axis` through `point`. @return its index
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
  joint.coordinate = 0;
  const Tangents sides = tangents(axis);
  joint.X_PF.R << sides.e1, sides.e2, axis;
  joint.X_PF.p = point;
  joint.X_BM = joint.X_PF;
  part.coordinates = {{name}};
  const Eigen::VectorXd q = scene.q, v = scene.v;
  const int body = append(scene.mechanism, part);
  scene.q = reference_position(scene.mechanism);
  scene.q.head(q.size()) = q;
  scene.v = Eigen::VectorXd::Zero(layout_of(scene.mechanism).v);
  scene.v.head(v.size()) = v;
  return body;
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
