// Tests for dynamics/stepping where simulators fail: unequal masses, random grasps, thin and fast
// bodies, overlap, piles, rods that jam, energy of what is left alone.

#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

using sample::centre;
using sample::kG;
using sample::primitive;

/// A floor whose upper side is z = 0.
void add_floor(MovingScene& scene, double thickness = 0.1) {
  Pose<double> X;
  X.p.z() = -0.5 * thickness;
  sample::add_body(scene, "floor", primitive(ShapeKind::kBox, {8, 8, thickness}), 0, X);
}

/// Largest rise of the energy from one sample to the next [J].
double rise(const SceneRun& run) {
  double most = 0;
  for (std::size_t i = 1; i < run.samples.size(); ++i)
    most = std::max(most, run.samples[i].energy.total() - run.samples[i - 1].energy.total());
  return most;
}

TEST(SceneStability, FingersOfAllMassesCatchTheCube) {
  for (const auto& [finger, cube, force] :
       {std::tuple{1e-4, 0.1, 2.0}, {5e-3, 5.0, 80.0}, {1e-7, 0.1, 2.0}, {1.0, 1e-3, 2.0}}) {
    SCOPED_TRACE(finger / cube);
    sample::PinchOptions grip;
    grip.finger_mass = finger;
    grip.cube_mass = cube;
    grip.force = force;
    grip.gap = finger > cube ? 0 : 1e-4;
    const sample::Pinch world = sample::pinch(grip);
    SceneOptions options;
    options.duration = 10;
    const SceneRun run = simulate_scene(world.scene, options);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    // It falls while the fingers close, then not at all.
    const double closing = std::sqrt(2 * grip.gap * finger / force);
    const double z = centre(world.scene, world.cube, run.samples.back()).z();
    EXPECT_LE(z, 1e-12);
    EXPECT_GE(z, -0.5 * kG * closing * closing * 1.01 - 1e-12);
    options.method = SteppingMethod::kTimeStepping;
    options.step_length = 5e-3;
    const SceneRun fixed = simulate_scene(world.scene, options);
    EXPECT_LT(centre(world.scene, world.cube, fixed.samples.back()).norm(), 1e-3);
  }
}

// Grips of 1.2 to 5 times what the cube's weight asks, off its centre, light and heavy: none is
// lost. 500 of them by default, THENAR_PINCHES=10000 for all.
TEST(SceneStability, RandomPinchesHold) {
  const char* all = std::getenv("THENAR_PINCHES");
  const int trials = all != nullptr ? std::stoi(all) : 500;
  ASSERT_GE(trials, 1) << "THENAR_PINCHES=" << all;
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < trials; ++trial) {
    SCOPED_TRACE(trial);
    sample::PinchOptions grip;
    grip.cube_mass = std::pow(10, -3 + 3 * uniform(engine));
    grip.finger_mass = grip.cube_mass * std::pow(10, -3 + 6 * uniform(engine));
    grip.friction = 0.3 + uniform(engine);
    grip.force = grip.cube_mass * kG / (2 * grip.friction) * (1.2 + 4 * uniform(engine));
    grip.above = 0.015 * (2 * uniform(engine) - 1);
    const sample::Pinch world = sample::pinch(grip);
    SceneOptions options;
    options.duration = 1;
    const SceneRun run = simulate_scene(world.scene, options);
    ASSERT_EQ(run.status, SceneStatus::kDone);
    // It may swing about the axis of the grip, and no more.
    const Eigen::Vector3d arm =
        centre(world.scene, world.cube, run.samples.back()) - Eigen::Vector3d(0, 0, grip.above);
    EXPECT_NEAR(std::hypot(arm.y(), arm.z()), std::abs(grip.above), 1e-8);
    EXPECT_NEAR(arm.x(), 0, 1e-8);
  }
}

