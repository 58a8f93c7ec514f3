// Tests for data/io/subject_doubts.cpp: numbers of another unit are doubted, those of hands are
// not.

#include "data/io/subject_doubts.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Subject hand() { return read_subject(std::string(kData) + "/subjects/human_hand.toml"); }

Digit& digit(Subject& subject, const std::string& name) {
  for (Digit& each : subject.digits)
    if (each.name == name) return each;
  throw std::out_of_range(name);
}

TEST(SubjectDoubts, AreNoneOfShippedSubjects) {
  for (const auto& file : std::filesystem::directory_iterator(std::string(kData) + "/subjects"))
    if (file.path().extension() == ".toml") {
      EXPECT_THAT(subject_doubts(read_subject(file.path().string())), IsEmpty()) << file.path();
    }
}

// Metres read as millimetres, and millimetres read as metres.
TEST(SubjectDoubts, AreOfLengthsOfAnotherUnit) {
  for (const double factor : {1e-3, 1e3}) {
    Subject subject = hand();
    subject.strands.clear();
    for (JointAxis& joint : subject.joints) joint.point *= factor;
    for (Digit& each : subject.digits) each.tip *= factor;
    EXPECT_EQ(subject_doubts(subject).size(), subject.digits.size()) << factor;
  }
  Subject arms = hand();
  Strand strand{"S", {}, {{"MCP2_FE", 8e-6}, {"PIP2", -5e-6}}};
  arms.strands.push_back(strand);
  EXPECT_THAT(subject_doubts(arms),
              ElementsAre("the longest moment arm of strand 'S' is 0.008 mm: are its numbers "
                          "millimetres, as they are read?"));
  arms.strands.back().arms["PIP2"] = -5;
  EXPECT_EQ(subject_doubts(arms).size(), 1U);
  arms.strands.back().arms["PIP2"] = -5e-3;
  EXPECT_THAT(subject_doubts(arms), IsEmpty());
}

// 1.6 rad read as 1.6 degrees.
TEST(SubjectDoubts, AreOfLimitsInRadians) {
  Subject subject = hand();
  for (JointAxis& joint : subject.joints)
    if (joint.name == "PIP2") joint.lower = 0, joint.upper = 1.6 * kDegree;
  EXPECT_THAT(
      subject_doubts(subject),
      ElementsAre("joint 'PIP2' turns by 1.6 degrees alone: are its limits degrees, as they "
                  "are read?"));
}

// A wrist that is held at 1.5 degrees either way is no mistake; all joints like that are.
TEST(SubjectDoubts, AreNoneOfOneJointThatIsHeld) {
  Subject subject = hand();
  for (JointAxis& joint : subject.joints)
    if (joint.name == "WRIST_FE") joint.lower = -1.5 * kDegree, joint.upper = 1.5 * kDegree;
  EXPECT_THAT(subject_doubts(subject), IsEmpty());
  for (JointAxis& joint : subject.joints) joint.lower = -1.5 * kDegree, joint.upper = -joint.lower;
  EXPECT_THAT(subject_doubts(subject),
              ElementsAre(AllOf(HasSubstr("turns by 3 degrees alone"), HasSubstr("more joints"))));
}

// -30 .. 95 degrees read as radians.
TEST(SubjectDoubts, AreOfLimitsInDegreesReadAsRadians) {
  Subject subject = hand();
  for (JointAxis& joint : subject.joints)
    if (joint.name == "PIP2") joint.lower = -30, joint.upper = 95;
  EXPECT_THAT(
      subject_doubts(subject),
      ElementsAre("joint 'PIP2' turns from -1719 to 5443 degrees: are its limits of the unit "
                  "that its key names?"));
}

