// Tests for data/io/robot/graspit_robot.cpp.

#include "data/io/robot/graspit_robot.h"

#include <gmock/gmock.h>

#include "base/file_io.h"
#include "base/units.h"
#include "data/io/robot/link_poses.h"
#include "tests/data/robot/named_parts.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kGraspitRounding = 1e-14;

/// A joint about z with these Denavit-Hartenberg numbers, 0 to 90 degrees.
std::string hinge(const std::string& theta, const std::string& a, const std::string& alpha,
                  const std::string& more = "") {
  return "<joint type='Revolute'><theta>" + theta + "</theta><d>0</d><a>" + a + "</a><alpha>" +
         alpha + "</alpha><minValue>0</minValue><maxValue>90</maxValue>" + more + "</joint>\n";
}

const std::string kDofs =
    "<dof type='r'><defaultVelocity>0</defaultVelocity><maxEffort>5e9</maxEffort>"
    "<draggerScale>20</draggerScale></dof>\n"
    "<dof type='b'><defaultVelocity>1.5</defaultVelocity><maxEffort>2.5e9</maxEffort>"
    "<breakAwayTorque>0.5</breakAwayTorque></dof>\n";

class GraspitRobot : public TemporaryFolder {
 protected:
  GraspitRobot() {
    std::filesystem::create_directories(folder_ / "iv");
    write_file(path("iv/palm.xml"),
               "<root><material>plastic</material><mass>300</mass><cog>1 2 3</cog>"
               "<inertia_matrix>100 0 0 0 200 0 0 0 250</inertia_matrix>"
               "<geometryFile type='off'>palm.off</geometryFile></root>");
    write_file(path("iv/palm.off"), "OFF\n3 1 0\n0 0 0\n10 0 0\n0 10 0\n3 0 1 2\n");
    write_file(path("iv/link.xml"), "<root><mass>50</mass></root>");
  }
  RobotSpec read(const std::string& content) {
    write_file(path("robot.xml"),
               "<robot type='Claw'>\n<palm>palm.xml</palm>\n" + content + "</robot>");
    return read_graspit_robot(path("robot.xml"));
  }
  std::string refusal(const std::string& content) {
    return message_of<DataError>([&] { (void)read(content); });
  }
};

TEST_F(GraspitRobot, ReadsBodiesInTheirUnits) {
  const RobotSpec robot = read("");
  EXPECT_EQ(robot.name, "Claw");
  const RobotLink& palm = robot.links[0];
  EXPECT_EQ(palm.material, "plastic");
  EXPECT_DOUBLE_EQ(palm.mass, 0.3);
  EXPECT_TRUE(matrix_near(palm.com, Eigen::Vector3d(0.001, 0.002, 0.003), 1e-18));
  // 300 g times mm^2.
  EXPECT_TRUE(matrix_near(palm.inertia, Eigen::Vector3d(3e-5, 6e-5, 7.5e-5).asDiagonal(), 1e-18));
  ASSERT_EQ(palm.shapes.size(), 1U);
  EXPECT_DOUBLE_EQ(palm.shapes[0].mesh.vertices.maxCoeff(), 0.01);
  EXPECT_EQ(palm.shapes[0].mesh_scale, 1e-3);
}

// The chain stands 25 mm along x, turned by 90 degrees about z. Joint 1 turns by d0 + 90 about z,
// then 50 mm along the new x (world -x at d0 = 0), twisted by 90 about x; joint 2 turns by d1 / 2
// + 30.
TEST_F(GraspitRobot, PlacesLinksByTheirTable) {
  const RobotSpec robot =
      read(kDofs +
           "<chain><transform><translation>25 0 0</translation><rotation>90 z</rotation>"
           "</transform>\n" +
           hinge("d0+90", "50", "90") + hinge("d1*0.5+30", "40", "0") +
           "<link dynamicJointType='Revolute'>link.xml</link><link "
           "dynamicJointType='Revolute'>link.xml</link></chain>");
  EXPECT_THAT(names(robot.links), ElementsAre("palm", "chain1 link", "chain1 link 2"));
  EXPECT_THAT(names(robot.joints), ElementsAre("chain1 joint1", "chain1 joint2"));
  EXPECT_NO_THROW(check_robot(robot));
  const double half = std::sqrt(0.75);
  std::vector<Pose<double>> X = link_poses(robot, {});
  EXPECT_TRUE(matrix_near(X[1].p, Eigen::Vector3d(-0.025, 0, 0), kGraspitRounding));
  EXPECT_TRUE(matrix_near(X[1].R.col(2), Eigen::Vector3d(0, 1, 0), kGraspitRounding));
  // The second turns 30 degrees about world y from -x towards its own y, which is world z.
  EXPECT_TRUE(
      matrix_near(X[2].p, Eigen::Vector3d(-0.025 - 0.04 * half, 0, 0.02), kGraspitRounding));
  X = link_poses(robot, {{"d0", kPi / 2}, {"d1", kPi / 3}});
  EXPECT_TRUE(
      matrix_near(X[2].p, Eigen::Vector3d(0.025, -0.05 - 0.02, 0.04 * half), kGraspitRounding));
}