TEST(SceneStability, ThrownBoxesLoseEnergyAndRest) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(engine), uniform(engine), uniform(engine));
  };
  for (int trial = 0; trial < 8; ++trial) {
    SCOPED_TRACE(trial);
    MovingScene scene;
    add_floor(scene);
    Pose<double> X;
    X.R = rotation_about<double>(vector().normalized(), 3 * uniform(engine));
    X.p.z() = 0.15;
    sample::add_body(scene, "box", primitive(ShapeKind::kBox, {0.05, 0.06, 0.07}), 0.1, X);
    scene.friction = {0.4, 0, trial % 2 == 0 ? 0 : 0.5};
    scene.v << 10 * vector(), vector();
    SceneOptions options;
    options.duration = 2;
    options.tolerance = 1e-8;
    const SceneRun run = simulate_scene(scene, options);
    EXPECT_EQ(run.status, SceneStatus::kDone);
    EXPECT_LT(rise(run), 0.1 * kG * options.touch);  // to close a gap may lift it by so much
    EXPECT_LT(run.cost.max_penetration, 1e-8);
    EXPECT_EQ(run.samples.back().v.norm(), 0);
    EXPECT_GT(run.cost.rest_time, 0.5);
  }
}

// A stack of five cubes, flat on flat, twenty contacts of which twelve would do.
TEST(SceneStability, StackIsQuiet) {
  MovingScene scene;
  add_floor(scene);
  for (int i = 0; i < 5; ++i) {
    Pose<double> X;
    X.p.z() = 0.025 + 0.05 * i;
    sample::add_body(scene, "cube " + std::to_string(i),
                     primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}), 0.1, X);
  }
  scene.friction.coefficient = 0.5;
  SceneOptions options;
  options.duration = 2;
  options.sleep = false;
  const SceneRun run = simulate_scene(scene, options);
  EXPECT_EQ(run.status, SceneStatus::kDone);
  EXPECT_LT((run.samples.back().q - run.samples.front().q).norm(), 1e-12);
}

TEST(SceneStability, NothingGoesThroughAThinPlate) {
  MovingScene scene;
  scene.gravity.setZero();
  sample::add_body(scene, "plate", primitive(ShapeKind::kBox, {0.2, 0.2, 0.0005}), 0);
  Pose<double> X;
  X.p.z() = 0.5;
  const int pellet =
      sample::add_body(scene, "pellet", primitive(ShapeKind::kSphere, {0.001, 0, 0}), 0.001, X);
  scene.v[5] = -300;
  SceneOptions options;
  options.duration = 0.01;
  options.step_length = 1e-3;
  for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping}) {
    options.method = method;
    const SceneRun run = simulate_scene(scene, options);
    EXPECT_NEAR(centre(scene, pellet, run.samples.back()).z(), 0.00125, 1e-4);
  }
}

TEST(SceneStability, DeepOverlapIsPushedOutSlowly) {
  MovingScene scene;
  add_floor(scene);
  Pose<double> X;
  X.p.z() = 0.015;  // 10 mm deep
  const int cube =
      sample::add_body(scene, "cube", primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}), 0.1, X);
  scene.friction.coefficient = 0.5;
  const SceneRun run = simulate_scene(scene, {});
  EXPECT_NEAR(centre(scene, cube, run.samples.back()).z(), 0.025, 1e-9);
  for (std::size_t i = 1; i < run.samples.size(); ++i) {
    const double up =
        centre(scene, cube, run.samples[i]).z() - centre(scene, cube, run.samples[i - 1]).z();
    EXPECT_LT(up, 0.11 * 0.01);  // 0.1 m/s over 10 ms
    EXPECT_GT(up, -1e-9);
  }
}

