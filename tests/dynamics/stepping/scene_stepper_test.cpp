// Tests for dynamics/stepping/scene_stepper.cpp and fixed_step.cpp.

#include "dynamics/stepping/scene_stepper.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/stop_scope.h"
#include "tests/dynamics/stepping/sample_scenes.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using sample::kG;
using sample::primitive;

SceneOptions by_steps_of(double step, double seconds = 1) {
  SceneOptions options;
  options.method = SteppingMethod::kTimeStepping;
  options.step_length = step;
  options.duration = seconds;
  return options;
}

/// A ball of 0.5 kg on a slide along x, without weight.
MovingScene slider() {
  MovingScene scene;
  sample::add_on_joint(scene, "ball", primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.5,
                       JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  scene.gravity.setZero();
  return scene;
}

/// A pinched cube, which a force pushes for a time that begins and ends within steps.
MovingScene pushed_pinch() {
  MovingScene scene = sample::pinch({}).scene;
  SceneForce push;
  push.body = 2;
  push.force = {0, 3, 0};
  push.when = {0.0301, 0.0507};
  scene.forces.push_back(push);
  return scene;
}

void expect_same(const SceneState& a, const SceneState& b) {
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.w, b.w);
}

TEST(SceneStepper, MakesTheStepsOfSimulateScene) {
  const MovingScene scene = pushed_pinch();
  SceneOptions options = by_steps_of(1e-3, 0.1);
  options.sample_interval = 1e-3;
  const SceneRun run = simulate_scene(scene, options);
  ASSERT_EQ(run.samples.size(), 101u);
  SceneStepper stepper(scene, options);
  for (const SceneSample& wanted : run.samples) {
    const SceneSample got = stepper.sample();
    expect_same({got.t, got.q, got.v, got.z, {got.w}},
                {wanted.t, wanted.q, wanted.v, wanted.z, {wanted.w}});
    ASSERT_EQ(got.contacts.size(), wanted.contacts.size());
    for (std::size_t i = 0; i < got.contacts.size(); ++i)
      EXPECT_EQ(got.contacts[i].force, wanted.contacts[i].force);
    stepper.step();
  }
  // Two instants within steps divide them: 101 steps in 103 parts.
  EXPECT_EQ(run.cost.steps, 102);
  EXPECT_EQ(stepper.cost().steps, 103);
}

// A contact problem hears of it within a step, which then has never begun.
TEST(SceneStepper, GoesBackWhereAContactProblemIsStopped) {
  SceneStepper stepper(pushed_pinch(), by_steps_of(1e-3)), other(pushed_pinch(), by_steps_of(1e-3));
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(stepper.step());
    ASSERT_TRUE(other.step());
  }
  stepper.set_effort(0, 1);  // so that there is something to solve
  other.set_effort(0, 1);
  const SceneState before = stepper.now().state;
  {
    Progress progress;
    progress.stop_requested = [] { return true; };
    const StopScope scope(progress);
    EXPECT_FALSE(stepper.step());
  }
  expect_same(stepper.now().state, before);
  EXPECT_TRUE(stepper.step());
  EXPECT_TRUE(other.step());
  expect_same(stepper.now().state, other.now().state);
}

// The midpoint rule is exact for constant acceleration.
TEST(SceneStepper, FreeBodyFallsByHalfOfGravityTimesTheSquareOfTime) {
  MovingScene scene;
  sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1);
  SceneStepper stepper(scene, by_steps_of(1e-3));
  for (int i = 0; i < 1500; ++i) stepper.step();
  EXPECT_DOUBLE_EQ(stepper.now().state.t, 1.5);
  EXPECT_NEAR(stepper.now().state.q[6], -0.5 * kG * 1.5 * 1.5, 1e-12);
  EXPECT_NEAR(stepper.now().state.v[5], -kG * 1.5, 1e-12);
}

// The error of the energy is of second order in the step, and does not grow.
TEST(SceneStepper, PendulumKeepsItsEnergy) {
  MovingScene scene;
  ShapeSpec bob = primitive(ShapeKind::kSphere, {0.02, 0, 0});
  bob.X_BS.p = {0.3, 0, 0};
  sample::add_on_joint(scene, "rod", bob, 0.2, JointKind::kHinge, {0, 1, 0}, {0, 0, 0});
  const double most = 0.2 * kG * 0.3;  // that it turns from weight to motion [J]
  std::vector<double> errors;
  for (const double h : {2e-3, 1e-3}) {
    SceneStepper stepper(scene, by_steps_of(h));
    const double start = stepper.sample().energy.total();
    double error = 0;
    while (stepper.now().state.t < 10) {
      stepper.step();
      error = std::max(error, std::abs(stepper.sample().energy.total() - start));
    }
    EXPECT_LT(error, 1e-4 * most) << h;
    errors.push_back(error);
  }
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.4);
}

