// Tests for grasp/closing/close_hand.cpp: where capsules meet bodies, worked out by hand.

#include "grasp/closing/close_hand.h"

#include <cmath>

#include <gmock/gmock.h>

#include "grasp/robot/robot_hand.h"
#include "tests/grasp/closing_samples.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using sample::kLength;
using sample::kRadius;
using testing::HasSubstr;

constexpr double kClosingAccuracy = 1e-4;  // default of CloseOptions [m]

ClosedHand close(const RobotSpec& robot, const GraspSetup& setup,
                 const CloseOptions& options = {}) {
  const RobotHand hand(robot);
  return close_hand(collision_hand(hand), {}, Eigen::VectorXd::Zero(hand.layout().lower.size()),
                    setup, options);
}

const ShapeSpec kBall = sample::shape(ShapeKind::kSphere, {0.01, 0, 0});
const GraspSetup kFar = sample::setup({sample::placed("ball", kBall, {0, 0, 1})});

// The capsule is tangent to the ball where the angle from its axis to the ball's centre, as seen
// from the knuckle, has the sine (R + r) / D.
TEST(CloseHand, StopsAPhalanxWhereItTouchesABall) {
  const Eigen::Vector3d centre(0.025, 0.02, 0);
  const ClosedHand closed = close(sample::finger(DriveCoupling::kRigid),
                                  sample::setup({sample::placed("ball", kBall, centre)}));
  const double D = centre.norm();
  const double tangent = std::atan2(centre.y(), centre.x()) - std::asin((0.01 + kRadius) / D);
  ASSERT_TRUE(closed.finished);
  // The gap is within (0, accuracy]; it closes by D cos(...) per angle.
  const double slope = D * std::cos(std::asin((0.01 + kRadius) / D));
  EXPECT_LT(closed.q[0], tangent);
  EXPECT_GT(closed.q[0], tangent - 1.01 * kClosingAccuracy / slope);
  EXPECT_EQ(closed.stopped[0], StoppedBy::kContact);
}

TEST(CloseHand, RunsToItsLimitsWhereNothingIsInTheWay) {
  const ClosedHand closed = close(sample::finger(DriveCoupling::kBreakaway), kFar);
  ASSERT_TRUE(closed.finished);
  EXPECT_DOUBLE_EQ(closed.q[0], kPi / 2);
  EXPECT_DOUBLE_EQ(closed.q[1], kPi / 4);
  EXPECT_EQ(closed.stopped[0], StoppedBy::kLimit);
}

// A ball under the proximal phalanx: behind a clutch the distal one goes on to its self_overlaps
// limit.
TEST(CloseHand, LetsTheOuterLinkGoOnBehindAClutch) {
  const GraspSetup ball = sample::setup({sample::placed("ball", kBall, {0.025, 0.02, 0})});
  const ClosedHand rigid = close(sample::finger(DriveCoupling::kRigid), ball);
  const ClosedHand clutch = close(sample::finger(DriveCoupling::kBreakaway), ball);
  ASSERT_EQ(rigid.q.size(), 1);
  ASSERT_EQ(clutch.q.size(), 2);
  EXPECT_NEAR(clutch.q[0], rigid.q[0], 1e-2);
  EXPECT_GT(clutch.q[1], clutch.q[0]);
  EXPECT_EQ(clutch.stopped[0], StoppedBy::kContact);
}

// A distal link that touches stops the proximal one too, clutch or not: it would be pushed in.
TEST(CloseHand, StopsAllThatMoveALinkThatTouches) {
  const GraspSetup ball = sample::setup({sample::placed("ball", kBall, {0.085, 0.03, 0})});
  const ClosedHand closed = close(sample::finger(DriveCoupling::kBreakaway), ball);
  EXPECT_EQ(closed.stopped[0], StoppedBy::kContact);
  EXPECT_EQ(closed.stopped[1], StoppedBy::kContact);
  EXPECT_DOUBLE_EQ(closed.q[1], closed.q[0] / 2);
}

// The fingers are mirror images: their axes lean by a with  gap / 2 - L sin a = r  at the tips'
// centres, where capsules of radius r meet.
TEST(CloseHand, StopsFingersOnEachOther) {
  const double gap = 0.06;
  const ClosedHand closed = close(sample::pincer(gap), kFar);
  ASSERT_TRUE(closed.finished);
  const double lean = std::asin((gap / 2 - kRadius) / kLength);
  EXPECT_NEAR(closed.q[0], lean, 2 * kClosingAccuracy / kLength);
  EXPECT_LT(closed.q[0], lean);
  EXPECT_NEAR(closed.q[1], closed.q[0], 1e-12);
}

/// The pincer in skin; `speed` of its right finger, whose left one has 1.
RobotSpec skin_pincer(double gap, double speed) {
  RobotSpec robot = sample::pincer(gap);
  for (RobotLink& link : robot.links) link.material = "skin";
  robot.dofs[1].speed = speed;
  return robot;
}

