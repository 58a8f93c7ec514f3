// Tests for dynamics/stepping: motions with exact answers.

#include "dynamics/stepping/simulate_scene.h"

#include <gtest/gtest.h>

#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::primitive;

constexpr double kG = 9.81;

/// Position of a free body's centre of mass in a sample.
Eigen::Vector3d centre(const MovingScene& scene, int body, const SceneSample& at) {
  const int first = layout_of(scene.mechanism).first_q[static_cast<std::size_t>(body)];
  return at.q.segment<3>(first + 4);
}

TEST(SimulateScene, BodyInFreeFlight) {
  MovingScene scene;
  const int body =
      sample::add_body(scene, "box", primitive(ShapeKind::kBox, {0.05, 0.1, 0.02}), 0.2);
  scene.v << 1, 20, 2, 0.5, 0.1, 3;
  const SceneRun run = simulate_scene(scene, {});
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const Eigen::Vector3d wanted = Eigen::Vector3d(0.5, 0.1, 3 - 0.5 * kG);
  EXPECT_LT((centre(scene, body, run.samples.back()) - wanted).norm(), 1e-8);
  // Energy and angular momentum stay.
  EXPECT_NEAR(run.samples.back().energy.total(), run.samples.front().energy.total(), 1e-9);
}

TEST(SimulateScene, CubeOnAnInclineSticksBelowTheThreshold) {
  const sample::Incline world = sample::incline(30 * kDegree, std::tan(30.1 * kDegree));
  SceneOptions options;
  options.seconds = 10;
  const SceneRun run = simulate_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                centre(world.scene, world.cube, run.samples.front());
  EXPECT_LT(moved.norm(), 1e-12);
}

TEST(SimulateScene, CubeOnAnInclineSlidesAboveTheThreshold) {
  const double slope = 30 * kDegree, friction = std::tan(29.9 * kDegree);
  const sample::Incline world = sample::incline(slope, friction);
  SceneOptions options;
  options.seconds = 2;
  const SceneRun run = simulate_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const double way = 0.5 * kG * (std::sin(slope) - friction * std::cos(slope)) * 4;
  const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                centre(world.scene, world.cube, run.samples.front());
  EXPECT_NEAR(moved.norm(), way, 1e-6 * way);
}

TEST(SimulateScene, BallBounces) {
  MovingScene scene;
  Pose<double> X;
  X.p.z() = -0.05;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {1, 1, 0.1}), 0, X);
  X.p.z() = 0.02 + 0.1;
  const int ball =
      sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.02, 0, 0}), 0.1, X);
  scene.friction.restitution = 0.8;
  SceneOptions options;
  options.seconds = 0.6;
  const SceneRun run = simulate_scene(scene, options);
  // Falls, then rises with 0.8 of the speed again and again.
  double left = 0.6 - std::sqrt(2 * 0.1 / kG), up = 0.8 * std::sqrt(2 * 0.1 * kG);
  while (left > 2 * up / kG) {
    left -= 2 * up / kG;
    up *= 0.8;
  }
  const double height = up * left - 0.5 * kG * left * left;
  EXPECT_NEAR(centre(scene, ball, run.samples.back()).z(), 0.02 + height, 1e-6);
}

/// A cube between two balls on slides.
struct Pinch {
  MovingScene scene;
  int cube = 0;
};
Pinch pinch(double force, double off_centre, double finger_mass = 0.02, double cube_mass = 0.1) {
  Pinch out;
  MovingScene& scene = out.scene;
  for (const double side : {-1.0, 1.0}) {
    ShapeSpec ball = primitive(ShapeKind::kSphere, {0.01, 0, 0});
    ball.X_BS.p = {side * 0.035, 0, off_centre};
    const int finger = sample::add_on_joint(scene, side < 0 ? "left" : "right", ball, finger_mass,
                                            JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
    scene.drives.push_back(
        {scene.mechanism.joints[static_cast<std::size_t>(finger)].coordinate, -side * force});
  }
  out.cube =
      sample::add_body(scene, "cube", primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}), cube_mass);
  scene.friction.coefficient = 0.8;
  return out;
}

TEST(SimulateScene, PinchHoldsWithoutSlip) {
  const Pinch world = pinch(2, 0);
  SceneOptions options;
  options.seconds = 10;
  const SceneRun run = simulate_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  EXPECT_LT(centre(world.scene, world.cube, run.samples.back()).norm(), 1e-12);
}

// The cube's centre hangs 5.4 mm beside the axis of the grip: a compound pendulum.
TEST(SimulateScene, SwingingPinchKeepsItsArmAndEnergy) {
  Pinch world = pinch(8, 0.0054);
  set_free_velocity(world.scene.mechanism, world.cube, world.scene.q,
                    Eigen::Vector3d(0, 6 * 0.0054, 0), Eigen::Vector3d(6, 0, 0), world.scene.v);
  SceneOptions options;
  options.seconds = 10;
  const SceneRun run = simulate_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const Eigen::Vector3d arm =
      centre(world.scene, world.cube, run.samples.back()) - Eigen::Vector3d(0, 0, 0.0054);
  EXPECT_NEAR(std::hypot(arm.y(), arm.z()), 0.0054, 1e-10);
  EXPECT_NEAR(arm.x(), 0, 1e-12);
  EXPECT_NEAR(run.samples.back().energy.total(), run.samples.front().energy.total(), 1e-10);
  EXPECT_LT(run.cost.worst_residual, 1e-12);
}

}  // namespace
}  // namespace thenar
