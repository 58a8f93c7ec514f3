// Tests for dynamics/stepping/energy_flow.cpp and the flows of energy that steps carry: work and
// dissipation in closed form, whatever instants are kept.

#include "dynamics/stepping/energy_flow.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/scene/measure_run.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::kG;
using sample::primitive;

constexpr double kSlidingMass = 0.2;  // of what slides [kg]

/// A cube on a slide along x, free of weight.
MovingScene sliding_cube() {
  MovingScene scene;
  scene.gravity.setZero();
  sample::add_on_joint(scene, "cube", primitive(ShapeKind::kBox, {0.1, 0.1, 0.1}), kSlidingMass,
                       JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  return scene;
}

RunMeasures measured(const MovingScene& scene, SteppingMethod method, double seconds,
                     double sample_time, double step = 1e-3) {
  SceneOptions options;
  options.method = method;
  options.duration = seconds;
  options.sample_interval = sample_time;
  options.step_length = step;
  const SceneRun run = simulate_scene(scene, options);
  EXPECT_EQ(run.status, SceneStatus::kDone);
  return measure_run(scene, run);
}

constexpr SteppingMethod kMethods[] = {SteppingMethod::kEvents, SteppingMethod::kTimeStepping};

// Friction mu m g cos(slope) over the way 1/2 g (sin - mu cos) t^2.
TEST(EnergyFlow, OfABlockThatSlidesDown) {
  const double slope = 30 * kDegree, friction = 0.4, seconds = 0.6;
  const sample::Incline world = sample::incline(slope, friction);
  const double way = 0.5 * kG * (std::sin(slope) - friction * std::cos(slope)) * seconds * seconds;
  const double lost = friction * 0.1 * kG * std::cos(slope) * way;
  for (const SteppingMethod method : kMethods)
    for (const double sample_time : {0.01, 0.6}) {
      const RunMeasures found = measured(world.scene, method, seconds, sample_time);
      EXPECT_NEAR(found.dissipated, lost, 1e-9 * lost);
      EXPECT_EQ(found.work, 0);
      EXPECT_NEAR(found.balance->error, 0, 1e-9 * lost);
    }
}

// A damper takes  1/2 m v^2 (1 - exp(-2 c t / m)).
TEST(EnergyFlow, OfADamper) {
  MovingScene scene = sliding_cube();
  const double damping = 0.8, speed = 1.5, seconds = 0.4;
  scene.mechanism.joints[0].damping = damping;
  scene.v[0] = speed;
  const double lost =
      0.5 * kSlidingMass * speed * speed * (1 - std::exp(-2 * damping * seconds / kSlidingMass));
  for (const double sample_time : {0.01, 0.4}) {
    const RunMeasures found = measured(scene, SteppingMethod::kEvents, seconds, sample_time);
    EXPECT_NEAR(found.dissipated, lost, 1e-9 * lost);
    EXPECT_NEAR(found.balance->error, 0, 1e-9 * lost);
  }
}

/// A drive that is as stiff as it is damped,  x = x0 (1 + w t) exp(-w t).
MovingScene drawn_back(double rate, double start) {
  MovingScene scene = sliding_cube();
  scene.q[0] = start;
  scene.drives.push_back({0, 0, kSlidingMass * rate * rate, 2 * kSlidingMass * rate});
  return scene;
}

// All that the cube has is work of its drive: 1/2 m v^2, v = -w^2 x0 t exp(-w t). The last one is
// so stiff that steps must take it at their ends.
TEST(EnergyFlow, OfADriveThatDrawsACubeBack) {
  const double seconds = 0.1, start = 0.3;
  for (const double rate : {5.0, 40.0, 2000.0}) {
    SCOPED_TRACE(rate);
    const MovingScene scene = drawn_back(rate, start);
    const double v = rate * rate * start * seconds * std::exp(-rate * seconds);
    for (const double sample_time : {0.004, 0.1}) {
      const RunMeasures found = measured(scene, SteppingMethod::kEvents, seconds, sample_time);
      // The drive turns over as much energy as its spring has.
      const double turned_over = 0.5 * kSlidingMass * rate * rate * start * start;
      EXPECT_NEAR(found.work, 0.5 * kSlidingMass * v * v, 1e-8 * turned_over);
      EXPECT_NEAR(found.dissipated, 0, 1e-8 * turned_over);
      EXPECT_NEAR(found.balance->error, 0, 1e-8 * turned_over);
    }
  }
}

// Steps of fixed length are the same steps, and so are their flows, to the last bit; what they miss
// of the balance falls with the square of their length.
TEST(EnergyFlow, OfFixedStepsDoesNotDependOnSamples) {
  const MovingScene scene = drawn_back(20, 0.3);
  std::vector<double> errors;
  for (const double step : {4e-3, 2e-3, 1e-3}) {
    const RunMeasures fine = measured(scene, SteppingMethod::kTimeStepping, 0.2, 0.01, step);
    const RunMeasures coarse = measured(scene, SteppingMethod::kTimeStepping, 0.2, 0.2, step);
    EXPECT_EQ(fine.work, coarse.work);
    const double v = 20 * 20 * 0.3 * 0.2 * std::exp(-20 * 0.2);
    errors.push_back(std::abs(fine.work - 0.5 * kSlidingMass * v * v));
    EXPECT_NEAR(fine.balance->error, 0, 1e-13);  // of one body on a slide there is no other energy
  }
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.5);
  EXPECT_NEAR(errors[1] / errors[2], 4, 0.5);
}

