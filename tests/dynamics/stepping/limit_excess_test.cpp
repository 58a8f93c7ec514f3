// Tests for dynamics/stepping/limit_excess.cpp.

#include "dynamics/stepping/limit_excess.h"

#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/stepping/scene_stepper.h"
#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

Mechanism drawer_and_door() {
  MovingScene scene;
  const ShapeSpec box = sample::primitive(ShapeKind::kBox, {0.1, 0.1, 0.1});
  sample::add_on_joint(scene, "drawer", box, 0.1, JointKind::kSlide, {1, 0, 0}, {0, 0, 0});
  sample::add_on_joint(scene, "door", box, 0.1, JointKind::kHinge, {0, 0, 1}, {1, 0, 0});
  scene.mechanism.joints[0].lower = -0.01;
  scene.mechanism.joints[0].upper = 0.05;
  scene.mechanism.joints[1].upper = 90 * kDegree;
  return scene.mechanism;
}

TEST(LimitExcess, KeepsTheFarthestOfEachJoint) {
  const Mechanism mechanism = drawer_and_door();
  const MechanismLayout layout = layout_of(mechanism);
  Eigen::VectorXd beyond;
  for (const double way : {0.0, 0.09, -0.02, 0.05})
    update_limit_excess(mechanism, layout, Eigen::Vector2d(way, 0), beyond);
  ASSERT_EQ(beyond.size(), 2);
  EXPECT_NEAR(beyond[0], 0.04, 1e-15);
  EXPECT_EQ(beyond[1], 0);
  const std::vector<PassedLimit> passed = passed_limits(mechanism, beyond);
  ASSERT_EQ(passed.size(), 1U);
  EXPECT_EQ(passed[0].joint, mechanism.joints[0].name);
  EXPECT_TRUE(passed[0].slides);
  EXPECT_NEAR(passed[0].excess, 0.04, 1e-15);
}

TEST(LimitExcess, JoinsWhatTwoPartsOfARunKept) {
  Eigen::VectorXd all;
  keep_max_excess(Eigen::VectorXd(), all);
  EXPECT_EQ(all.size(), 0);
  keep_max_excess(Eigen::Vector2d(1, 2), all);
  keep_max_excess(Eigen::Vector2d(3, 1), all);
  keep_max_excess(Eigen::VectorXd(), all);
  EXPECT_EQ(all, Eigen::Vector2d(3, 2));
}

// At 2 m/s a step of 10 ms brings a drawer 20 mm farther, and its limit is asked in the middle.
TEST(LimitExcess, IsToldOfFixedSteps) {
  MovingScene scene;
  scene.gravity.setZero();
  scene.mechanism = drawer_and_door();
  scene.q = Eigen::Vector2d(0.045, 0);
  scene.v = Eigen::Vector2d(2, 0);
  SceneOptions options;
  options.step_length = 1e-2;
  SceneStepper stepper(scene, options);
  double farthest = 0;
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(stepper.step());
    farthest = std::max(farthest, stepper.now().state.q[0] - 0.05);
  }
  EXPECT_DOUBLE_EQ(stepper.cost().limit_excess[0], std::max(farthest, 0.0));
  EXPECT_GT(stepper.cost().limit_excess[0], 0);
  EXPECT_EQ(stepper.cost().limit_excess[1], 0);
}

}  // namespace
}  // namespace thenar