// A rod that slides with its tip ahead jams where friction is large (Painleve): it stops, and its
// energy falls.
TEST(SceneStability, RodJams) {
  for (const double degrees : {30.0, 60.0, 75.0})
    for (const double friction : {0.3, 1.5, 3.0})
      for (const double direction : {-2.0, 2.0}) {
        SCOPED_TRACE(fmt::format("{} deg, mu {}, {} m/s", degrees, friction, direction));
        MovingScene scene;
        add_floor(scene);
        Pose<double> X;
        X.R = rotation_about<double>({0, 1, 0}, kPi / 2 - degrees * kDegree);
        X.p = Eigen::Vector3d(0, 0, 0.005) + 0.5 * X.R.col(2);
        sample::add_body(scene, "rod", primitive(ShapeKind::kCapsule, {0.005, 1, 0}), 0.1, X);
        scene.friction.coefficient = friction;
        scene.v.tail<3>() = Eigen::Vector3d(direction, 0, 0);
        const SceneRun run = simulate_scene(scene, {});
        EXPECT_EQ(run.status, SceneStatus::kDone);
        EXPECT_LT(rise(run), 1e-9);
        EXPECT_LT(run.cost.max_penetration, 1e-8);
        // With mu = 0.3 the tip slides on; pushed ahead with mu = 3 it stops within 10 ms.
        const auto tip_speed = [&](const SceneSample& at) {
          const Eigen::Quaterniond turn(at.q[0], at.q[1], at.q[2], at.q[3]);
          const Eigen::Vector3d arm = turn * Eigen::Vector3d(0, 0, -0.5);
          return (at.v.tail<3>() + Eigen::Vector3d(at.v.head<3>()).cross(arm)).norm();
        };
        if (friction == 0.3) {
          EXPECT_GT(tip_speed(run.samples[1]), 1.5);
        }
        if (friction == 3 && direction < 0) {
          EXPECT_LT(tip_speed(run.samples[1]), 0.1);
        }
      }
}

TEST(SceneStability, LimitsStopAndJointsRub) {
  MovingScene scene;
  ShapeSpec bob = primitive(ShapeKind::kSphere, {0.01, 0, 0});
  bob.X_BS.p = {0.2, 0, 0};
  const auto body = static_cast<std::size_t>(
      sample::add_on_joint(scene, "bob", bob, 0.1, JointKind::kHinge, {0, 1, 0}, {0, 0, 0}));
  MechanismJoint& joint = scene.mechanism.joints[body];
  joint.upper = 0.5;
  SceneOptions options;
  options.duration = 3;
  EXPECT_NEAR(simulate_scene(scene, options).samples.back().q[0], 0.5, 1e-9);
  // Dry friction holds it where its weight makes less of a moment:  m g d cos(q) < 0.05 N m.
  joint.upper = 1e9;
  joint.friction = 0.05;
  const SceneRun run = simulate_scene(scene, options);
  EXPECT_EQ(run.samples.back().v[0], 0);
  EXPECT_LT(0.1 * kG * 0.2 * std::cos(run.samples.back().q[0]), 0.05);
}

// A speed that friction has stopped does not fade through numbers of ever fewer digits, on which
// no contact problem can be solved.
TEST(SceneStability, WhatFrictionStoppedIsAtRest) {
  MovingScene scene;
  scene.gravity.setZero();
  sample::add_on_joint(scene, "cube", primitive(ShapeKind::kBox, {0.1, 0.1, 0.1}), 0.2,
                       JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  scene.mechanism.joints[0].friction = 0.5;
  scene.v[0] = 0.7;
  SceneOptions options;
  options.method = SteppingMethod::kTimeStepping;
  const SceneRun run = simulate_scene(scene, options);
  EXPECT_EQ(run.status, SceneStatus::kDone);
  EXPECT_EQ(run.samples.back().v[0], 0);
}

TEST(SceneStability, TheSameSceneGivesTheSameBits) {
  sample::PinchOptions grip;
  grip.above = 0.004;
  grip.force = 8;
  const sample::Pinch world = sample::pinch(grip);
  const SceneRun first = simulate_scene(world.scene, {}), second = simulate_scene(world.scene, {});
  ASSERT_EQ(first.samples.size(), second.samples.size());
  for (std::size_t i = 0; i < first.samples.size(); ++i) {
    EXPECT_EQ(first.samples[i].q, second.samples[i].q);
    EXPECT_EQ(first.samples[i].v, second.samples[i].v);
  }
}

TEST(SceneStability, RefusesWhatIsNotFinite) {
  MovingScene scene;
  const int cube =
      sample::add_body(scene, "cube", primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}), 0.1);
  scene.forces.push_back({cube, {0, 0, 0}, {std::nan(""), 0, 0}});
  EXPECT_THROW((void)simulate_scene(scene, {}), InputError);
}

