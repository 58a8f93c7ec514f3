// Tests for data/io/anthropometry.cpp.

#include "data/io/anthropometry.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

const std::string kTable = std::string(THENAR_DATA_DIR) + "/anthropometry/buchholz1992.toml";

const Segment& segment(const Subject& subject, const std::string& name) {
  for (const Segment& candidate : subject.segments)
    if (candidate.name == name) return candidate;
  throw InputError("no segment " + name);
}

const JointAxis& joint(const Subject& subject, const std::string& name) {
  for (const JointAxis& candidate : subject.joints)
    if (candidate.name == name) return candidate;
  throw InputError("no joint " + name);
}

class ScaledHand : public testing::Test {
 protected:
  const Subject hand_ = scale_hand(read_proportions(kTable), {0.195, 0.087});
};

// Products of the published fractions: 0.447 and 0.245 of 195 mm, 0.251 of 87 mm.
TEST_F(ScaledHand, IndexHasTheTablesProducts) {
  const Segment& bone = segment(hand_, "PP2");
  EXPECT_TRUE(matrix_near(bone.proximal, Vector3d(0.021837, -0.087165, 0), 1e-12));
  EXPECT_NEAR((bone.distal - bone.proximal).norm(), 0.047775, 1e-12);
}

// 0.143 and 0.097 of 195 mm further: the tip of a straight index finger.
TEST_F(ScaledHand, IndexTipIsTheSumOfItsBones) {
  const Digit& index = hand_.digits[1];
  EXPECT_EQ(index.name, "index");
  EXPECT_TRUE(matrix_near(index.tip, Vector3d(0.021837, -0.087165 - 0.094575, 0), 1e-12));
}

TEST_F(ScaledHand, ThumbHasTheTablesLengths) {
  const double lengths[] = {0.251, 0.196, 0.158};
  const char* const names[] = {"MC1", "PP1", "DP1"};
  for (int i = 0; i < 3; ++i) {
    const Segment& bone = segment(hand_, names[i]);
    EXPECT_NEAR((bone.distal - bone.proximal).norm(), lengths[i] * 0.195, 1e-12) << names[i];
  }
}

TEST_F(ScaledHand, FiveDigitsTwentyJoints) {
  EXPECT_EQ(hand_.digits.size(), 5U);
  EXPECT_EQ(hand_.joints.size(), 20U);
}

/// Speed of the tip as the joint turns [m/rad].
Vector3d tip_speed(const JointAxis& axis, const Vector3d& tip) {
  return axis.direction.cross(tip - axis.point);
}

TEST_F(ScaledHand, PositiveFlexionMovesTheTipPalmar) {
  for (const Digit& digit : hand_.digits)
    for (const JointAxis& axis : hand_.joints)
      if (axis.child == digit.tip_segment) {
        EXPECT_GT(tip_speed(axis, digit.tip).dot(-digit.dorsal), 0) << axis.name;
      }
}

TEST_F(ScaledHand, PositiveAbductionMovesTheTipRadially) {
  EXPECT_GT(tip_speed(joint(hand_, "MCP2_AA"), hand_.digits[1].tip).x(), 0);
  EXPECT_LT(tip_speed(joint(hand_, "CMC1_AA"), hand_.digits[0].tip).z(), 0) << "out of the palm";
}

TEST_F(ScaledHand, ThumbFlexesAcrossThePalm) {
  EXPECT_LT(tip_speed(joint(hand_, "CMC1_FE"), hand_.digits[0].tip).x(), 0);
}

TEST_F(ScaledHand, AbductionCrossesFlexionAtARightAngle) {
  const JointAxis& flexion = joint(hand_, "MCP3_FE");
  const JointAxis& abduction = joint(hand_, "MCP3_AA");
  EXPECT_NEAR(flexion.direction.dot(abduction.direction), 0, 1e-15);
  EXPECT_EQ(abduction.parent, flexion.child);
}

TEST_F(ScaledHand, RefusesNoLength) {
  try {
    (void)scale_hand({}, {0, 0.08});
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "hand length must be > 0 m, got 0");
  }
}

}  // namespace
}  // namespace thenar
