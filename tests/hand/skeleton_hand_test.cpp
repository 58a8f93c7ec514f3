// The laws of Hand for hand/skeleton_hand.cpp, and what is its own.

#include "tests/hand/hand_laws.h"

#include "base/error.h"
#include "hand/skeleton_hand.h"

namespace thenar {
namespace {

SkeletonHand motor_hand(const Subject& subject) {
  const Skeleton skeleton = build_skeleton(subject);
  const Eigen::VectorXd limit = Eigen::VectorXd::Constant(skeleton.coordinates(), 0.5);  // [N m]
  return {skeleton, {-limit, limit}};
}

TEST(HandLaws, HoldForSkeletonHands) {
  expect_hand_laws(motor_hand(sample::random_hand(71)), 72);
  expect_hand_laws(motor_hand(sample::coupled_digit()), 73);
  expect_hand_laws(motor_hand(sample::two_link()), 74);
}

TEST(SkeletonHand, MakesEachTorqueByItself) {
  const SkeletonHand hand = motor_hand(sample::coupled_digit());
  const Eigen::Vector3d q(0.1, 0.2, 0.3);
  const Actuation actuation = hand.actuation(q);
  EXPECT_TRUE(actuation.B.isIdentity(0));
  EXPECT_EQ(actuation.tau_0, passive_torque(build_skeleton(sample::coupled_digit()), q));
  EXPECT_EQ(hand.layout().actuators, hand.layout().coordinates);
  EXPECT_EQ(hand.layout().tips, std::vector<std::string>{"index"});
}

TEST(SkeletonHand, RejectsCrossedLimits) {
  const Skeleton skeleton = build_skeleton(sample::two_link());
  try {
    (void)SkeletonHand(skeleton, {Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 0)});
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "torque limits of joint 'J2' cross: 1 .. 0 N m");
  }
  EXPECT_THROW((void)SkeletonHand(skeleton, {Eigen::Vector2d(0, 1), Eigen::Vector3d(1, 1, 1)}),
               InputError);
}

}  // namespace
}  // namespace thenar
