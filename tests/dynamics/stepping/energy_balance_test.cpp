// Tests for dynamics/stepping/energy_balance.cpp: what the energy error of a run means, against
// motions whose error is known in closed form.

#include "dynamics/stepping/energy_balance.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/stepping/energy_flow.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::kG;
using sample::primitive;

constexpr double kBodyMass = 0.2;  // of what moves [kg]

SceneRun fixed_run(const MovingScene& scene, double seconds, double step) {
  SceneOptions options;
  options.method = SteppingMethod::kTimeStepping;
  options.duration = seconds;
  options.step_length = step;
  options.sample_interval = 10 * step;
  return simulate_scene(scene, options);
}

FlowBalance whole(const SceneRun& run) {
  return flow_balance(run.samples.front(), run.samples.back());
}

/// A cube on a slide along x, free of weight.
MovingScene weightless_cube() {
  MovingScene scene;
  scene.gravity.setZero();
  sample::add_on_joint(scene, "cube", primitive(ShapeKind::kBox, {0.1, 0.1, 0.1}), kBodyMass,
                       JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  return scene;
}

/// A floor, its top at z = 0.
MovingScene floor_alone() {
  MovingScene scene;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {1, 1, 0.1}), 0,
                   {Eigen::Matrix3d::Identity(), {0, 0, -0.05}});
  return scene;
}

// The error of a pendulum is the difference of its energies, as nothing works on it or rubs; turned
// over is m g (l - l cos) at the bottom.
TEST(EnergyBalance, OfAPendulumIsWhatItsEnergiesDiffer) {
  MovingScene scene;
  const double length = 0.3, angle = 60 * kDegree;
  ShapeSpec bob = primitive(ShapeKind::kSphere, {0.01, 0, 0});
  bob.X_BS.p = {0, 0, -length};
  sample::add_on_joint(scene, "bob", bob, kBodyMass, JointKind::kHinge, {0, 1, 0}, {0, 0, 0});
  scene.q[0] = angle;
  const double height = kBodyMass * kG * length * (1 - std::cos(angle));
  for (const double step : {1e-3, 1e-2}) {
    const SceneRun run = fixed_run(scene, 2, step);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    const FlowBalance found = whole(run);
    EXPECT_EQ(found.work, 0);
    EXPECT_EQ(found.dissipated(), 0);
    EXPECT_NEAR(found.turned_over, height, 0.01 * height);
    EXPECT_EQ(found.error, run.samples.front().energy.total() - run.samples.back().energy.total());
  }
}

// A motor that holds a spring off its rest: work F x in all, of which the spring keeps half and a
// damper takes the rest, F x / 2, x = F / k.
TEST(EnergyBalance, OfAMotorAgainstASpring) {
  MovingScene scene = weightless_cube();
  const double force = 3, stiffness = 50, way = force / stiffness;
  scene.mechanism.joints[0].stiffness = stiffness;
  scene.mechanism.joints[0].damping = 4;
  SceneDrive motor;
  motor.coordinate = 0;
  motor.bias = force;
  scene.drives.push_back(motor);
  for (const double step : {1e-3, 1e-2}) {
    const SceneRun run = fixed_run(scene, 5, step);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    const FlowBalance found = whole(run);
    EXPECT_NEAR(found.work, force * way, 1e-9);
    EXPECT_NEAR(found.yielding, 0.5 * force * way, 1e-9);
    EXPECT_EQ(found.friction + found.impacts, 0);
    EXPECT_NEAR(found.error, 0, 1e-12);
    // It overshoots, so that work comes back, and has kinetic energy on its way.
    EXPECT_GT(found.turned_over, 1.5 * force * way);
    EXPECT_LT(found.turned_over, 2.2 * force * way);
  }
}

// A ball that lands loses m g h by the impact and none by friction.
TEST(EnergyBalance, OfALandingIsAnImpact) {
  MovingScene scene = floor_alone();
  const double height = 0.1, weight = kBodyMass * kG;
  sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.02, 0, 0}), kBodyMass,
                   {Eigen::Matrix3d::Identity(), {0, 0, 0.02 + height}});
  const SceneRun run = fixed_run(scene, 0.5, 1e-3);
  EXPECT_EQ(run.status, SceneStatus::kDone);
  EXPECT_NEAR(whole(run).impacts, weight * height, 1e-9);
  EXPECT_EQ(whole(run).friction, 0);
}

// A block that slides loses mu m g times its way by friction, and none by impacts.
TEST(EnergyBalance, OfASlidingBlockIsFriction) {
  MovingScene scene = floor_alone();
  const int block = sample::add_body(scene, "block", primitive(ShapeKind::kBox, {0.1, 0.1, 0.02}),
                                     kBodyMass, {Eigen::Matrix3d::Identity(), {0, 0, 0.01}});
  scene.friction.coefficient = 0.3;
  const double speed = 0.9;
  set_free_velocity(scene.mechanism, block, scene.q, {speed, 0, 0}, {0, 0, 0}, scene.v);
  const SceneRun run = fixed_run(scene, 0.5, 1e-3);  // at rest after 0.306 s
  EXPECT_EQ(run.status, SceneStatus::kDone);
  EXPECT_NEAR(whole(run).friction, 0.5 * kBodyMass * speed * speed, 1e-9);
  EXPECT_NEAR(whole(run).impacts, 0, 1e-9);
}

