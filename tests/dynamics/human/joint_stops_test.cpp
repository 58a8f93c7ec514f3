// Tests for dynamics/human/joint_stops.cpp: stops of two joints in a scene of four speeds.

#include "dynamics/human/joint_stops.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "dynamics/mechanism/tree_model.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::VectorXd;

/// A skeleton of nothing but the ranges of two joints, whose springs are the mechanism's.
Skeleton two_ranges() {
  Skeleton skeleton;
  skeleton.limits = {{-0.5, 1, 0, 3, 0.1}, {-0.2, 0.4, 0.1, 7, 0.2}};
  return skeleton;
}

/// Two joints that stand at positions 1 and 3, and at speeds 2 and 0.
struct StoppedJoints {
  JointStops stops{"stops", two_ranges(), {{1, 3}, {2, 0}}};
  TreeModel model{};  // of no links
  TreeMotion<double> motion{model};
  VectorXd v = VectorXd::Zero(4), z = VectorXd(0);

  [[nodiscard]] static VectorXd places(double first, double second) {
    return (VectorXd(5) << 9, first, 9, second, 9).finished();
  }
  ElementAction act(const VectorXd& q, ElementNeed need = ElementNeed::kAll) {
    ElementAction out;
    out.clear(4, 0);
    EXPECT_TRUE(stops.add_action({0, 0, q, v, z, motion, 0, need}, out));
    return out;
  }
  double energy(const VectorXd& q) { return stops.energy({0, 0, q, v, z, motion, 0}); }
};

TEST(JointStops, LeaveJointsWithinTheirRangesAlone) {
  StoppedJoints joints;
  const VectorXd q = StoppedJoints::places(0.9, -0.15);
  const ElementAction out = joints.act(q);
  EXPECT_EQ(out.tau.norm(), 0);
  EXPECT_EQ(out.stiffness.norm(), 0);
  EXPECT_EQ(joints.energy(q), 0);
}

// Beyond the toe the torque is  stiffness (d - toe / 2)  back into the range, at the joint's speed.
TEST(JointStops, PushBackBeyondTheToe) {
  StoppedJoints joints;
  const JointResistance usual;
  const double d = 3 * usual.toe, torque = usual.stiffness * (d - usual.toe / 2);
  const ElementAction above = joints.act(StoppedJoints::places(1 + d, 0));
  EXPECT_NEAR(above.tau[2], -torque, 1e-12);
  EXPECT_NEAR(above.stiffness(2, 2), usual.stiffness, 1e-12);
  EXPECT_EQ(above.tau[0], 0);
  const ElementAction below = joints.act(StoppedJoints::places(0, -0.2 - d));
  EXPECT_NEAR(below.tau[0], torque, 1e-12);
  EXPECT_EQ(below.tau[2], 0);
}

// Torques are minus the slopes of the energy, stiffness that of the torques.
TEST(JointStops, TorquesAreSlopesOfTheEnergy) {
  StoppedJoints joints;
  const double step = 1e-6;
  for (const double beyond : {0.01, 0.03, 0.2}) {
    const VectorXd q = StoppedJoints::places(1 + beyond, -0.2 - beyond);
    const ElementAction at = joints.act(q);
    const int place[] = {1, 3}, speed[] = {2, 0};
    for (int joint = 0; joint < 2; ++joint) {
      const VectorXd way = step * VectorXd::Unit(5, place[joint]);
      const int s = speed[joint];
      EXPECT_NEAR(at.tau[s], -(joints.energy(q + way) - joints.energy(q - way)) / (2 * step), 1e-7);
      EXPECT_NEAR(at.stiffness(s, s),
                  -(joints.act(q + way).tau[s] - joints.act(q - way).tau[s]) / (2 * step), 1e-6);
    }
  }
}

TEST(JointStops, AClonePushesAlike) {
  StoppedJoints joints;
  const VectorXd q = StoppedJoints::places(1.1, -0.4);
  const std::unique_ptr<ForceElement> clone = joints.stops.clone();
  ElementAction out;
  out.clear(4, 0);
  ASSERT_TRUE(clone->add_action({0, 0, q, joints.v, joints.z, joints.motion, 0}, out));
  EXPECT_EQ(out.tau, joints.act(q).tau);
  EXPECT_EQ(clone->name(), "stops");
}

TEST(JointStops, RefusesPlacesOfOtherJoints) {
  EXPECT_EQ(message_of([] {
              JointStops("stops", two_ranges(), {{1, 3, 4}, {2, 0}});
            }),
            "2 joints stand at 3 positions and 2 speeds");
}

}  // namespace
}  // namespace thenar
