// Tests for dynamics/stepping: rolling, sliding, spinning and swinging, with answers in closed
// form.

#include <gtest/gtest.h>

#include "dynamics/stepping/simulate_scene.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::centre;
using sample::kG;
using sample::primitive;

SceneRun run_for(const MovingScene& scene, double seconds) {
  SceneOptions options;
  options.duration = seconds;
  SceneRun run = simulate_scene(scene, options);
  EXPECT_EQ(run.status, SceneStatus::kDone);
  EXPECT_LT(run.cost.worst_residual, 1e-11);
  EXPECT_LT(run.cost.max_penetration, 2e-9);
  return run;
}

/// A ball on a floor tilted about y. @return its index
int ball_on_floor(MovingScene& scene, double slope, double radius, double mass) {
  Pose<double> X;
  X.R = rotation_about<double>({0, 1, 0}, slope);
  X.p = X.R * Eigen::Vector3d(0, 0, -0.05);
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {6, 6, 0.1}), 0, X);
  X.p = X.R * Eigen::Vector3d(0, 0, radius);
  return sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {radius, 0, 0}), mass, X);
}

// v^2 / (2 mu g), whatever the direction: a friction pyramid is wrong between its edges.
TEST(ExactMotion, SlidesAsFarInEveryDirection) {
  const double speed = 0.5, friction = 0.3, way = speed * speed / (2 * friction * kG);
  for (int degree = 0; degree < 360; degree += 6) {
    SCOPED_TRACE(degree);
    sample::Incline world = sample::incline(0, friction);
    const Eigen::Vector3d along(std::cos(degree * kDegree), std::sin(degree * kDegree), 0);
    world.scene.v.tail<3>() = speed * along;
    const SceneRun run = run_for(world.scene, 0.3);
    const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                  centre(world.scene, world.cube, run.samples.front());
    EXPECT_LT((moved - way * along).norm(), 1e-6 * way);
  }
}

// With friction pyramids of m edges the force between two edges is too large or too small: the way
// is wrong by up to  1 / cos(pi / m)  there, and right along an edge.
TEST(ExactMotion, PyramidsSlideWrongBetweenTheirEdges) {
  const double speed = 0.5, friction = 0.3, way = speed * speed / (2 * friction * kG);
  for (const int edges : {4, 8, 16}) {
    SCOPED_TRACE(edges);
    double worst = 0;
    for (int degree = 0; degree < 360; degree += 15) {
      sample::Incline world = sample::incline(0, friction);
      const Eigen::Vector3d along(std::cos(degree * kDegree), std::sin(degree * kDegree), 0);
      world.scene.v.tail<3>() = speed * along;
      SceneOptions options;
      options.duration = 0.3;
      options.method = SteppingMethod::kTimeStepping;
      options.contacts.method = ContactMethod::kPyramid;
      options.contacts.pyramid_edges = edges;

      const SceneRun run = simulate_scene(world.scene, options);
      EXPECT_EQ(run.status, SceneStatus::kDone);
      const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                    centre(world.scene, world.cube, run.samples.front());
      worst = std::max(worst, std::abs(moved.norm() / way - 1));
    }
    // In steps of 15 degrees the middle between two edges is met for 4 edges alone.
    const double most = 1 / std::cos(kPi / edges) - 1;
    EXPECT_LT(worst, most + 1e-3);
    EXPECT_GT(worst, (edges == 4 ? 0.99 : 0.5) * most);
  }
}

TEST(ExactMotion, SticksAndSlidesWithinAMillionthOfCapacity) {
  const double slope = 30 * kDegree;
  for (const double beyond : {-1e-6, 1e-6}) {
    const sample::Incline world = sample::incline(slope, std::tan(slope) * (1 + beyond));
    const SceneRun run = run_for(world.scene, 2);
    const double moved = (centre(world.scene, world.cube, run.samples.back()) -
                          centre(world.scene, world.cube, run.samples.front()))
                             .norm();
    // It slides by g t^2 / 2 (sin - mu cos).
    const double wanted = beyond < 0 ? 0.5 * kG * 4 * std::sin(slope) * 1e-6 : 0;
    EXPECT_NEAR(moved, wanted, 1e-10);
  }
}

// Rolls at 5/7 of the slope's acceleration while friction holds, and slides above 2/7 of its
// tangent.
TEST(ExactMotion, BallRollsDownASlope) {
  const double slope = 30 * kDegree, seconds = 0.7;
  for (const double friction : {0.5, 0.1}) {
    MovingScene scene;
    const int ball = ball_on_floor(scene, slope, 0.02, 0.1);
    scene.friction.coefficient = friction;
    const SceneRun run = run_for(scene, seconds);
    const double rolls = 5.0 / 7 * kG * std::sin(slope);
    const double slides = kG * (std::sin(slope) - friction * std::cos(slope));
    const double wanted = 0.5 * std::max(rolls, slides) * seconds * seconds;
    EXPECT_NEAR(
        (centre(scene, ball, run.samples.back()) - centre(scene, ball, run.samples.front())).norm(),
        wanted, 1e-9);
  }
}