TEST(SceneStepper, EffortMovesAMassAsNewtonSays) {
  SceneStepper stepper(slider(), by_steps_of(1e-3));
  stepper.set_effort(0, 2);
  for (int i = 0; i < 500; ++i) stepper.step();
  EXPECT_NEAR(stepper.now().state.v[0], 2 / 0.5 * 0.5, 1e-12);
  EXPECT_NEAR(stepper.now().state.q[0], 0.5 * (2 / 0.5) * 0.25, 1e-12);
  EXPECT_EQ(stepper.effort(0, stepper.now()), 2);
  // Its work is the kinetic energy.
  EXPECT_NEAR(stepper.now().state.w[kAppliedWork], 0.5 * 0.5 * 4, 1e-12);
  stepper.release(0);
  stepper.step();
  EXPECT_NEAR(stepper.now().state.v[0], 2, 1e-12);
  EXPECT_EQ(stepper.effort(0, stepper.now()), 0);
}

TEST(SceneStepper, EffortTakesThePlaceOfDrivesAndStaysWithinTheirLargest) {
  MovingScene scene = slider();
  SceneDrive drive;
  drive.stiffness = 100;
  drive.damping = 20;
  drive.target = 0.1;
  drive.max_effort = 1.5;
  scene.drives = {drive};
  SceneStepper stepper(scene, by_steps_of(1e-3));
  stepper.set_effort(0, -7);
  EXPECT_EQ(stepper.effort(0, stepper.now()), -1.5);
  for (int i = 0; i < 100; ++i) stepper.step();
  EXPECT_NEAR(stepper.now().state.v[0], -1.5 / 0.5 * 0.1, 1e-12);
  // A target goes to the drive; a critically damped one has arrived after 20 of its times.
  stepper.set_target(0, -0.02);
  for (int i = 0; i < 4000; ++i) stepper.step();
  EXPECT_NEAR(stepper.now().state.q[0], -0.02, 1e-9);
  stepper.release(0);
  for (int i = 0; i < 4000; ++i) stepper.step();
  EXPECT_NEAR(stepper.now().state.q[0], 0.1, 1e-9);
}

TEST(SceneStepper, RefusesInputsThatMeanNothing) {
  SceneStepper stepper(slider(), by_steps_of(1e-3));
  EXPECT_EQ(message_of([&] { stepper.set_effort(1, 0); }), "there is no coordinate 1");
  EXPECT_EQ(message_of([&] { stepper.set_effort(0, std::nan("")); }),
            "effort of 'ball': wanted a finite number, got nan");
  EXPECT_EQ(message_of([&] { stepper.set_target(0, 1); }),
            "no drive with stiffness moves 'ball': set its effort instead");
  EXPECT_THROW(stepper.set_control("human/index/FDP", 1), InputError);
}

TEST(SceneStepper, RepeatsItselfAfterReset) {
  SceneStepper stepper(pushed_pinch(), by_steps_of(1e-3));
  std::vector<SceneState> first;
  const auto run = [&](std::vector<SceneState>& out) {
    for (int i = 0; i < 100; ++i) {
      if (i == 60) stepper.set_effort(0, 3);
      stepper.step();
      out.push_back(stepper.now().state);
    }
  };
  run(first);
  stepper.reset();
  EXPECT_EQ(stepper.now().state.t, 0);
  EXPECT_NE(stepper.effort(0, stepper.now()), 3);
  std::vector<SceneState> second;
  run(second);
  for (std::size_t i = 0; i < first.size(); ++i) expect_same(first[i], second[i]);
}

// What follows depends on the instant, not on what the stepper has seen since.
TEST(SceneStepper, GoesOnFromAnInstantAlone) {
  SceneStepper stepper(pushed_pinch(), by_steps_of(1e-3));
  for (int i = 0; i < 40; ++i) stepper.step();
  const SceneInstant branch = stepper.now();
  std::vector<SceneState> ends;
  for (const int more : {0, 30, 5}) {
    for (int i = 0; i < more; ++i) stepper.step();
    stepper.go_to(branch);
    for (int i = 0; i < 40; ++i) stepper.step();
    ends.push_back(stepper.now().state);
  }
  expect_same(ends[0], ends[1]);
  expect_same(ends[0], ends[2]);
  EXPECT_DOUBLE_EQ(ends[0].t, 0.08);
  SceneStepper other(slider(), by_steps_of(1e-3));
  EXPECT_THROW(other.go_to(branch), InputError);
}

