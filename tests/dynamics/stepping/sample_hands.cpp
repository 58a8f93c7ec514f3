#include "tests/dynamics/stepping/sample_hands.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar::sample {
namespace {

using Eigen::Vector3d;

/// Mass and inertia of a cylinder along z that begins at the origin.
BodyMass rod(double mass, double length, double radius) {
  const double across = mass * (3 * radius * radius + length * length) / 12;
  return {mass,
          {0, 0, 0.5 * length},
          Eigen::DiagonalMatrix<double, 3>(across, across, 0.5 * mass * radius * radius)};
}

/// Adds a link on a hinge. @param axis  and  @param place  in the parent's frame (3)
int add_link(MovingScene& scene, int parent, const Vector3d& axis, const Vector3d& place,
             const BodyMass& mass) {
  Mechanism& mechanism = scene.mechanism;
  const int body = static_cast<int>(mechanism.bodies.size());
  const std::string name = fmt::format("link {}", body);
  // The link's own axes are those of its parent at angle 0.
  MechanismJoint joint;
  joint.name = name;
  joint.parent = parent;
  const Tangents sides = tangents(axis);
  joint.X_BM.R << sides.e1, sides.e2, axis;
  joint.X_PF = joint.X_BM;
  joint.X_PF.p = place;
  joint.coordinate = static_cast<int>(mechanism.coordinates.size());
  mechanism.coordinates.push_back({name});
  mechanism.joints.push_back(joint);
  mechanism.bodies.push_back({name, mass, nullptr, ""});
  return body;
}

void add_finger(MovingScene& scene, const Vector3d& knuckle, double size) {
  const Vector3d bend(0, 1, 0), spread(1, 0, 0);
  int link = add_link(scene, -1, spread, knuckle, rod(0.004, 0.01, 0.008));
  double before = 0;
  const std::array<double, 3> lengths{0.045, 0.027, 0.02}, masses{0.02, 0.01, 0.006};
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = size * lengths[k];
    link = add_link(scene, link, bend, {0, 0, before}, rod(size * masses[k], length, 0.008));
    before = length;
  }
}

/// Angle by which a link leans further in until its pad touches a ball, in the plane of a finger.
/// @param base     of the link, out and up [m] (2)
/// @param leaning  of the link at angle 0 [rad]
/// @param along    from the base to the pad's centre [m]
/// @param reach    between the centres of pad and ball when they touch [m]
double touching_angle(const Eigen::Vector2d& base, double leaning, double along,
                      const Eigen::Vector2d& centre, double reach) {
  const auto gap = [&](double angle) {
    const double lean = leaning + angle;
    const Eigen::Vector2d pad = base + along * Eigen::Vector2d(-std::sin(lean), std::cos(lean));
    return (pad - centre).norm() - reach;
  };
  // From wide open inwards to the first place that touches, then by halves.
  double open = -1, step = 1e-3;
  while (gap(open + step) > 0) open += step;
  for (int i = 0; i < 60; ++i) {
    step *= 0.5;
    if (gap(open + step) > 0) open += step;
  }
  return open;
}

}  // namespace

MovingScene swinging_hand() {
  MovingScene scene;
  const std::array<double, 4> sizes{0.95, 1.05, 1.0, 0.8};
  for (std::size_t k = 0; k < 4; ++k)
    add_finger(scene, {0, 0.022 * static_cast<double>(k), 0.09}, sizes[k]);
  // The thumb's axes meet nowhere and are square to nothing.
  const std::array<Vector3d, 5> axes{Vector3d(0.2, 0.9, 0.3), Vector3d(0.8, -0.3, 0.4),
                                     Vector3d(0.1, 0.9, -0.4), Vector3d(0.7, 0.3, 0.5),
                                     Vector3d(0.15, 0.95, 0.2)};
  const std::array<Vector3d, 5> places{Vector3d(0, -0.02, 0.02), Vector3d(0.004, 0.002, 0.006),
                                       Vector3d(0.002, 0, 0.045), Vector3d(0.003, 0.001, 0.005),
                                       Vector3d(0.001, 0, 0.032)};
  const std::array<double, 5> lengths{0.01, 0.045, 0.01, 0.032, 0.025};
  const std::array<double, 5> masses{0.005, 0.02, 0.004, 0.012, 0.008};
  int link = -1;
  for (std::size_t k = 0; k < 5; ++k)
    link =
        add_link(scene, link, axes[k].normalized(), places[k], rod(masses[k], lengths[k], 0.009));
  const int n = layout_of(scene.mechanism).v;
  scene.gravity = {9.81, 0, 0};
  scene.q = Eigen::VectorXd::LinSpaced(n, 0.1, 0.5);
  scene.v = Eigen::VectorXd::LinSpaced(n, -3, 3);
  return scene;
}

