// Tests for grasp/compare/grasp_type.cpp: grasps of the table in [Feix2016], by what touches.

#include "grasp/compare/grasp_type.h"

#include <gtest/gtest.h>

#include "grasp/robot/robot_hand.h"
#include "tests/grasp/closing_samples.h"

namespace thenar {
namespace {

/// A palm and digits of two phalanges; which way they point is no matter here.
RobotSpec hand_of(const std::vector<std::string>& digits) {
  RobotSpec robot;
  robot.name = "hand";
  robot.links = {sample::phalanx("palm", "")};
  for (const std::string& digit : digits) {
    const std::string inner = digit + " proximal", outer = digit + " distal";
    robot.links.push_back(sample::phalanx(inner, digit));
    robot.links.push_back(sample::phalanx(outer, digit));
    robot.joints.push_back(sample::hinge(digit + " 1", "palm", inner, {0, 0, 0}, digit, 1));
    robot.joints.push_back(
        sample::hinge(digit + " 2", inner, outer, {sample::kLength, 0, 0}, digit, 1));
    robot.dofs.push_back(sample::motor(digit, DriveCoupling::kRigid));
  }
  return robot;
}

struct Touch {
  std::string link;
  Eigen::Vector3d push;  // into the object (3)
};

const Eigen::Vector3d kUp{0, 0, 1}, kLeft{0, 1, 0}, kRight{0, -1, 0};

std::string type_of(const std::vector<std::string>& digits, const std::vector<Touch>& touches) {
  const RobotHand hand(hand_of(digits));
  std::vector<HandContact> contacts;
  for (const Touch& touch : touches)
    for (std::size_t s = 0; s < hand.surfaces().size(); ++s) {
      if (hand.surfaces()[s].name != touch.link) continue;
      HandContact contact;
      contact.contact.n = touch.push;
      contact.surface = static_cast<int>(s);
      contacts.push_back(contact);
    }
  EXPECT_EQ(contacts.size(), touches.size());
  return grasp_type(hand, contacts);
}

std::string human(const std::vector<Touch>& touches) {
  return type_of({"thumb", "index", "middle", "ring", "little"}, touches);
}

TEST(GraspType, OfTheLargeWrapIsPowerOfThePalmWithAllDigits) {
  EXPECT_EQ(human({{"palm", kUp},
                   {"thumb distal", kLeft},
                   {"index proximal", kRight},
                   {"middle proximal", kRight},
                   {"ring distal", kRight},
                   {"little distal", kRight}}),
            "power, palm, thumb and 4 digits");
}

// The hook of a bag: fingers and palm, no thumb.
TEST(GraspType, OfTheFixedHookCountsFingersWithoutTheThumb) {
  EXPECT_EQ(human({{"palm", kUp}, {"index distal", kRight}, {"middle distal", kRight}}),
            "power, palm, 2 digits");
}

// The ring round a bottle: thumb and index by their inner links, clear of the palm.
TEST(GraspType, OfTheRingIsPowerOfPads) {
  EXPECT_EQ(human({{"thumb distal", kLeft}, {"index proximal", kRight}, {"index distal", kRight}}),
            "power, pad, thumb and 1 digit");
}

TEST(GraspType, OfTheTipPinchIsPrecisionOfOneDigit) {
  EXPECT_EQ(human({{"thumb distal", kLeft}, {"index distal", kRight}}),
            "precision, pad, thumb and 1 digit");
}

TEST(GraspType, OfTheTripodIsPrecisionOfTwoDigits) {
  EXPECT_EQ(human({{"thumb distal", kLeft}, {"index distal", kRight}, {"middle distal", kRight}}),
            "precision, pad, thumb and 2 digits");
}

// A cigarette between index and middle finger.
TEST(GraspType, OfAdductionIsOfTheSide) {
  EXPECT_EQ(human({{"index distal", kLeft}, {"middle distal", kRight}}),
            "intermediate, side, 2 digits");
}

// The key between thumb and the side of the index finger: contacts do not tell it from a pad.
TEST(GraspType, OfTheLateralPinchCountsAsPad) {
  EXPECT_EQ(human({{"thumb distal", kLeft}, {"index distal", kUp}}),
            "precision, pad, thumb and 1 digit");
}

TEST(GraspType, OfNothingOpposedSaysSo) {
  EXPECT_EQ(human({{"palm", kUp}}), "palm alone");
  EXPECT_EQ(human({{"index distal", kLeft}}), "one digit");
  EXPECT_EQ(human({{"palm", kUp}, {"thumb distal", kLeft}}), "power, palm, thumb");
}

// Both jaws count, and nothing but a palm that touches makes it power.
TEST(GraspType, OfTwoJawsIsPrecisionOfTwoDigits) {
  const std::vector<std::string> jaws{"finger 1", "finger 2"};
  const std::vector<Touch> pads{{"finger 1 distal", kLeft}, {"finger 2 distal", kRight}};
  EXPECT_EQ(type_of(jaws, pads), "precision, pad, 2 digits");
  EXPECT_EQ(type_of(jaws, {pads[0], pads[1], {"palm", kUp}}), "power, palm, 2 digits");
}

// Two fingers push one way, the third the other: that one opposes.
TEST(GraspType, WithoutAThumbTakesTheDigitThatPushesAgainstTheRest) {
  const std::vector<std::string> digits{"finger 1", "finger 2", "finger 3"};
  EXPECT_EQ(type_of(digits, {{"finger 1 distal", kLeft},
                             {"finger 2 distal", kLeft},
                             {"finger 3 distal", kRight}}),
            "precision, pad, 3 digits");
  EXPECT_EQ(type_of(digits, {{"finger 1 distal", kLeft}, {"finger 2 distal", kLeft}}),
            "intermediate, side, 2 digits");
}

}  // namespace
}  // namespace thenar
