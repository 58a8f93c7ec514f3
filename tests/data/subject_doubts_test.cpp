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

using testing::ElementsAre;
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