BallInHand ball_in_hand() {
  BallInHand out;
  MovingScene& scene = out.scene;
  constexpr double kRadius = 0.03, kPad = 0.008, kLink = 0.026;  // [m]
  // The palm, whose top is at z = 0. It swings about a place that moves on.
  ShapeSpec plate = primitive(ShapeKind::kBox, {0.12, 0.12, 0.02});
  plate.X_BS.p.z() = -0.01;
  const int palm = add_on_joint(scene, "palm", plate, 0.3, JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  SceneDrive carry{scene.mechanism.joints[static_cast<std::size_t>(palm)].coordinate};
  carry.stiffness = 500;
  carry.damping = 4;
  carry.speed = 0.1;
  scene.drives.push_back(carry);
  // Fingers stand round it, each with torques of its own.
  std::vector<double> angles;
  for (int k = 0; k < 5; ++k) {
    const double turn = (72.0 * k + 5.0 * (k % 2)) * kDegree;
    const Vector3d outward(std::cos(turn), std::sin(turn), 0);
    const Vector3d axis(std::sin(turn), -std::cos(turn), 0);  // closes
    // In the plane of the finger: out, up.
    Eigen::Vector2d base(0.04, 0.004);
    double leaning = 0;
    int parent = palm;
    Vector3d place = base.x() * outward + base.y() * Vector3d::UnitZ();
    for (const double along : {0.016, 0.02}) {
      const int link = add_link(scene, parent, axis, place, rod(0.012, kLink, kPad));
      ShapeSpec pad = primitive(ShapeKind::kSphere, {kPad, 0, 0});
      pad.X_BS.p = {0, 0, along};
      scene.mechanism.bodies[static_cast<std::size_t>(link)].solid =
          std::make_shared<Solid>(build_solid({pad}));
      scene.mechanism.joints[static_cast<std::size_t>(link)].damping = 2e-3;
      const double torque = (parent == palm ? 0.06 : 0.012) * (1 + 0.05 * k);
      scene.drives.push_back(
          {scene.mechanism.joints[static_cast<std::size_t>(link)].coordinate, torque});
      const double angle = touching_angle(base, leaning, along, {0, kRadius}, kRadius + kPad);
      angles.push_back(angle);
      leaning += angle;
      base += kLink * Eigen::Vector2d(-std::sin(leaning), std::cos(leaning));
      place = {0, 0, kLink};
      parent = link;
    }
  }
  // Fingers do not meet each other, nor the palm.
  const int links = static_cast<int>(scene.mechanism.bodies.size());
  for (int i = 0; i < links; ++i)
    for (int j = i + 1; j < links; ++j) scene.excluded_pairs.emplace_back(i, j);
  scene.q = reference_position(scene.mechanism);
  scene.v = Eigen::VectorXd::Zero(layout_of(scene.mechanism).v);
  scene.q.tail(static_cast<Eigen::Index>(angles.size())) =
      Eigen::Map<const Eigen::VectorXd>(angles.data(), static_cast<Eigen::Index>(angles.size()));
  Pose<double> X;
  X.p.z() = kRadius;
  out.ball = add_body(scene, "ball", primitive(ShapeKind::kSphere, {kRadius, 0, 0}), 0.06, X);
  scene.friction.coefficient = 0.8;
  return out;
}

}  // namespace thenar::sample
