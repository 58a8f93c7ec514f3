// Tests for data/io/scene/scene_compliance.cpp.

#include "data/io/scene/scene_compliance.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "data/io/scene/scene.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::StartsWith;

// [[compliance]] stands on line 14.
const std::string kHead = R"(name = "lid"
source = "Mine"
[sources]
Mine = "Own"
[[body]]
name = "lid"
mass_g = 100
joint = {kind = "hinge", axis = [0, 0, 1], point_mm = [0, 0, 0]}
[[body.shape]]
kind = "sphere"
size_mm = [10]
[stepping]
duration_s = 1
[[compliance]]
)";
const std::string kAll = R"(joint = "lid"
translation_N_per_mm = [50, 60, 70]
rotation_Nm_per_rad = [4, 2]
)";

SceneComplianceSpec compliance_of(const std::string& text) {
  return parse_scene(kHead + text, "s.toml").compliances.at(0);
}
std::string complaint(const std::string& text) {
  return message_of<DataError>([&] { (void)compliance_of(text); });
}

TEST(SceneCompliance, IsReadInSi) {
  const SceneComplianceSpec read = compliance_of(
      kAll +
      "translation_damping_Ns_per_m = 30\nrotation_damping_Nmms_per_rad = 5\n"
      "translation_toe_mm = 0.3\nrotation_toe_deg = 10\nstiffening = 8\ntwist_follows = 0.2\n"
      "bone = [0, 0, 2]\n");
  EXPECT_EQ(read.joint, "lid");
  EXPECT_EQ(read.stiffness, (std::array<double, 5>{50e3, 60e3, 70e3, 4, 2}));
  EXPECT_EQ(read.damping, (std::array<double, 5>{30, 30, 30, 5e-3, 5e-3}));
  EXPECT_DOUBLE_EQ(read.translation_toe, 3e-4);
  EXPECT_DOUBLE_EQ(read.rotation_toe, 10 * kDegree);
  EXPECT_DOUBLE_EQ(read.twist_toe, 10 * kDegree);
  EXPECT_EQ(read.stiffening, 8);
  EXPECT_EQ(read.twist_follows, 0.2);
  EXPECT_EQ(read.bone->z(), 1);
  EXPECT_EQ(read.line, 14);
}

TEST(SceneCompliance, TwistMayHaveAToeOfItsOwn) {
  const SceneComplianceSpec both =
      compliance_of(kAll + "rotation_toe_rad = 0.1\ntwist_toe_rad = 0.15\n");
  EXPECT_EQ(both.rotation_toe, 0.1);
  EXPECT_EQ(both.twist_toe, 0.15);
  // It is a toe like others: springs stiffen with it.
  const SceneComplianceSpec alone = compliance_of(kAll + "twist_toe_rad = 0.15\nstiffening = 8\n");
  EXPECT_TRUE(std::isinf(alone.rotation_toe));
  EXPECT_EQ(alone.stiffening, 8);
  EXPECT_THAT(complaint("joint = \"lid\"\nways = [\"abduction\"]\nrotation_Nm_per_rad = [4, 2]\n"
                        "twist_toe_rad = 0.1\n"),
              StartsWith("s.toml:18: a twist that is rigid has no toe"));
}

TEST(SceneCompliance, HoldsRigidWhatDoesNotGive) {
  const double rigid = std::numeric_limits<double>::infinity();
  const SceneComplianceSpec read =
      compliance_of("joint = \"lid\"\nways = [\"twist\"]\nrotation_Nm_per_rad = [4, 2]\n");
  EXPECT_EQ(read.stiffness, (std::array<double, 5>{rigid, rigid, rigid, rigid, 2}));
  EXPECT_FALSE(read.bone.has_value());
}

TEST(SceneCompliance, MistakesAreToldWithTheirLines) {
  EXPECT_THAT(complaint("joint = \"lid\"\n"), StartsWith("s.toml:14: "));
  EXPECT_THAT(complaint("joint = \"lit\"\n" + kAll.substr(14)),
              StartsWith("s.toml:14: there is no body or hand 'lit', did you mean 'lid'?"));
  EXPECT_THAT(complaint(kAll + "stiffening = 0.5\n"),
              StartsWith("s.toml:18: wanted 'stiffening' from 1 up, got 0.5"));
  // Without a toe nothing stiffens.
  EXPECT_THAT(complaint(kAll + "stiffening = 8\n"),
              StartsWith("s.toml:18: springs without a toe are straight"));
  EXPECT_EQ(compliance_of(kAll + "translation_toe_mm = 1\nstiffening = 8\n").stiffening, 8);
  EXPECT_THAT(complaint(kAll + "ways = [\"twst\"]\n"),
              StartsWith("s.toml:18: there is no way 'twst', did you mean 'twist'?"));
  EXPECT_THAT(complaint(kAll + "ways = [\"twist\"]\n"),
              StartsWith("s.toml:16: none of its ways gives"));
  EXPECT_THAT(complaint("joint = \"lid\"\nways = [\"abduction\"]\nrotation_Nm_per_rad = [4, 2]\n"
                        "twist_follows = 1\n"),
              StartsWith("s.toml:18: a twist that is rigid follows nothing"));
  EXPECT_THAT(complaint(kAll + "[[compliance]]\n" + kAll),
              StartsWith("s.toml:18: the compliance of 'lid' is given twice"));
  EXPECT_THAT(complaint("joint = \"lid\"\ntranslation_N_per_mm = [50, 0, 70]\n"
                        "rotation_Nm_per_rad = [4, 2]\n"),
              StartsWith("s.toml:16: "));
}