TEST(SceneStepper, CountsSinceItWasAskedLast) {
  SceneStepper stepper(pushed_pinch(), by_steps_of(1e-3));
  for (int i = 0; i < 5; ++i) stepper.step();
  const SceneCost cost = stepper.take_cost();
  EXPECT_EQ(cost.steps, 5);
  EXPECT_EQ(cost.unsolved, 0);
  EXPECT_GT(cost.worst_residual, 0);
  EXPECT_LT(cost.worst_residual, 1e-9);
  EXPECT_EQ(stepper.cost().steps, 0);
  EXPECT_EQ(stepper.cost().worst_residual, 0);
}

/// A ball of 2 cm that flies along x from the origin at a plate of 1 mm at x = 50 mm, or past it.
/// @param aside  how far beside the middle of the plate, which ends at 0.1 [m]
MovingScene shot(double speed, double aside) {
  MovingScene scene;
  sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1);
  Pose<double> X;
  X.p = {0.05, aside, 0};
  sample::add_body(scene, "plate", primitive(ShapeKind::kBox, {0.001, 0.2, 0.2}), 0, X);
  scene.gravity.setZero();
  scene.v[3] = speed;
  return scene;
}

/// Steps of 1 ms that may be divided into so many parts at most.
SceneOptions in_parts(int parts) {
  SceneOptions options = by_steps_of(1e-3);
  options.min_step = options.step_length / parts;
  return options;
}

// At 120 m/s the middle of a step of 1 ms lies behind the plate: in one part the ball goes through,
// in two it is caught.
TEST(SceneStepper, CountsStepsThatPassThroughSomething) {
  for (const int parts : {1, 256}) {
    SceneStepper stepper(shot(120, 0), in_parts(parts));
    stepper.step();
    EXPECT_EQ(stepper.now().state.q[4] > 0.05, parts == 1);
    EXPECT_EQ(stepper.take_cost().tunnelling_steps, parts == 1 ? 1 : 0);
    EXPECT_EQ(stepper.cost().tunnelling_steps, 0);
  }
}

// Near the plate 0.5 mm may pass unseen. At 40 m/s parts of a 256th of 1 ms do, those of a 16th do
// not.
TEST(SceneStepper, CountsStepsThatMayHavePassedSomething) {
  for (const int parts : {16, 256}) {
    SceneStepper stepper(shot(40, 0.13), in_parts(parts));
    stepper.step();
    EXPECT_NEAR(stepper.now().state.q[4], 0.04, 1e-12);
    EXPECT_EQ(stepper.cost().tunnelling_steps, parts == 16 ? 1 : 0);
  }
}

// It is asked between parts, and goes back to where the step began.
TEST(SceneStepper, StopsWithinADividedStep) {
  SceneOptions options = by_steps_of(1e-3);
  SceneStepper stepper(shot(40, 0.13), options), other(shot(40, 0.13), options);
  int asked = 0, told = 0;
  Progress progress;
  progress.stop_requested = [&] { return ++asked == 20; };
  progress.report = [&](double share, const std::string&) {
    EXPECT_GE(share, 0);
    EXPECT_LT(share, 1);
    ++told;
  };
  int steps = 0;
  while (stepper.step(progress)) ASSERT_LT(++steps, 10);
  EXPECT_EQ(asked, 20);
  EXPECT_GT(told, 10);
  for (int i = 0; i < steps; ++i) other.step();
  expect_same(stepper.now().state, other.now().state);
  EXPECT_EQ(stepper.now().steps, steps);
  // It goes on as if it had not been stopped.
  progress.stop_requested = [] { return false; };
  EXPECT_TRUE(stepper.step(progress));
  other.step();
  expect_same(stepper.now().state, other.now().state);
}

TEST(SceneStepper, StandsStillWhereNumbersHaveEnded) {
  MovingScene scene = slider();
  SceneStepper stepper(scene, by_steps_of(1e-3));
  stepper.set_effort(0, 1e308);
  for (int i = 0; i < 1500; ++i) stepper.step();  // 2e305 m/s a step
  EXPECT_FALSE(is_finite(stepper.now().state));
  const long steps = stepper.now().steps;
  stepper.step();
  EXPECT_EQ(stepper.now().steps, steps);
}

}  // namespace
}  // namespace thenar