// Limits hold for ratio * d: 90 / 0.5 and 90 / 1, of which the tighter counts; offsets do not.
TEST_F(GraspitRobot, TakesTheTightestRange) {
  const RobotSpec robot =
      read(kDofs + "<chain>" + hinge("d1*0.5+30", "40", "0") + hinge("d1+20", "40", "0") +
           hinge("d0*-1", "1", "0", "<viscousFriction>5e7</viscousFriction>") +
           "<link dynamicJointType='Universal'>link.xml</link>"
           "<link dynamicJointType='Revolute'>link.xml</link></chain>");
  EXPECT_THAT(names(robot.links),
              ElementsAre("palm", "chain1 link", "chain1 link after 1", "chain1 link 2"));
  EXPECT_NEAR(robot.dofs[1].upper, kPi / 2, kGraspitRounding);
  EXPECT_NEAR(robot.dofs[0].lower, -kPi / 2, kGraspitRounding);
  EXPECT_NEAR(robot.dofs[0].upper, 0, kGraspitRounding);
  EXPECT_NEAR(robot.joints[2].damping, 0.05, kGraspitRounding);  // 5e7 GraspIt! units, as published
}

TEST_F(GraspitRobot, ReadsMotors) {
  const RobotSpec robot = read(kDofs + "<chain>" + hinge("d0", "1", "0") + hinge("d1", "1", "0") +
                               "<link>link.xml</link><link>link.xml</link></chain>"
                               "<approachDirection><referenceLocation>0 0 20</referenceLocation>"
                               "<direction>0 3 4</direction></approachDirection>");
  EXPECT_EQ(robot.dofs[0].kind, DriveCoupling::kRigid);
  EXPECT_NEAR(robot.dofs[0].max_effort, 5, kGraspitRounding);
  EXPECT_TRUE(robot.dofs[0].nominal_effort);
  EXPECT_TRUE(robot.dofs[0].backdrivable);  // the format does not say
  EXPECT_EQ(robot.dofs[1].kind, DriveCoupling::kBreakaway);
  EXPECT_EQ(robot.dofs[1].breakaway, 0.5);
  EXPECT_EQ(robot.dofs[1].speed, 1.5);
  EXPECT_TRUE(matrix_near(robot.approach.point, Eigen::Vector3d(0, 0, 0.02), kGraspitRounding));
  EXPECT_TRUE(
      matrix_near(robot.approach.direction, Eigen::Vector3d(0, 0.6, 0.8), kGraspitRounding));
}

// Some files have -1 for efforts that nobody knows.
TEST_F(GraspitRobot, TakesNegativeEffortsForUnknown) {
  std::string dofs = kDofs;
  dofs.replace(dofs.find("2.5e9"), 5, "-1");
  const RobotSpec robot = read(dofs + "<chain>" + hinge("d0", "1", "0") + hinge("d1", "1", "0") +
                               "<link>link.xml</link><link>link.xml</link></chain>");
  EXPECT_EQ(robot.dofs[1].max_effort, 0);
  EXPECT_FALSE(robot.dofs[1].nominal_effort);
  EXPECT_NEAR(robot.dofs[0].max_effort, 5, kGraspitRounding);
  EXPECT_THAT(robot.warnings, Contains(AllOf(HasSubstr("maxEffort of 'd1' is -1"),
                                             HasSubstr("treated as unknown"))));
}

