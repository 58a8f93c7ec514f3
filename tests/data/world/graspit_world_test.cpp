// Tests for data/io/world/graspit_world.cpp and graspit_body.cpp.

#include "data/io/world/graspit_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "data/io/world/graspit_body.h"
#include "tests/data/mesh/cube_files.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kRounding = 1e-15;

const std::string kBody = R"(<?xml version="1.0" ?>
<root>
  <material>wood</material>
  <mass>200.0</mass>
  <cog>1 2 3</cog>
  <inertia_matrix>400 0 0 0 500 -10 0 -10 600</inertia_matrix>
  <geometryFile type="off">cube.off</geometryFile>
</root>
)";

const std::string kGraspitWorld = R"(<?xml version="1.0" ?>
<world>
  <obstacle>
    <filename>models/cube.off</filename>
    <transform><fullTransform>(+1 +0 +0 +0)[+0 +0 -100]</fullTransform></transform>
  </obstacle>
  <graspableBody>
    <filename>models/body.xml</filename>
    <transform><translation>10 20 30</translation><rotation>90 z</rotation></transform>
  </graspableBody>
  <graspableBody>
    <filename>models/body.xml</filename>
  </graspableBody>
  <robot>
    <filename>models/arm.xml</filename>
    <dofValues>+30 -0.25</dofValues>
  </robot>
  <robot>
    <filename>models/lost.xml</filename>
  </robot>
  <robot>
    <filename>models\hand.xml</filename>
    <dofValues>+0.5 +0.6 +0 +0.3 +1 +0.25 +0 +0.2</dofValues>
    <transform><translation>0 0 1</translation></transform>
  </robot>
  <connection>
    <parentRobot>0</parentRobot>
    <parentChain>0</parentChain>
    <childRobot>2</childRobot>
    <mountFilename>mount.xml</mountFilename>
    <transform><translation>0 0 50</translation></transform>
  </connection>
  <camera>
    <position>0 0 400</position>
    <orientation>0 0 0 1</orientation>
    <focalDistance>300</focalDistance>
  </camera>
  <light/>
</world>
)";

std::string joint(const std::string& type, const std::string& theta, const std::string& d,
                  const std::string& lower, const std::string& upper) {
  return "<joint type='" + type + "'><theta>" + theta + "</theta><d>" + d +
         "</d><a>10</a><alpha>0</alpha><minValue>" + lower + "</minValue><maxValue>" + upper +
         "</maxValue></joint>";
}

/// A gear, a clutch of one joint and one of two, a spring.
std::string hand() {
  std::string xml = "<robot type='Hand'><palm>p</palm>";
  for (const std::string type : {"r", "b", "b", "c"}) xml += "<dof type='" + type + "'/>";
  xml += "<chain>";
  for (const std::string theta : {"d0", "d1", "d2", "d2*0.5", "d3"})
    xml += joint("Revolute", theta, "0", "0", "90");
  for (int i = 0; i < 5; ++i) xml += "<link>seg.xml</link>";
  return xml + "</chain></robot>";
}

