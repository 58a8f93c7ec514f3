// Tests for dynamics/stepping/scene_contacts.cpp: a cube on a floor, and balls that pass.

#include "dynamics/stepping/scene_contacts.h"

#include <gtest/gtest.h>

#include "tests/dynamics/stepping/sample_scenes.h"

namespace thenar {
namespace {

TEST(SceneContacts, AreTheCornersOfACubeOnAFloor) {
  const sample::Incline at = sample::incline(0, 0.5);
  const TreeModel model = tree_model(at.scene.mechanism);
  SceneMotion motion(model);
  SceneContacts contacts(at.scene, model);
  SceneState state{0, at.scene.q, at.scene.v};
  state.v.tail<3>() = Eigen::Vector3d(0.3, 0, -0.2);
  motion.set_state(state);
  std::vector<ActiveContact> found;
  contacts.find_contacts(motion, state, 1e-6, found);
  ASSERT_EQ(found.size(), 4U);
  for (const ActiveContact& contact : found) {
    EXPECT_NEAR(std::abs(contact.point.x()), 0.025, 1e-12);
    EXPECT_NEAR(contact.gap, 0, 1e-12);
    EXPECT_NEAR(contact.approach, -0.2, 1e-12);
    EXPECT_NEAR(contact.slip, 0.3, 1e-12);
    EXPECT_EQ(contact.friction.coefficient, 0.5);
  }
  EXPECT_NEAR(contacts.extent(0), 0.05, 1e-12);  // the floor's middle
}

/// Two balls of 10 mm radius, 100 mm apart along x.
MovingScene two_balls() {
  MovingScene scene;
  Pose<double> X;
  (void)sample::add_body(scene, "a", sample::primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1, X);
  X.p.x() = 0.1;
  (void)sample::add_body(scene, "b", sample::primitive(ShapeKind::kSphere, {0.01, 0, 0}), 0.1, X);
  return scene;
}

// A way through the other is 0.2 m; half of a ball's thickness, 20 mm, may pass unseen.
TEST(SceneContacts, TellMotionsInWhichBodiesMayHaveMet) {
  const MovingScene scene = two_balls();
  const TreeModel model = tree_model(scene.mechanism);
  SceneMotion motion(model);
  SceneContacts contacts(scene, model);
  const SceneState from{0, scene.q, scene.v};
  SceneState through = from, away = from;
  through.q[4] += 0.2;
  away.q[4] -= 0.04;
  const double thickness = 2 * 0.2 / contacts.tunnelling_ratio(motion, from, through, {});
  EXPECT_GT(thickness, 0.01);
  EXPECT_LT(thickness, 0.03);
  // They stay 80 mm apart at least, and moved by 40.
  EXPECT_EQ(contacts.tunnelling_ratio(motion, from, away, {}), 0);
}

TEST(SceneContacts, KnowTheFastestPointOfABody) {
  const MovingScene scene = two_balls();
  const TreeModel model = tree_model(scene.mechanism);
  SceneMotion motion(model);
  const SceneContacts contacts(scene, model);
  motion.set_state({0, scene.q, scene.v});
  Eigen::VectorXd v = Eigen::VectorXd::Zero(12);
  v.segment<3>(3) = Eigen::Vector3d(0.5, 0, 0);
  v[2] = 20;  // [rad/s]
  EXPECT_NEAR(contacts.max_relative_speed(motion, v), 2 * (0.5 + 20 * 0.01), 1e-12);
}

}  // namespace
}  // namespace thenar