const std::string kLigament = R"(stiffness_N = 300
from_point_mm = [0, 0, 10]
to_point_mm = [1, 2, 3]
)";

SceneLigamentSpec ligament_of(const std::string& text) {
  std::string head = kHead;
  head.replace(head.find("[[compliance]]"), 14, "[[ligament]]");
  return parse_scene(head + text, "s.toml").ligaments.at(0);
}

TEST(SceneLigament, IsReadInSi) {
  const SceneLigamentSpec read = ligament_of(
      "to = \"lid\"\nname = \"cord\"\ntoe_strain = 0.05\n"
      "damping_ms = 2\nslack_length_mm = 9\n" +
      kLigament);
  EXPECT_EQ(read.name, "cord");
  EXPECT_EQ(read.from, "");
  EXPECT_EQ(read.to, "lid");
  EXPECT_EQ(read.to_point, Eigen::Vector3d(1e-3, 2e-3, 3e-3));
  EXPECT_EQ(read.from_point.z(), 0.01);
  EXPECT_EQ(read.stiffness, 300);
  EXPECT_EQ(read.toe_strain, 0.05);
  EXPECT_DOUBLE_EQ(read.damping, 2e-3);
  EXPECT_DOUBLE_EQ(read.slack_length.value(), 9e-3);
}

TEST(SceneLigament, MistakesAreToldWithTheirLines) {
  const auto told = [](const std::string& text) {
    return message_of<DataError>([&] { (void)ligament_of(text + kLigament); });
  };
  EXPECT_THAT(told("to = \"led\"\n"), StartsWith("s.toml:14: there is no body or hand 'led'"));
  EXPECT_THAT(told("to = \"lid\"\nfrom = \"lid\"\n"),
              StartsWith("s.toml:15: 'lid' cannot be tied to itself"));
  EXPECT_THAT(told("to = \"lid\"\nslack_length_mm = 0\n"), StartsWith("s.toml:16: "));
}

SceneBushingSpec bushing_of(const std::string& text) {
  std::string head = kHead;
  head.replace(head.find("[[compliance]]"), 14, "[[bushing]]");
  return parse_scene(head + "to = \"lid\"\npoint_mm = [1, 2, 3]\n" + text, "s.toml").bushings.at(0);
}

TEST(SceneBushing, IsReadInSi) {
  const SceneBushingSpec read = bushing_of(
      "axis = [0, 2, 0]\ntranslation_N_per_mm = [50, 0, 70]\ntranslation_damping_Ns_per_m = 30\n"
      "rotation_Nm_per_rad = [4, 2, 1]\nrotation_toe_deg = 10\nstiffening = 8\n");
  EXPECT_EQ(read.name, "bushing of lid");
  EXPECT_EQ(read.stiffness, (std::array<double, 6>{50e3, 0, 70e3, 4, 2, 1}));
  EXPECT_EQ(read.damping, (std::array<double, 6>{30, 30, 30, 0, 0, 0}));
  EXPECT_TRUE(std::isinf(read.translation_toe));
  EXPECT_DOUBLE_EQ(read.rotation_toe, 10 * kDegree);
  EXPECT_EQ(read.stiffening, 8);
  EXPECT_EQ(read.axis, Eigen::Vector3d(0, 1, 0));
}

TEST(SceneBushing, MistakesAreToldWithTheirLines) {
  const auto told = [](const std::string& text) {
    return message_of<DataError>([&] { (void)bushing_of(text); });
  };
  EXPECT_THAT(told("translation_N_per_mm = [1, 1, 1]\nstiffening = 8\n"),
              StartsWith("s.toml:18: springs without a toe are straight"));
  EXPECT_THAT(told("translation_N_per_mm = [1, 1, -1]\n"), StartsWith("s.toml:17: "));
}

}  // namespace
}  // namespace thenar