// A force that makes everything infinite ends the run, with what came before.
TEST(SceneStability, EndsWhereNumbersEnd) {
  MovingScene scene;
  const int cube =
      sample::add_body(scene, "cube", primitive(ShapeKind::kBox, {0.05, 0.05, 0.05}), 0.1);
  scene.forces.push_back({cube, {0, 0, 0}, {1e300, 0, 0}, {1e300, 0, 0}, {0.5}});
  SceneOptions options;
  for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping}) {
    options.method = method;
    const SceneRun run = simulate_scene(scene, options);
    EXPECT_EQ(run.status, SceneStatus::kNotFinite);
    EXPECT_GE(run.samples.size(), 50U);
    for (const SceneSample& at : run.samples) EXPECT_TRUE(at.q.allFinite());
  }
}

// A force counts from the instant at which it begins, whenever that is: also where a step of the
// resting block ends just there, and where the instant is no sum of steps to the last bit.
TEST(SceneStability, ForcesBeginWhenTheySay) {
  const double friction = 0.3, force = 2, mass = 0.1;
  for (const SteppingMethod method : {SteppingMethod::kEvents, SteppingMethod::kTimeStepping})
    for (const double begin : {0.005, 0.009, 0.01, 0.013, 0.015, 0.018, 0.02, 0.025, 0.03, 0.04}) {
      SCOPED_TRACE(begin);
      sample::Incline world = sample::incline(0, friction);
      SceneForce push;
      push.body = world.cube;
      push.force = {force, 0, 0};
      push.when.from = begin;
      world.scene.forces.push_back(push);
      SceneOptions options;
      options.method = method;
      options.duration = 0.1;
      const SceneRun run = simulate_scene(world.scene, options);
      ASSERT_EQ(run.status, SceneStatus::kDone);
      const double acceleration = force / mass - friction * sample::kG, time = 0.1 - begin;
      const Eigen::Vector3d moved = centre(world.scene, world.cube, run.samples.back()) -
                                    centre(world.scene, world.cube, run.samples.front());
      EXPECT_NEAR(moved.x(), 0.5 * acceleration * time * time, 1e-6);
      EXPECT_NEAR(moved.z(), 0, 1e-8);
      for (const SceneSample& at : run.samples)
        for (const ContactSample& contact : at.contacts) EXPECT_LT(contact.force.norm(), 3);
    }
}

// A ball that is tossed against a ceiling and comes back within one long step has met it.
TEST(SceneStability, AContactThatClosesAndOpensWithinAStepIsSeen) {
  const double speed = 0.1, gap = 0.25e-3, radius = 0.01;
  const double rises = speed * speed / (2 * sample::kG);
  ASSERT_GT(rises, gap);
  double last = 0;
  for (const double sample_time : {0.1, 0.05, 0.01, 1e-3}) {
    SCOPED_TRACE(sample_time);
    MovingScene scene;
    sample::add_body(scene, "ceiling", primitive(ShapeKind::kBox, {1, 1, 0.1}), 0,
                     {Eigen::Matrix3d::Identity(), {0, 0, radius + gap + 0.05}});
    const int ball =
        sample::add_body(scene, "ball", primitive(ShapeKind::kSphere, {radius, 0, 0}), 0.1);
    scene.v[5] = speed;
    SceneOptions options;
    options.duration = 0.2;
    options.sample_interval = sample_time;
    const SceneRun run = simulate_scene(scene, options);
    // It stops at the ceiling, as nothing bounces, and falls from there.
    const double meets = (speed - std::sqrt(speed * speed - 2 * sample::kG * gap)) / sample::kG;
    const double falls = 0.2 - meets;
    EXPECT_EQ(run.cost.impacts, 1);
    last = centre(scene, ball, run.samples.back()).z();
    EXPECT_NEAR(last, gap - 0.5 * sample::kG * falls * falls, 1e-7);
  }
}

// A tolerance below rounding cannot be met: the run says how many steps missed it, and goes on.
TEST(SceneStability, StepsThatMissTheToleranceAreCounted) {
  sample::Incline world = sample::incline(0.7, 0.3);
  SceneOptions options;
  options.duration = 2e-6;
  options.tolerance = 1e-200;
  const SceneRun run = simulate_scene(world.scene, options);
  EXPECT_GT(run.cost.inaccurate_steps, 0);
  EXPECT_DOUBLE_EQ(run.samples.back().t, 2e-6);
  options.tolerance = 1e-9;
  EXPECT_EQ(simulate_scene(world.scene, options).cost.inaccurate_steps, 0);
}

}  // namespace
}  // namespace thenar