// A ball pushed without spin slides for 2 v / (7 mu g), then rolls at 5/7 of its speed.
TEST(ExactMotion, BilliardBallBeginsToRoll) {
  MovingScene scene;
  const int ball = ball_on_floor(scene, 0, 0.02, 0.1);
  scene.friction.coefficient = 0.2;
  scene.v.tail<3>() = Eigen::Vector3d(1, 0, 0);
  const SceneRun run = run_for(scene, 0.5);
  const double slides = 2 / (7 * 0.2 * kG);
  const double wanted = slides - 0.5 * 0.2 * kG * slides * slides + (0.5 - slides) * 5 / 7;
  EXPECT_NEAR(centre(scene, ball, run.samples.back()).x(), wanted, 1e-9);
}

// A soft contact takes  mu e m g  of moment from a spin.
TEST(ExactMotion, SpinEndsByTorsion) {
  MovingScene scene;
  ball_on_floor(scene, 0, 0.02, 0.1);
  scene.friction = {0.3, 0.002, 0};
  scene.v[2] = 10;
  const double inertia = 0.4 * 0.1 * 0.02 * 0.02, slowing = 0.3 * 0.002 * 0.1 * kG / inertia;
  const SceneRun run = run_for(scene, 0.4);
  for (const SceneSample& at : run.samples)
    EXPECT_NEAR(at.v[2], std::max(0.0, 10 - slowing * at.t), 1e-6) << at.t;
  EXPECT_LT(10 - slowing * 0.4, 0);  // it stopped on the way
}

// A rod let go at 90 degrees from below: period  4 sqrt(I / (m g d)) K(sin 45).
TEST(ExactMotion, PendulumKeepsItsPeriod) {
  MovingScene scene;
  ShapeSpec bob = primitive(ShapeKind::kSphere, {0.01, 0, 0});
  bob.X_BS.p = {0.2, 0, 0};
  sample::add_on_joint(scene, "bob", bob, 0.1, JointKind::kHinge, {0, 1, 0}, {0, 0, 0});
  const double d = 0.2, inertia = 0.1 * d * d + 0.4 * 0.1 * 1e-4;
  const double quarter = std::comp_ellint_1(std::sqrt(0.5)) * std::sqrt(inertia / (0.1 * kG * d));
  const SceneRun run = run_for(scene, 40 * quarter);
  EXPECT_NEAR(run.samples.back().q[0], 0, 1e-8);
  EXPECT_NEAR(run.samples.back().v[0], 0, 1e-6);
  EXPECT_NEAR(run.samples.back().energy.total(), run.samples.front().energy.total(), 1e-11);
}

// A top on a ball joint, spun so that it precesses at one tilt for ever:
//   I1 p^2 cos(a) - I3 s p + m g d = 0  (s: spin about its axis, p: precession about the vertical).
TEST(ExactMotion, TopPrecessesSteadily) {
  MovingScene scene;
  ShapeSpec disc = primitive(ShapeKind::kCylinder, {0.03, 0.01, 0});
  disc.X_BS.p = {0, 0, 0.05};
  const double tilt = 0.6, mass = 0.1, d = 0.05, radius = 0.03, height = 0.01;
  const int top =
      sample::add_on_joint(scene, "top", disc, mass, JointKind::kBall, {0, 0, 1}, {0, 0, 0});
  const double I3 = 0.5 * mass * radius * radius;
  const double I1 = mass * (3 * radius * radius + height * height) / 12 + mass * d * d;
  const double p = 5, s = (I1 * p * p * std::cos(tilt) + mass * kG * d) / (I3 * p);
  // Tilted about y; speeds in the axes of the world, as its joint stands there.
  scene.q << std::cos(tilt / 2), 0, std::sin(tilt / 2), 0;
  const Eigen::Vector3d axis(std::sin(tilt), 0, std::cos(tilt));
  scene.v = p * Eigen::Vector3d(0, 0, 1) + (s - p * std::cos(tilt)) * axis;
  const SceneRun run = run_for(scene, 2);
  (void)top;
  const auto axis_of = [](const Eigen::VectorXd& q) -> Eigen::Vector3d {
    return Eigen::Quaterniond(q[0], q[1], q[2], q[3]) * Eigen::Vector3d(0, 0, 1);
  };
  for (const SceneSample& at : run.samples) {
    const Eigen::Vector3d wanted(std::sin(tilt) * std::cos(p * at.t),
                                 std::sin(tilt) * std::sin(p * at.t), std::cos(tilt));
    EXPECT_LT((axis_of(at.q) - wanted).norm(), 1e-7) << at.t;
  }
}

// Five balls in a row, the first one flying: all contacts are struck at once, by Moreau's law.
TEST(ExactMotion, CradleIsStruckAtOnce) {
  MovingScene scene;
  for (int i = 0; i < 5; ++i) {
    Pose<double> X;
    X.p.x() = 0.04 * i - (i == 0 ? 0.02 : 0);
    sample::add_body(scene, "ball " + std::to_string(i),
                     primitive(ShapeKind::kSphere, {0.02, 0, 0}), 0.1, X);
  }
  scene.gravity.setZero();
  scene.friction.restitution = 1;
  scene.v[3] = 1;
  const SceneRun run = run_for(scene, 0.1);
  // One contact approaches; the others must not: momentum and energy leave one answer.
  const Eigen::VectorXd& v = run.samples.back().v;
  EXPECT_NEAR(v[3], -0.6, 1e-12);
  for (int i = 1; i < 5; ++i) EXPECT_NEAR(v[6 * i + 3], 0.4, 1e-12);
}

}  // namespace
}  // namespace thenar
