// Tests for hand/statics.cpp.

#include "hand/statics.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/hand/sample_subjects.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using sample::kLowerLength;
using sample::kUpperLength;

// By hand: the moment of a force f at the tip about each joint, z component of r x f.
TEST(LoadTorque, OfATipForceOnTwoLinks) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const double q1 = 0.4, q2 = 0.7;
  const Eigen::Vector3d elbow(kUpperLength * std::cos(q1), kUpperLength * std::sin(q1), 0);
  const Eigen::Vector3d lower(kLowerLength * std::cos(q1 + q2), kLowerLength * std::sin(q1 + q2),
                              0);
  const Eigen::Vector3d f(3, -5, 2);  // [N]
  const Loads loads{{0, 0, 0}, {{1, skeleton.tips[0].p, f}}};
  const Eigen::Vector2d expected((elbow + lower).cross(f).z(), lower.cross(f).z());
  EXPECT_TRUE(matrix_near(load_torque(skeleton, Eigen::Vector2d(q1, q2), loads), expected, 1e-16));
}

// By hand: a horizontal finger, gravity down its plane; every link's weight at its middle.
TEST(LoadTorque, OfGravityOnTwoLinks) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const double g = 9.81, m1 = skeleton.masses[0].mass, m2 = skeleton.masses[1].mass;
  const double about_2 = -g * m2 * kLowerLength / 2;
  const double about_1 = -g * (m1 * kUpperLength / 2 + m2 * (kUpperLength + kLowerLength / 2));
  const Loads loads{{0, -g, 0}, {}};
  EXPECT_TRUE(matrix_near(load_torque(skeleton, Eigen::Vector2d(0, 0), loads),
                          Eigen::Vector2d(about_1, about_2), 1e-16));
}

// Gravity torque is minus the gradient of the potential  -sum m g'com.
TEST(LoadTorque, OfGravityIsAGradient) {
  sample::Draw draw(31);
  const Skeleton skeleton = build_skeleton(sample::random_hand(32));
  const Eigen::Vector3d g = draw.vector(9);
  const auto potential = [&](const Eigen::VectorXd& q) {
    const TreeState<double> state = pose_tree(skeleton.tree, q);
    double V = 0;
    for (int i = 0; i < static_cast<int>(state.size()); ++i)
      V -= skeleton.masses[i].mass * g.dot(moved(state, i, skeleton.masses[i].com));
    return V;
  };
  const Eigen::VectorXd q = draw.posture(skeleton);
  const Eigen::VectorXd tau = load_torque(skeleton, q, {g, {}});
  const double h = 1e-5;
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(q.size(), i);
    EXPECT_NEAR(tau[i], -(potential(q + step) - potential(q - step)) / (2 * h), 1e-9);  // [N m]
  }
}

TEST(LoadTorque, OfAForceOnTheBaseIsZero) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  const Loads loads{{0, 0, 0}, {{-1, {1, 2, 3}, {4, 5, 6}}}};
  EXPECT_TRUE(load_torque(skeleton, Eigen::Vector2d(1, 1), loads).isZero(0));
}

TEST(LoadTorque, RejectsWrongLengthAndMissingLink) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  EXPECT_THROW((void)load_torque(skeleton, Eigen::Vector3d::Zero(), {}), InputError);
  const Loads loads{{0, 0, 0}, {{2, {0, 0, 0}, {1, 0, 0}}}};
  EXPECT_THROW((void)load_torque(skeleton, Eigen::Vector2d::Zero(), loads), InputError);
}

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