// A force of fixed direction and a moment of fixed direction on a body that flies and tumbles about
// its third axis of inertia: F . way + M turn, from rest 1/2 (F^2 / m + M^2 / I) t^2.
TEST(EnergyFlow, OfForcesForATime) {
  MovingScene scene;
  scene.gravity.setZero();
  const int body =
      sample::add_body(scene, "box", primitive(ShapeKind::kBox, {0.05, 0.1, 0.02}), kSlidingMass);
  const double inertia = kSlidingMass / 12 * (0.05 * 0.05 + 0.1 * 0.1);
  scene.forces.push_back({body, {0, 0, 0}, {1, 2, 2}, {0, 0, 3e-3}, {0.1, 0.3}});
  const double expected = 0.5 * (9 / kSlidingMass + 9e-6 / inertia) * 0.2 * 0.2;
  for (const SteppingMethod method : kMethods)
    for (const double sample_time : {0.01, 0.5}) {
      const RunMeasures found = measured(scene, method, 0.5, sample_time);
      EXPECT_NEAR(found.work, expected, 1e-9 * expected);
      EXPECT_NEAR(found.balance->error, 0, 1e-9 * expected);
      EXPECT_EQ(found.dissipated, 0);
    }
}

// A ball that falls by h and bounces with e leaves m g h (1 - e^2) at the floor.
TEST(EnergyFlow, OfABounce) {
  MovingScene scene;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {1, 1, 0.1}), 0,
                   {Eigen::Matrix3d::Identity(), {0, 0, -0.05}});
  const double height = 0.1, bounce = 0.8;
  sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.02, 0, 0}), kSlidingMass,
                   {Eigen::Matrix3d::Identity(), {0, 0, 0.02 + height}});
  scene.friction.restitution = bounce;
  const double lost = kSlidingMass * kG * height * (1 - bounce * bounce);
  for (const double sample_time : {0.01, 0.3}) {
    const RunMeasures found = measured(scene, SteppingMethod::kEvents, 0.3, sample_time);
    EXPECT_NEAR(found.dissipated, lost, 1e-7 * lost);
    EXPECT_NEAR(found.balance->error, 0, 1e-7 * lost);
  }
}

// Dry friction of its joint takes all the energy of a cube that runs down.
TEST(EnergyFlow, OfDryFrictionOfAJoint) {
  MovingScene scene = sliding_cube();
  scene.mechanism.joints[0].friction = 0.5;
  scene.v[0] = 0.7;
  const double lost = 0.5 * kSlidingMass * 0.7 * 0.7;
  for (const SteppingMethod method : kMethods)
    for (const double sample_time : {0.01, 0.5}) {
      const RunMeasures found = measured(scene, method, 0.5, sample_time);
      EXPECT_NEAR(found.dissipated, lost, 1e-8 * lost);
      EXPECT_NEAR(found.balance->error, 0, 1e-8 * lost);
    }
}

}  // namespace
}  // namespace thenar