// What it is then is guessed of the closing hand; a place without a way says nothing either.
TEST_F(GraspitRobot, KnowsWhetherAnApproachIsStated) {
  const std::string chain = kDofs + "<chain>" + hinge("d0", "1", "0") + hinge("d1", "1", "0") +
                            "<link>link.xml</link><link>link.xml</link></chain>";
  const std::string place = "<referenceLocation>0 0 20</referenceLocation>";
  EXPECT_FALSE(read(chain).approach_stated);
  EXPECT_FALSE(
      read(chain + "<approachDirection>" + place + "</approachDirection>").approach_stated);
  EXPECT_TRUE(read(chain + "<approachDirection>" + place +
                   "<direction>0 0 1</direction></approachDirection>")
                  .approach_stated);
}

// 5e7 units of force are 50 N; lengths in mm; the turn stands before the slide.
TEST_F(GraspitRobot, DoesNotHeedTheCaseOfElements) {
  std::string chain = kDofs + "<chain>" + hinge("d1", "30", "0") + "<link>link.xml</link></chain>";
  const RobotSpec plain = read(chain);
  for (const auto& [from, to] :
       {std::pair("<dof", "<DOF"), std::pair("</dof", "</DOF"), std::pair("<minValue", "<MinValue"),
        std::pair("</minValue", "</MinValue")})
    for (std::size_t at; (at = chain.find(from)) != std::string::npos;)
      chain.replace(at, std::string(from).size(), to);
  EXPECT_EQ(robot_toml(read(chain)), robot_toml(plain));
}

TEST_F(GraspitRobot, SlidesAlongTheTurnedAxis) {
  const RobotSpec robot = read(
      "<dof type='r'><maxEffort>5e7</maxEffort></dof><chain><joint type='Prismatic'>"
      "<theta>90</theta><d>d0+5</d><a>2</a><alpha>90</alpha><minValue>-10</minValue>"
      "<maxValue>20</maxValue></joint><link dynamicJointType='Prismatic'>link.xml</link></chain>");
  EXPECT_NEAR(robot.dofs[0].max_effort, 50, 1e-12);
  EXPECT_NEAR(robot.dofs[0].lower, -0.01, kGraspitRounding);
  const Pose<double> X = link_poses(robot, {{"d0", 0.02}})[1];
  EXPECT_TRUE(matrix_near(X.p, Eigen::Vector3d(0, 0.002, 0.025), kGraspitRounding));
}

TEST_F(GraspitRobot, NamesWhatItDoesNotReadAndWhatIsMissing) {
  const RobotSpec robot =
      read(kDofs + "<eigenGrasps>e.xml</eigenGrasps><virtualContacts>c</virtualContacts><chain>" +
           hinge("d0-2.46", "1", "0") + hinge("d1", "1", "0") + "<link>lost.xml</link></chain>");
  for (const std::string part : {"<draggerScale> in <dof>", "<eigenGrasps>", "<virtualContacts>",
                                 "MISSING BODY 'lost.xml'", "'d0-2.46' has an offset without '+'",
                                 "<joint> that carries no link", "'d1' drives no joint"})
    EXPECT_THAT(robot.warnings, Contains(HasSubstr(part)));
}

TEST_F(GraspitRobot, NamesABodyWhoseNameNoFileCanHave) {
  const std::string name(300, 'a');
  const RobotSpec robot =
      read(kDofs + "<chain>" + hinge("d0", "1", "0") + "<link>" + name + "</link></chain>");
  EXPECT_THAT(robot.warnings, Contains(HasSubstr("MISSING BODY '" + name + "'")));
}

TEST_F(GraspitRobot, RefusesWithTheLine) {
  EXPECT_THAT(refusal("<dof type='x'/>"), HasSubstr("robot.xml:3: "));
  EXPECT_THAT(refusal(kDofs + "<chain>" + hinge("d7", "1", "0") + "<link>link.xml</link></chain>"),
              AllOf(HasSubstr(":5: "), HasSubstr("names degree of freedom 7 of 2")));
  EXPECT_THAT(refusal("<chain>\n<link>link.xml</link></chain>"),
              AllOf(HasSubstr(":4: "), HasSubstr("no joint left")));
  EXPECT_THAT(refusal(kDofs + "<chain>" + hinge("q", "1", "0") + "<link>link.xml</link></chain>"),
              HasSubstr("'q'"));
}

}  // namespace
}  // namespace thenar
