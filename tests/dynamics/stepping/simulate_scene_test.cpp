// Tests for dynamics/stepping: motions with exact answers.

#include "dynamics/stepping/simulate_scene.h"

#include <gtest/gtest.h>

#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::centre;
using sample::kG;
using sample::primitive;

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

TEST(SimulateScene, PinchHoldsWithoutSlip) {
  const sample::Pinch world = sample::pinch({});
  SceneOptions options;
  options.seconds = 10;
  for (const bool sleep : {true, false}) {
    options.sleep = sleep;
    const SceneRun run = simulate_scene(world.scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone);
    EXPECT_LT(centre(world.scene, world.cube, run.samples.back()).norm(), 1e-12);
    EXPECT_EQ(run.cost.asleep > 9, sleep);
  }
}

TEST(SimulateScene, PinchHoldsAtEveryStep) {
  const sample::Pinch world = sample::pinch({});
  SceneOptions options;
  options.seconds = 10;
  options.method = SteppingMethod::kTimeStepping;
  for (const double step : {1e-4, 1e-3, 5e-3, 1e-2, 2e-2}) {
    options.step = step;
    const SceneRun run = simulate_scene(world.scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone);
    EXPECT_LT(centre(world.scene, world.cube, run.samples.back()).norm(), 1e-12) << step;
  }
}

/// A cube on the axis of the grip 5.4 mm beside its centre, swung at 6 rad/s.
sample::Pinch swinging_pinch() {
  sample::PinchOptions options;
  options.force = 8;
  options.above = 0.0054;
  sample::Pinch world = sample::pinch(options);
  set_free_velocity(world.scene.mechanism, world.cube, world.scene.q,
                    Eigen::Vector3d(0, 6 * 0.0054, 0), Eigen::Vector3d(6, 0, 0), world.scene.v);
  return world;
}

/// Angle of the swinging cube about the grip's axis.
double swing(const sample::Pinch& world, const SceneSample& at) {
  const Eigen::Vector3d arm = centre(world.scene, world.cube, at) - Eigen::Vector3d(0, 0, 0.0054);
  return std::atan2(arm.y(), -arm.z());
}

// A compound pendulum: its arm and its energy stay.
TEST(SimulateScene, SwingingPinchKeepsItsArmAndEnergy) {
  const sample::Pinch world = swinging_pinch();
  SceneOptions options;
  options.seconds = 10;
  const SceneRun run = simulate_scene(world.scene, options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const Eigen::Vector3d arm =
      centre(world.scene, world.cube, run.samples.back()) - Eigen::Vector3d(0, 0, 0.0054);
  EXPECT_NEAR(std::hypot(arm.y(), arm.z()), 0.0054, 1e-10);
  EXPECT_NEAR(arm.x(), 0, 1e-12);
  EXPECT_NEAR(run.samples.back().energy.total(), run.samples.front().energy.total(), 1e-10);
  EXPECT_LT(run.cost.worst_residual, 1e-11);
}

// Between impacts the midpoint rule is of second order: halving the step quarters the error.
TEST(SimulateScene, TimeSteppingIsOfSecondOrder) {
  const sample::Pinch world = swinging_pinch();
  SceneOptions options;
  options.seconds = 0.5;
  options.tolerance = 1e-12;
  const double exact = swing(world, simulate_scene(world.scene, options).samples.back());
  options.method = SteppingMethod::kTimeStepping;
  std::vector<double> errors;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    options.step = step;
    errors.push_back(
        std::abs(swing(world, simulate_scene(world.scene, options).samples.back()) - exact));
  }
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.3);
  EXPECT_NEAR(errors[1] / errors[2], 4, 0.3);
}

// The error of steps between events follows the tolerance.
TEST(SimulateScene, ErrorFollowsTheTolerance) {
  const sample::Pinch world = swinging_pinch();
  SceneOptions options;
  options.seconds = 1;
  options.tolerance = 1e-13;
  const double exact = swing(world, simulate_scene(world.scene, options).samples.back());
  for (const double tolerance : {1e-7, 1e-9, 1e-11}) {
    options.tolerance = tolerance;
    const double error =
        std::abs(swing(world, simulate_scene(world.scene, options).samples.back()) - exact);
    EXPECT_LT(error, 1000 * tolerance);
  }
}

}  // namespace
}  // namespace thenar
