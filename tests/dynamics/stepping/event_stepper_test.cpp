// Tests for dynamics/stepping/event_stepper.cpp, touching_contacts.cpp and scene_sleep.cpp: a ball
// that bounces, and a cube that comes to rest.

#include "dynamics/stepping/event_stepper.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

/// Goes on to an instant.
void go_to(EventStepper& stepper, double t) {
  while (stepper.state().t < t) ASSERT_TRUE(stepper.take_step(t));
}

// It rises to e^2 of its height, after falling for sqrt(2 h / g) and rising for e times as long.
TEST(EventStepper, BouncesABallAsNewtonSays) {
  constexpr double kHeight = 0.1, kRestitution = 0.5;
  MovingScene scene;
  Pose<double> X;
  X.p.z() = -0.05;
  (void)sample::add_body(scene, "floor", sample::primitive(ShapeKind::kBox, {1, 1, 0.1}), 0, X);
  X.p.z() = 0.01 + kHeight;
  const int ball =
      sample::add_body(scene, "ball", sample::primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1, X);
  scene.friction.restitution = kRestitution;
  const SceneOptions options;
  SceneCost cost;
  EventStepper stepper(scene, options, cost);
  stepper.resolve_initial_impacts();
  const double falls = std::sqrt(2 * kHeight / sample::kG);
  go_to(stepper, falls * (1 + kRestitution));
  EXPECT_EQ(cost.impacts, 1);
  EXPECT_NEAR(sample::centre(scene, ball, stepper.sample()).z() - 0.01,
              kRestitution * kRestitution * kHeight, 1e-6);
  EXPECT_NEAR(stepper.state().v.tail<1>()[0], 0, 1e-5);
}

TEST(EventStepper, LetsSleepWhatRests) {
  const sample::Incline at = sample::incline(0, 0.5);
  const SceneOptions options;
  SceneCost cost;
  EventStepper stepper(at.scene, options, cost);
  stepper.resolve_initial_impacts();
  go_to(stepper, 10);
  EXPECT_GT(cost.rest_time, 9);
  EXPECT_TRUE(is_still(stepper.state()));
  // Four corners bear its weight.
  double weight = 0;
  for (const ContactSample& contact : stepper.sample().contacts) weight += contact.force.norm();
  EXPECT_NEAR(weight, 0.1 * sample::kG, 1e-6);
}

}  // namespace
}  // namespace thenar