// Their layers of 3 mm are pressed flat:  gap / 2 - L sin a = r - 3 mm;  they go into each other
// with cos a = 0.87 of their speed, which the friction of skin (0.74) does not let slide.
TEST(CloseHand, PressesSoftLayersFlat) {
  const ClosedHand closed = close(skin_pincer(0.06, 1), kFar);
  ASSERT_TRUE(closed.finished);
  const double lean = std::asin((0.03 - kRadius + 0.003) / kLength);
  EXPECT_EQ(closed.stopped[0], StoppedBy::kContact);
  EXPECT_NEAR(closed.q[0], lean, 2 * kClosingAccuracy / kLength);
  EXPECT_LT(closed.q[0], lean);
}

// Against a finger that stands, the tip meets its side at  gap - L sin a = 2 r - 6 mm.  At 28 mm
// cos a is 0.93, at 46 mm 0.69: there the finger slides on to its limit of 0.9 rad, as hard ones do
// not.
TEST(CloseHand, LetsSoftLinksSlideOutsideTheConeOfFriction) {
  const ClosedHand sticks = close(skin_pincer(0.028, 0), kFar);
  EXPECT_EQ(sticks.stopped[0], StoppedBy::kContact);
  EXPECT_NEAR(sticks.q[0], std::asin((0.028 - 2 * kRadius + 0.006) / kLength), 2e-3 / kLength);
  RobotSpec oblique = skin_pincer(0.046, 0);
  oblique.joints[0].upper = oblique.dofs[0].upper = 0.9;
  EXPECT_EQ(close(oblique, kFar).stopped[0], StoppedBy::kLimit);
  for (RobotLink& link : oblique.links) link.material = "rubber";
  EXPECT_EQ(close(oblique, kFar).stopped[0], StoppedBy::kContact);
}

// Crossed from the start, by 2 r - gap.
TEST(CloseHand, ListsLinksInEachOtherAtTheStart) {
  const ClosedHand closed = close(sample::pincer(0.01), kFar);
  ASSERT_EQ(closed.self_overlaps.size(), 1u);
  EXPECT_EQ(closed.self_overlaps[0].surface, "right");
  EXPECT_EQ(closed.self_overlaps[0].other, "left");
  EXPECT_NEAR(closed.self_overlaps[0].depth, 2 * kRadius - 0.01, kClosingAccuracy);
  EXPECT_EQ(closed.stopped[0], StoppedBy::kLimit);
  EXPECT_TRUE(close(sample::pincer(0.06), kFar).self_overlaps.empty());
}

TEST(CloseHand, PassesThroughItselfIfToldSo) {
  CloseOptions options;
  options.self = false;
  EXPECT_DOUBLE_EQ(close(sample::pincer(0.06), kFar, options).q[0], kPi / 2);
}

TEST(CloseHand, DoesNotPassAPaperThinPlate) {
  const ShapeSpec plate = sample::shape(ShapeKind::kBox, {0.1, 1e-5, 0.1});
  const ClosedHand closed = close(sample::finger(DriveCoupling::kRigid),
                                  sample::setup({sample::placed("plate", plate, {0.09, 0.02, 0})}));
  EXPECT_EQ(closed.stopped[0], StoppedBy::kContact);
  EXPECT_LT(closed.q[0], 0.3);
}

TEST(CloseHand, TellsWhatOverlapsAtTheStartAndDoesNotMove) {
  const ClosedHand closed = close(sample::finger(DriveCoupling::kRigid),
                                  sample::setup({sample::placed("ball", kBall, {0.02, 0.01, 0})}));
  ASSERT_EQ(closed.overlaps.size(), 1u);
  EXPECT_EQ(closed.overlaps[0].surface, "proximal");
  EXPECT_EQ(closed.overlaps[0].other, "ball");
  EXPECT_NEAR(closed.overlaps[0].depth, 0.008, kClosingAccuracy);  // r + R - 10 mm
  EXPECT_FALSE(closed.finished);
  EXPECT_EQ(closed.q[0], 0);
}

TEST(OpenPosture, IsTheLimitThatClosingComesFrom) {
  HandLayout layout;
  layout.coordinates = {"closes up", "closes down", "stays", "stays beyond"};
  layout.lower = Eigen::Vector4d(-1, -1, -1, 1);
  layout.upper = Eigen::Vector4d(2, 2, 2, 2);
  layout.drives = {{"a", DriveCoupling::kRigid, {{0, 1}, {1, -1}}, 1, 0},
                   {"b", DriveCoupling::kRigid, {{2, 1}, {3, 1}}, 0, 0}};
  EXPECT_EQ(open_posture(layout), Eigen::Vector4d(-1, 2, 0, 1));
}

TEST(CloseHand, RefusesPosturesOutOfRange) {
  const RobotHand hand(sample::finger(DriveCoupling::kRigid));
  EXPECT_THAT(message_of([&] {
                (void)close_hand(collision_hand(hand), {}, Eigen::VectorXd::Constant(1, 7), kFar);
              }),
              HasSubstr("starts at 7"));
  const double nan = std::nan("");
  EXPECT_THAT(message_of([&] {
                (void)close_hand(collision_hand(hand), {}, Eigen::VectorXd::Constant(1, nan), kFar);
              }),
              HasSubstr("starts at nan"));
}

}  // namespace
}  // namespace thenar