class Graspit : public TemporaryFolder {
 protected:
  Graspit() {
    write_file(path("models/cube.off"), cube_off());
    write_file(path("models/body.xml"), kBody);
    write_file(path("models/arm.xml"),
               "<robot type='Arm'><palm>p</palm><dof type='r'/><dof type='r'/><chain>" +
                   joint("Prismatic", "0", "d0", "-100", "100") +
                   joint("Revolute", "d1", "0", "-90", "90") +
                   "<link dynamicJointType='Prismatic'>a/part.xml</link><link>a/part.xml</link>"
                   "</chain></robot>");
    write_file(path("models/hand.xml"), hand());
  }
  [[nodiscard]] GraspitBody body(const std::string& xml) const {
    write_file(path("models/other.xml"), xml);
    return read_graspit_body(path("models/other.xml"));
  }
  [[nodiscard]] GraspitWorld world(const std::string& xml) const {
    write_file(path("worlds/world.xml"), xml);
    return read_graspit_world(path("worlds/world.xml"));
  }
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST_F(Graspit, BodyHasMassAndMaterialInSi) {
  const GraspitBody read = body(kBody);
  EXPECT_THAT(read.warnings, ElementsAre());
  EXPECT_EQ(read.body.name, "other");
  EXPECT_EQ(read.body.material, "wood");
  ASSERT_TRUE(read.body.mass);
  EXPECT_DOUBLE_EQ(read.body.mass->mass, 0.2);
  EXPECT_TRUE(matrix_near(read.body.mass->com, Eigen::Vector3d(0.001, 0.002, 0.003), kRounding));
  Eigen::Matrix3d per_mass;  // [mm^2]
  per_mass << 400, 0, 0, 0, 500, -10, 0, -10, 600;
  EXPECT_TRUE(matrix_near(read.body.mass->inertia, 0.2 * 1e-6 * per_mass, kRounding));
  ASSERT_EQ(read.body.shapes.size(), 1U);
  EXPECT_DOUBLE_EQ(read.body.shapes[0].mesh.vertices.maxCoeff(), 0.002);  // 2 mm
}

TEST_F(Graspit, BodyScalesItsGeometry) {
  const auto edge = [&](const std::string& to) {
    return body(replaced(kBody, "type=\"off\"", to)).body.shapes[0].mesh.vertices.maxCoeff();
  };
  EXPECT_DOUBLE_EQ(edge("Units=\"cm\""), 0.02);
  EXPECT_DOUBLE_EQ(edge("Units=\"m\" scale=\"0.5\""), 1);
  EXPECT_DOUBLE_EQ(body(replaced(kBody, "<mass>", "<geometryScaling>3</geometryScaling><mass>"))
                       .body.shapes[0]
                       .mesh.vertices.maxCoeff(),
                   0.006);
}

TEST_F(Graspit, BodyNamesWhatItDoesNotKnow) {
  const std::string xml =
      replaced(replaced(kBody, "wood", "cheese"), "<mass>", "<youngs>1</youngs><mass>");
  const std::string file = path("models/other.xml");
  EXPECT_THAT(body(xml).warnings,
              ElementsAre(file + ":4: <youngs> is not understood and was left out",
                          file + ":3: material 'cheese' is not known and was left out"));
}

TEST_F(Graspit, BodyIsRefusedWithItsLine) {
  const auto refusal = [&](const std::string& from, const std::string& to) {
    const std::string message =
        message_of<DataError>([&] { (void)body(replaced(kBody, from, to)); });
    return message.substr(message.find(".xml") + 4);
  };
  for (const std::string& none : {std::string("no.off"), std::string(300, 'a')})
    EXPECT_THAT(refusal("cube.off", none), StartsWith(":7: there is no geometry file"));
  EXPECT_EQ(refusal("type=\"off\"", "Units=\"ft\""),
            ":7: wanted 'Units' to be mm, cm, m or in, got 'ft'");
  EXPECT_EQ(refusal("200.0", "x"), ":4: wanted finite numbers in <mass>, got 'x'");
}

TEST_F(Graspit, WorldPlacesItsBodies) {
  const WorldSpec read = world(kGraspitWorld).world;
  ASSERT_EQ(read.bodies.size(), 3U);
  EXPECT_FALSE(read.bodies[0].dynamic);
  EXPECT_EQ(read.bodies[0].X_WB.p.z(), -0.1);
  EXPECT_TRUE(read.bodies[1].dynamic);
  EXPECT_TRUE(matrix_near(read.bodies[1].X_WB.p, Eigen::Vector3d(0.01, 0.02, 0.03), kRounding));
  EXPECT_TRUE(matrix_near(read.bodies[1].X_WB.R.col(0), Eigen::Vector3d(0, 1, 0), kRounding));
  EXPECT_EQ(read.bodies[2].body.name, "body_2");
}

TEST_F(Graspit, WorldMountsHandsOnArms) {
  const WorldSpec read = world(kGraspitWorld).world;
  ASSERT_EQ(read.hands.size(), 2U);
  EXPECT_EQ(read.hands[0].file, path("models/arm.xml"));
  EXPECT_EQ(read.hands[1].file, path("models/hand.xml"));
  EXPECT_EQ(read.hands[1].carrier, "arm");
  EXPECT_EQ(read.hands[1].carrier_link, "chain1 part 2");  // the second of that body
  EXPECT_EQ(read.hands[1].X_WH.p.z(), 0.05);
}

TEST_F(Graspit, WorldSetsSlidesInMetresAndBrokenAwayJointsAlone) {
  using Posture = std::map<std::string, double>;
  const WorldSpec read = world(kGraspitWorld).world;
  EXPECT_EQ(read.hands[0].posture, (Posture{{"d0", 0.03}, {"d1", -0.25}}));
  // d0; d1 held by its clutch; d2's motor at 0.3, which its first joint left at 0.25 and its second
  // follows at half the way; d3.
  EXPECT_EQ(read.hands[1].posture, (Posture{{"d0", 0.5},
                                            {"d1", 0.6},
                                            {"chain1 joint3", 0.25},
                                            {"chain1 joint4", 0.15},
                                            {"d3", 0.2}}));
}

/// The posture of the world's hand with other <dofValues>, and whether a warning is about it.
class GraspitPostures : public Graspit {
 protected:
  using Posture = std::map<std::string, double>;
  [[nodiscard]] std::pair<Posture, bool> hand_with(const std::string& values) const {
    const GraspitWorld read =
        world(replaced(kGraspitWorld, "+0.5 +0.6 +0 +0.3 +1 +0.25 +0 +0.2", values));
    const bool warned =
        std::any_of(read.warnings.begin(), read.warnings.end(), [](const std::string& warning) {
          return warning.find("robot 'hand': ") != std::string::npos;
        });
    return {read.world.hands[1].posture, warned};
  }
};

// Three flags for the three joints of d1 and d2.
TEST_F(GraspitPostures, HaveOneFlagForEveryJointOfABreakawayMotor) {
  const Posture held{{"d0", 0.1}, {"d1", 0.2}, {"d2", 0.3}, {"d3", 0.4}};
  EXPECT_EQ(hand_with("0.1 0.2 0 0.3 0 0 0.4"), std::pair(held, false));
  // Both joints of d2 left it, at 0.25 and 0.2 of the motor: the second goes half as far.
  EXPECT_EQ(hand_with("0.1 0.2 0 0.3 1 0.25 1 0.2 0.4"), std::pair(Posture{{"d0", 0.1},
                                                                           {"d1", 0.2},
                                                                           {"chain1 joint3", 0.25},
                                                                           {"chain1 joint4", 0.1},
                                                                           {"d3", 0.4}},
                                                                   false));
  // A motor that has gone back behind the place where its joint left it holds the joint again.
  EXPECT_EQ(hand_with("0.1 0.2 1 0.6 0.3 0 0 0.4").first.at("chain1 joint2"), 0.2);
  // Read one flag a motor, these would fit as well, and put the hand elsewhere.
  EXPECT_EQ(hand_with("0.1 0.9 1 0.5 0 0 0 0").first.at("chain1 joint2"), 0.5);
}

TEST_F(GraspitPostures, AreReadWithoutFlagsAndNamedIfTheyFitNeither) {
  const Posture plain{{"d0", 0.1}, {"d1", 0.2}, {"d2", 0.3}, {"d3", 0.4}};
  EXPECT_EQ(hand_with("0.1 0.2 0.3 0.4"), std::pair(plain, false));
  EXPECT_EQ(hand_with(""), std::pair(Posture{}, false));
  for (const std::string wrong :
       {"0.1 0.2 0.3", "0 0.2 2 0.3 0 0 0.4", "0 0.2 0 0.3 0 1 0.4", "0.1 0.2 0 0.3 0 0.4"})
    EXPECT_EQ(hand_with(wrong), std::pair(Posture{}, true)) << wrong;
  // A quarter turn in five digits is rounding, two radians are not.
  EXPECT_EQ(hand_with("1.5708 0 0 0").first.at("d0"), std::acos(0));
  EXPECT_FALSE(hand_with("1.5708 0 0 0").second);
  EXPECT_EQ(hand_with("2 0 0 0"),
            std::pair(Posture{{"d0", std::acos(0)}, {"d1", 0}, {"d2", 0}, {"d3", 0}}, true));
}

TEST_F(Graspit, WorldLooksThroughItsCamera) {
  const Camera camera = world(kGraspitWorld).world.camera;
  EXPECT_TRUE(matrix_near(camera.eye, Eigen::Vector3d(0, 0, 0.4), kRounding));
  EXPECT_TRUE(matrix_near(camera.target, Eigen::Vector3d(0, 0, 0.1), kRounding));
}

TEST_F(Graspit, WorldNamesWhatItDoesNotKnow) {
  const std::string file = path("worlds/world.xml");
  const std::vector<std::string> warnings = world(kGraspitWorld).warnings;
  for (const std::string warning :
       {":19: MISSING ROBOT 'models/lost.xml': there is no such file; it is left out",
        ":30: <mountFilename> is not understood and was left out",
        ":38: <light> is not understood and was left out"})
    EXPECT_THAT(warnings, Contains(file + warning));
  EXPECT_THAT(warnings, Contains(HasSubstr("hand.xml: MISSING BODY 'seg.xml'")));
}

TEST_F(Graspit, WorldGoesOnWithoutWhatIsMissing) {
  const GraspitWorld without_object = world(replaced(kGraspitWorld, "models/cube.off", "no.off"));
  EXPECT_THAT(without_object.warnings, Contains(HasSubstr(":4: MISSING BODY 'no.off'")));
  EXPECT_EQ(without_object.world.bodies.size(), 2U);
  const GraspitWorld without_arm =
      world(replaced(kGraspitWorld, "models/arm.xml", "models/body.xml"));
  EXPECT_THAT(without_arm.warnings, Contains(HasSubstr("UNREADABLE ROBOT")));
  EXPECT_THAT(without_arm.warnings, Contains(HasSubstr("robot 0 carries robot 2, one of which")));
  ASSERT_EQ(without_arm.world.hands.size(), 1U);
  EXPECT_EQ(without_arm.world.hands[0].carrier, "");
  EXPECT_EQ(without_arm.world.hands[0].X_WH.p.z(), 0.001);  // as it stands itself
}

TEST_F(Graspit, WorldSurvivesAsToml) {
  const WorldSpec read = world(kGraspitWorld).world;
  write_file(path("elsewhere/world.toml"), world_toml(read));
  const WorldSpec again = read_world(path("elsewhere/world.toml"));
  EXPECT_EQ(again.bodies[1].X_WB.R, read.bodies[1].X_WB.R);
  EXPECT_EQ(again.bodies[1].body.mass->inertia, read.bodies[1].body.mass->inertia);
  EXPECT_EQ(again.bodies[1].body.shapes[0].mesh.vertices,
            read.bodies[1].body.shapes[0].mesh.vertices);
}

TEST_F(Graspit, WorldIsRefusedWithItsLine) {
  const auto refusal = [&](const std::string& from, const std::string& to) {
    const std::string message =
        message_of<DataError>([&] { (void)world(replaced(kGraspitWorld, from, to)); });
    return message.substr(message.find(".xml") + 4);
  };
  EXPECT_EQ(refusal("<childRobot>2", "<childRobot>3"), ":29: wanted <childRobot> in 0..2, got 3");
  EXPECT_EQ(refusal("<childRobot>2", "<childRobot>0"), ":26: a robot cannot carry itself");
  EXPECT_EQ(refusal("<parentChain>0", "<parentChain>1"), ":28: robot 0 has no chain 1");
  EXPECT_THAT(refusal("(+1 +0 +0 +0)", "(+1 +0 +0)"), HasSubstr(":5: wanted 7 numbers"));
}

}  // namespace
}  // namespace thenar