// Path points, tips and constant arms in centimetres or metres under keys of millimetres.
TEST(SubjectDoubts, AreOfPathsAndTipsOfAnotherUnitThanTheAxes) {
  for (const double factor : {1e-3, 0.1, 10.0}) {
    Subject paths = hand(), tip = hand();
    for (Strand& strand : paths.strands)
      for (PathPoint& point : strand.path) point.p *= factor;
    EXPECT_THAT(subject_doubts(paths), ElementsAre(HasSubstr("more strands are alike"))) << factor;
    digit(tip, "index").tip *= factor;
    EXPECT_THAT(subject_doubts(tip), ElementsAre(HasSubstr("the tip of digit 'index' is")))
        << factor;
  }
  Subject arms = hand();
  arms.strands = {{"S", {}, {{"MCP2_FE", 1.2e-3}, {"PIP2", 0.7e-3}}}};
  EXPECT_THAT(subject_doubts(arms),
              ElementsAre(HasSubstr("the longest moment arm of all strands is 1.2 mm")));
}

TEST(SubjectDoubts, AreOfMassesOfAnotherUnit) {
  Subject heavy = hand(), light = hand();
  for (Segment& segment : heavy.segments)
    if (segment.name == "PP2") segment.mass = 20;
  EXPECT_THAT(subject_doubts(heavy), ElementsAre("segment 'PP2' weighs 2e+04 g: is its mass of the "
                                                 "unit that its key names?"));
  for (Segment& segment : light.segments) segment.mass *= 1e-3;
  EXPECT_THAT(subject_doubts(light),
              ElementsAre("the heaviest segment that moves, 'Palm', weighs 0.332 g: are masses of "
                          "the unit that their keys name?"));
}

TEST(SubjectDoubts, AreOfForcesBelowAnyMuscle) {
  Subject subject = hand();
  subject.muscles.front().max_force = 0.1;
  EXPECT_THAT(subject_doubts(subject), ElementsAre(HasSubstr("pulls with up to 0.1 N")));
  subject.muscles.front().max_force = 0;  // a muscle that cannot pull
  EXPECT_THAT(subject_doubts(subject), IsEmpty());
}

TEST(SubjectDoubts, AreOfBonesAndFibresOfAnotherUnit) {
  Subject bones = hand(), skin = hand(), fibres = hand(), pennation = hand();
  for (Segment& segment : bones.segments)
    for (Eigen::Vector3d* p : {&segment.proximal, &segment.distal, &segment.com}) *p *= 0.1;
  EXPECT_THAT(subject_doubts(bones), ElementsAre(HasSubstr("more segments are alike")));
  for (Segment& segment : skin.segments) segment.radius *= 0.01;
  EXPECT_THAT(subject_doubts(skin), ElementsAre(HasSubstr("a radius of")));
  fibres.muscles.front().fibre_length = 60;
  EXPECT_THAT(subject_doubts(fibres), ElementsAre(HasSubstr("has fibres of 6e+04 mm")));
  for (MuscleUnit& muscle : pennation.muscles) muscle.pennation = 0.1 * kDegree;
  EXPECT_THAT(subject_doubts(pennation), ElementsAre(HasSubstr("pennations are from 0.1 to 0.1")));
}

TEST(SubjectDoubts, AreOfForcesBeyondAnyHand) {
  Subject subject = hand();
  subject.muscles.front().max_force = 2e5;
  ASSERT_EQ(subject_doubts(subject).size(), 1U);
  EXPECT_EQ(subject_doubts(subject).front(), "muscle '" + subject.muscles.front().name +
                                                 "' pulls with up to 2e+05 N: are these newtons?");
}

TEST(SubjectDoubts, MeasureADigitFromItsFurthestAxis) {
  Subject subject = hand();
  digit(subject, "index").tip += Eigen::Vector3d(0, -0.7, 0);
  ASSERT_EQ(subject_doubts(subject).size(), 1U);
  EXPECT_NE(subject_doubts(subject).front().find("the tip of digit 'index' is"), std::string::npos);
}

}  // namespace
}  // namespace thenar
