// Tests for hand/skin/hand_anatomy.cpp.

#include "hand/skin/hand_anatomy.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "base/lists.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

// A flat hand: bones end at the joints' axes, x radial, z dorsal; radii in proportion.
TEST(HandAnatomy, FindsAFlatHand) {
  const HandAnatomy hand = find_anatomy(sample::scaled());
  ASSERT_EQ(hand.digits.size(), 5U);
  const DigitAnatomy* index = digit_named(hand, "index");
  ASSERT_NE(index, nullptr);
  EXPECT_EQ(index->root, "Palm");
  const Vector3d knuckle(0.251 * 0.085, -0.447 * 0.195, 0);
  EXPECT_TRUE(matrix_near(index->bones[0].proximal, knuckle, 1e-12));
  EXPECT_TRUE(
      matrix_near(index->bones[1].proximal, knuckle - Vector3d(0, 0.245 * 0.195, 0), 1e-12));
  EXPECT_TRUE(matrix_near(index->bones[2].dorsal, Vector3d(0, 0, 1), 1e-12));
  EXPECT_TRUE(matrix_near(index->bones[2].radial, Vector3d(1, 0, 0), 1e-12));
  EXPECT_NEAR(index->bones[1].radius, 9.30e-3 * 195 / 196, 1e-12);
  ASSERT_TRUE(hand.palm);
  EXPECT_TRUE(matrix_near(hand.palm->dorsal, Vector3d(0, 0, 1), 1e-12));
  EXPECT_NEAR(hand.palm->thickness, 0.085 * 24 / 68, 1e-12);
  EXPECT_EQ(hand.warnings.size(), 1U);  // breadths are in proportion
}

// A digitised hand: landmarks lie on its back, joints' centres on the axes that were measured.
TEST(HandAnatomy, FindsCentresOnMeasuredAxes) {
  const Subject subject = sample::subject("mirakhorlo2016");
  const HandAnatomy hand = find_anatomy(subject);
  EXPECT_TRUE(hand.warnings.empty());
  int checked = 0;
  for (const char* name : {"PIP2", "PIP3", "PIP4", "PIP5", "DIP2", "DIP3", "DIP4", "DIP5", "IP1"})
    for (const JointAxis& joint : subject.joints)
      if (joint.name == name)
        for (const DigitAnatomy& digit : hand.digits)
          for (const DigitBone& bone : digit.bones)
            if (bone.segment == joint.child) {
              const Vector3d from = bone.proximal - joint.point;
              EXPECT_LT(from.cross(joint.direction).norm(), 1e-9) << name;
              ++checked;
            }
  EXPECT_EQ(checked, 9);
}

// Mirrored at x = 0 it is a left hand: dorsal stays dorsal, radial turns round.
TEST(HandAnatomy, FindsLeftHands) {
  Subject left = sample::scaled();
  const auto mirror = [](Vector3d& v) { v.x() = -v.x(); };
  for (Segment& segment : left.segments) mirror(segment.proximal), mirror(segment.distal);
  for (JointAxis& joint : left.joints) mirror(joint.point), mirror(joint.direction);
  for (Digit& digit : left.digits)
    mirror(digit.tip), mirror(digit.proximal), mirror(digit.dorsal), mirror(digit.radial);
  const HandAnatomy hand = find_anatomy(left);
  for (const DigitAnatomy& digit : hand.digits)
    if (digit.name != "thumb") {
      EXPECT_TRUE(matrix_near(digit.bones[1].dorsal, Vector3d(0, 0, 1), 1e-12)) << digit.name;
    }
  const PalmAnatomy palm = *find_anatomy(sample::scaled()).palm;
  EXPECT_TRUE(matrix_near(hand.palm->dorsal, palm.dorsal, 1e-12));
  EXPECT_TRUE(matrix_near(hand.palm->radial, palm.radial.cwiseProduct(Vector3d(-1, 1, 1)), 1e-12));
}

TEST(HandAnatomy, TakesDigitsAlone) {
  for (const char* name : {"an_chao_index", "arms_thumb", "synek2019_middle"}) {
    const HandAnatomy hand = find_anatomy(sample::subject(name));
    EXPECT_EQ(hand.digits.size(), 1U) << name;
    EXPECT_FALSE(hand.palm) << name;
    EXPECT_GT(hand.length, 0.14) << name;
    EXPECT_LT(hand.length, 0.22) << name;
  }
}

TEST(HandAnatomy, RefusesWhatHasNoFlesh) {
  EXPECT_EQ(message_of([] { (void)find_anatomy(sample::subject("valero_cuevas_index")); }),
            "subject 'valero_cuevas_index' has no digit to lay skin on");
}

// A finger whose base has a length, as a metacarpal that stays fixed, and two bones beyond: the
// base is no bone of the finger.
TEST(HandAnatomy, CountsNoBaseAmongTheBonesOfADigit) {
  Subject two = sample::subject("an_chao_middle");
  // The base takes the place and the joint of the proximal phalanx.
  const Segment phalanx = *find_named(two.segments, "PP3");
  for (Segment& segment : two.segments)
    if (segment.name == two.base)
      segment.proximal = phalanx.proximal, segment.distal = phalanx.distal;
  for (JointAxis& joint : two.joints)
    if (joint.parent == "PP3") joint.parent = two.base;
  EXPECT_EQ(message_of([&] { (void)find_anatomy(two); }),
            "digit 'middle' of '" + two.name + "' has 2 bones to its tip; a skin wants 3");
}

// The thumb of human_hand touches with its pad, 0.4 of the last bone before its end: skin reaches
// the end as in the specimen, whose tip is the end.
TEST(HandAnatomy, EndsADigitBeyondATipWithinItsPad) {
  const HandAnatomy hand = find_anatomy(sample::subject("human_hand"));
  const HandAnatomy specimen = find_anatomy(sample::subject("mirakhorlo2016"));
  EXPECT_EQ(digit_named(hand, "thumb")->bones.back().distal,
            digit_named(specimen, "thumb")->bones.back().distal);
}

}  // namespace
}  // namespace thenar