// A block that begins d deep in the floor is pushed out at 0.1 m/s: at least the energy m g d and
// at most that and m v^2 / 2 is made, which is no loss below zero but an error.
TEST(EnergyBalance, TellsWhatIsMadeByPushingSurfacesApart) {
  MovingScene scene = floor_alone();
  const double depth = 2e-3;
  sample::add_body(scene, "block", primitive(ShapeKind::kBox, {0.1, 0.1, 0.02}), kBodyMass,
                   {Eigen::Matrix3d::Identity(), {0, 0, 0.01 - depth}});
  const SceneRun run = fixed_run(scene, 0.3, 1e-3);
  const double least = kBodyMass * kG * depth;
  const FlowBalance found = whole(run);
  EXPECT_EQ(run.status, SceneStatus::kUnbalanced);
  EXPECT_LT(found.error, -0.99 * least);
  EXPECT_GT(found.error, -1.01 * (least + 0.5 * kBodyMass * 0.1 * 0.1));
  EXPECT_GE(found.impacts, 0);
}

// By events it is moved out, and lifted by just d.
TEST(EnergyBalance, TellsWhatIsMadeByMovingSurfacesApart) {
  MovingScene scene = floor_alone();
  const double depth = 5e-5;
  sample::add_body(scene, "block", primitive(ShapeKind::kBox, {0.1, 0.1, 0.02}), kBodyMass,
                   {Eigen::Matrix3d::Identity(), {0, 0, 0.01 - depth}});
  SceneOptions options;
  options.duration = 0.1;
  const SceneRun run = simulate_scene(scene, options);
  EXPECT_NEAR(whole(run).error, -kBodyMass * kG * depth, 1e-3 * kBodyMass * kG * depth);
  EXPECT_EQ(run.status, SceneStatus::kUnbalanced);
}

// A link that swings over its top, 40 ms: steps that long make energy of nothing, and the run says
// so.
TEST(EnergyBalance, OfStepsTooLongDoesNotHold) {
  MovingScene scene;
  ShapeSpec link = primitive(ShapeKind::kBox, {0.005, 0.005, 0.04});
  link.X_BS.p = {0, 0, -0.02};
  sample::add_on_joint(scene, "upper", link, 0.02, JointKind::kHinge, {0, 1, 0}, {0, 0, 0});
  scene.q[0] = 120 * kDegree;
  const SceneRun good = fixed_run(scene, 1, 1e-3), bad = fixed_run(scene, 1, 4e-2);
  EXPECT_EQ(good.status, SceneStatus::kDone);
  EXPECT_EQ(bad.status, SceneStatus::kUnbalanced);
  EXPECT_GT(worst_balance(bad.samples).relative_error(), kMaxEnergyErrorRatio);
}

// Losses of what rests may be below zero by rounding; what is turned over is not.
TEST(EnergyBalance, TurnsNothingOverAtRest) {
  SceneSample start, end;
  start.w = end.w = EnergyFlows::Zero();
  end.w[kFrictionLoss] = end.w[kImpactLoss] = -1e-19;
  EXPECT_EQ(flow_balance(start, end).turned_over, 0);
}

// What is next to nothing is rounding: below 1 uJ no run is refused.
TEST(EnergyBalance, OfWhatRestsHolds) {
  FlowBalance still;
  still.error = 0.9e-6;
  EXPECT_TRUE(still.holds());
  still.error = 1.1e-6;
  EXPECT_FALSE(still.holds());
  still.turned_over = 1;
  still.error = -0.99e-2;
  EXPECT_TRUE(still.holds());
  still.error = -1.01e-2;
  EXPECT_FALSE(still.holds());
}

// An impact before the first step is a loss from the energy before it.
TEST(EnergyBalance, CountsAnImpactAtTheStart) {
  MovingScene scene = floor_alone();
  const int ball = sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.02, 0, 0}),
                                    kBodyMass, {Eigen::Matrix3d::Identity(), {0, 0, 0.02}});
  const double speed = 2;
  set_free_velocity(scene.mechanism, ball, scene.q, {0, 0, -speed}, {0, 0, 0}, scene.v);
  SceneOptions options;
  options.duration = 0.1;
  const SceneRun run = simulate_scene(scene, options);
  const double lost = 0.5 * kBodyMass * speed * speed;
  EXPECT_NEAR(run.samples.front().energy.kinetic, lost, 1e-12);
  EXPECT_NEAR(whole(run).impacts, lost, 1e-9);
  EXPECT_NEAR(whole(run).error, 0, 1e-9);
}

}  // namespace
}  // namespace thenar
