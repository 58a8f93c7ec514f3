// Tests for data/io/subject_passive.cpp.

#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/subject.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

const std::string kTwoJoints = R"(name = "two"
side = "right"
base = "MC2"
source = "An1983"
[[segment]]
name = "MC2"
[[segment]]
name = "PP2"
[[segment]]
name = "MP2"
[[joint]]
name = "MCP2"
parent = "MC2"
child = "PP2"
direction = [0, 0, 1]
point_mm = [20, 0, 0]
[[joint]]
name = "PIP2"
parent = "PP2"
child = "MP2"
direction = [0, 0, 1]
point_mm = [60, 0, 0]
)";

Subject with_table(const std::string& table) {
  return parse_subject(kTwoJoints + "[[passive]]\n" + table, "two.toml");
}

TEST(SubjectPassive, GivesAllItsJointsOneLaw) {
  const Subject subject = with_table(R"(joints = ["MCP2", "PIP2"]
rest_deg = [30, 20]
stiffness_Nmm_per_rad = 40
flexing = {moment_Nmm = 20, width_deg = 18}
extending = {moment_Nm = 0.01, width_rad = 0.2}
spread = 0.5
)");
  for (const JointAxis& joint : subject.joints) {
    EXPECT_DOUBLE_EQ(joint.stiffness, 0.04);
    EXPECT_DOUBLE_EQ(joint.flexing.moment, 0.02);
    EXPECT_DOUBLE_EQ(joint.flexing.width, 18 * kDegree);
    EXPECT_DOUBLE_EQ(joint.extending.moment, 0.01);
    EXPECT_DOUBLE_EQ(joint.extending.width, 0.2);
    EXPECT_DOUBLE_EQ(joint.passive_spread, 0.5);
  }
  EXPECT_DOUBLE_EQ(subject.joints[0].rest, 30 * kDegree);
  EXPECT_DOUBLE_EQ(subject.joints[1].rest, 20 * kDegree);
}

TEST(SubjectPassive, RefusesWhatIsNoLaw) {
  const auto refusal = [](const std::string& table) {
    return message_of<DataError>([&] { (void)with_table(table); });
  };
  EXPECT_EQ(refusal("joints = [\"MCP2\"]\nrest_deg = [3]\n"),
            "two.toml:23: wanted 'stiffness', 'flexing' or 'extending' above 0");
  EXPECT_EQ(refusal("joints = [\"MCP2\", \"MCP2\"]\nrest_deg = [3, 3]\nstiffness_Nm_per_rad = 1\n"),
            "two.toml:24: joint 'MCP2' has a passive moment already");
}

TEST(SubjectPassive, IsLeftOutOnRequest) {
  const Subject subject =
      with_table("joints = [\"MCP2\"]\nrest_deg = [3]\nstiffness_Nm_per_rad = 1\n");
  EXPECT_TRUE(has_passive(with_passive(subject, PassiveMoments::kOn).joints[0]));
  EXPECT_FALSE(has_passive(with_passive(subject, PassiveMoments::kOff).joints[0]));
  EXPECT_EQ(message_of([] { (void)passive_named("of"); }),
            "no switch of passive moments 'of', did you mean 'off'? there are on, off");
}

}  // namespace
}  // namespace thenar
