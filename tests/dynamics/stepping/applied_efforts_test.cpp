// Tests for dynamics/stepping/applied_efforts.cpp and free_velocity.cpp: a ball on a slide with a
// spring and a damper.

#include "dynamics/stepping/applied_efforts.h"

#include <gtest/gtest.h>

#include "dynamics/stepping/free_velocity.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

constexpr double kBallMass = 0.02;   // [kg]
constexpr double kBallSpring = 50;   // [N/m]
constexpr double kBallDamper = 0.3;  // [N s/m]
constexpr double kStretch = 4e-3;    // [m]
constexpr double kSpeed = 0.7;       // [m/s]

MovingScene sprung_ball() {
  MovingScene scene;
  const int ball =
      sample::add_on_joint(scene, "ball", sample::primitive(ShapeKind::kSphere, {0.01, 0, 0}),
                           kBallMass, JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  MechanismJoint& joint = scene.mechanism.joints[static_cast<std::size_t>(ball)];
  joint.stiffness = kBallSpring;
  joint.damping = kBallDamper;
  scene.gravity.setZero();
  scene.q[0] = joint.rest + kStretch;
  scene.v[0] = kSpeed;
  return scene;
}

struct AtStart {
  explicit AtStart(MovingScene s)
      : scene(std::move(s)),
        model(tree_model(scene.mechanism)),
        motion(model),
        efforts(scene, model) {
    state = {0, scene.q, scene.v, efforts.elements.initial_states(scene.q)};
    motion.set_state(state);
  }
  MovingScene scene;
  TreeModel model;
  SceneMotion motion;
  AppliedEfforts efforts;
  SceneState state;
};

TEST(AppliedEfforts, AreThoseOfSpringsAndDampers) {
  AtStart at(sprung_ball());
  EXPECT_TRUE(at.efforts.compute(at.motion, at.state));
  EXPECT_NEAR(at.efforts.tau[0], -kBallSpring * kStretch - kBallDamper * kSpeed, 1e-15);
  EXPECT_EQ(at.efforts.stiffness[0], kBallSpring);
  EXPECT_EQ(at.efforts.damping[0], kBallDamper);
  EXPECT_NEAR(at.efforts.spring_energy(at.state), kBallSpring * kStretch * kStretch / 2, 1e-18);
  EXPECT_TRUE(at.efforts.has_slopes());
}

TEST(AppliedEfforts, AreThoseOfDrivesWhoseSpanHolds) {
  MovingScene scene = sprung_ball();
  SceneDrive drive;
  drive.coordinate = 0;
  drive.bias = 2;
  drive.when = {0.1, 0.2};
  scene.drives = {drive};
  AtStart at(std::move(scene));
  const double springs = -kBallSpring * kStretch - kBallDamper * kSpeed;
  for (const auto& [t, force] : {std::pair(0.05, 0.0), {0.15, 2.0}, {0.25, 0.0}}) {
    at.efforts.select_active_forces(t);
    EXPECT_TRUE(at.efforts.compute(at.motion, at.state));
    EXPECT_NEAR(at.efforts.tau[0], springs + force, 1e-14) << t;
  }
}

// (m + h c + h^2 k) (v+ - v) = h tau.
TEST(FreeVelocity, TakesSpringsAtTheEndOfAStepOrInItsMean) {
  AtStart at(sprung_ball());
  (void)at.efforts.compute(at.motion, at.state);
  FreeVelocity free(at.scene, at.model);
  constexpr double kStep = 2e-2;  // [s]
  for (const double d : {1.0, 0.5}) {
    EXPECT_TRUE(free.compute(at.motion, at.efforts, at.state, kStep, d));
    const double mass = kBallMass + d * kStep * kBallDamper + d * kStep * d * kStep * kBallSpring;
    EXPECT_NEAR(free.v[0], kSpeed + kStep * at.efforts.tau[0] / mass, 1e-13) << d;
  }
  EXPECT_TRUE(free.compute(at.motion, at.efforts, at.state, 0, 0));
  EXPECT_EQ(free.v[0], kSpeed);
  free.apply_impulses(Eigen::VectorXd::Constant(1, 0.01));
  EXPECT_NEAR(free.v[0], kSpeed + 0.01 / kBallMass, 1e-13);
}

}  // namespace
}  // namespace thenar
