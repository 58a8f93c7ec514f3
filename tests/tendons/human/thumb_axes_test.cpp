// Tests for tendons/human/thumb_axes.cpp.

#include "tendons/human/thumb_axes.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "base/error.h"
#include "hand/skin/hand_anatomy.h"
#include "tests/hand/skin/human_subjects.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const JointAxis& named_joint(const Subject& subject, const std::string& name) {
  for (const JointAxis& joint : subject.joints)
    if (joint.name == name) return joint;
  throw InputError("no joint " + name);
}

TEST(OrthogonalThumb, CrossesItsAxesAtRightAngles) {
  for (const char* name : {"mirakhorlo2016", "arms_thumb", "graspit_skewed_thumb"}) {
    const Subject simple = orthogonal_thumb(sample::subject(name));
    const JointAxis &flexion = named_joint(simple, "CMC1_FE"),
                    &abduction = named_joint(simple, "CMC1_AA");
    EXPECT_NEAR(flexion.direction.dot(abduction.direction), 0, 1e-12) << name;
    EXPECT_EQ(flexion.point, abduction.point) << name;
  }
}

TEST(OrthogonalThumb, TurnsAcrossItsBones) {
  const Subject given = sample::subject("mirakhorlo2016");
  const Subject simple = orthogonal_thumb(given);
  const HandAnatomy hand = find_anatomy(given);
  const DigitAnatomy* thumb = digit_named(hand, "thumb");
  for (const auto& [name, bone] : {std::pair("MCP1_FE", 1), {"IP1", 2}}) {
    const DigitBone& after = thumb->bones[bone];
    const JointAxis& joint = named_joint(simple, name);
    EXPECT_NEAR(joint.direction.dot((after.distal - after.proximal).normalized()), 0, 1e-12);
    EXPECT_EQ(joint.point, after.proximal);
    EXPECT_GT(joint.direction.dot(named_joint(given, name).direction), 0) << "turns the other way";
  }
}

TEST(OrthogonalThumb, LeavesAllElseAlone) {
  const Subject given = sample::subject("mirakhorlo2016"), simple = orthogonal_thumb(given);
  for (std::size_t i = 0; i < given.joints.size(); ++i) {
    const JointAxis &before = given.joints[i], &after = simple.joints[i];
    const bool thumb = before.name.find('1') != std::string::npos;
    EXPECT_EQ(before.direction != after.direction, thumb) << before.name;
    EXPECT_EQ(before.lower, after.lower);
    EXPECT_EQ(before.upper, after.upper);
  }
  for (std::size_t i = 0; i < given.segments.size(); ++i)
    EXPECT_EQ(given.segments[i].distal, simple.segments[i].distal);
}

// A thumb that is orthogonal already stays as it is.
TEST(OrthogonalThumb, ChangesNothingInASimpleHand) {
  const Subject given = sample::scaled(), simple = orthogonal_thumb(given);
  for (std::size_t i = 0; i < given.joints.size(); ++i) {
    EXPECT_TRUE(matrix_near(simple.joints[i].direction, given.joints[i].direction, 1e-12));
    EXPECT_TRUE(matrix_near(simple.joints[i].point, given.joints[i].point, 1e-12));
  }
}

TEST(OrthogonalThumb, WantsAThumb) {
  EXPECT_EQ(message_of([] { (void)orthogonal_thumb(sample::subject("an_chao_index")); }),
            "subject 'an_chao_index' has no thumb");
}

}  // namespace
}  // namespace thenar
