// Tests for hand/link_wrench.cpp.

#include "hand/link_wrench.h"

#include <gtest/gtest.h>

#include "hand/statics.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

// Independent: loads of forces at points of links, whose torque statics.cpp finds.
TEST(JointTorque, OfForcesIsThatOfTheSameLoads) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const Eigen::Vector2d q(0.4, 0.7);
  const TreeState<double> state = pose_tree(skeleton.tree, q);
  const Eigen::Vector3d upper(2, 1, -1), lower(3, -5, 2);  // [N]
  const Eigen::Vector3d in_upper(0.01, 0.02, 0.03), in_lower(0.04, -0.01, 0);
  const Loads loads{{0, 0, 0}, {{0, in_upper, upper}, {1, in_lower, lower}}};
  const std::vector<LinkWrench> wrenches{{0, wrench_of_force(state[0].X * in_upper, upper)},
                                         {1, wrench_of_force(state[1].X * in_lower, lower)}};
  EXPECT_TRUE(matrix_near(joint_torque(skeleton.tree, state, wrenches, 2),
                          load_torque(skeleton, q, loads), 1e-15));
}

// By hand: a couple turns both hinges alike, one on the base turns neither.
TEST(JointTorque, OfACoupleIsItsComponentAlongEachAxis) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const TreeState<double> state = pose_tree(skeleton.tree, Eigen::Vector2d(0.4, 0.7));
  const Wrench couple{{0, 0, 2}, {0, 0, 0}};
  EXPECT_TRUE(matrix_near(joint_torque(skeleton.tree, state, {{1, couple}}, 2),
                          Eigen::Vector2d(2, 2), 1e-15));
  EXPECT_TRUE(
      matrix_near(joint_torque(skeleton.tree, state, {{-1, couple}}, 2), Eigen::Vector2d(0, 0), 0));
}

}  // namespace
}  // namespace thenar
