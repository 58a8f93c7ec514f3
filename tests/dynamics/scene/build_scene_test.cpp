// Tests for dynamics/scene/build_scene.cpp and scene_pairs.cpp.

#include "dynamics/scene/build_scene.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "dynamics/mechanism/tree_motion.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kHead = "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n";
const std::string kTail = "[stepping]\nduration_s = 1\n";

BuiltScene built(const std::string& text, const std::vector<SceneHand>& robots = {}) {
  return build_scene(parse_scene(kHead + text + kTail, "s.toml"), robots);
}

std::string complaint(const std::string& text, const std::vector<SceneHand>& robots = {}) {
  return message_of<DataError>([&] { (void)built(text, robots); });
}

RobotSpec robot(const std::string& name) { return read_robot(kData + "/robots/" + name + ".toml"); }

std::string ball(const std::string& name, const std::string& more = "") {
  return "[[body]]\nname = \"" + name + "\"\nmass_g = 100\nmaterial = \"wood\"\n" + more +
         "[[body.shape]]\nkind = \"sphere\"\nsize_mm = [10]\n";
}

/// Poses of all bodies at the start.
std::vector<Pose<double>> poses(const BuiltScene& scene) {
  const TreeModel model = tree_model(scene.scene.mechanism);
  TreeMotion<double> motion(model);
  motion.set_position(scene.scene.q);
  std::vector<Pose<double>> out;
  for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) out.push_back(motion.pose(i));
  return out;
}

// Whatever its joint and its value at the start, a body begins where the file puts it.
TEST(BuildScene, PutsEveryJointWhereTheFileSays) {
  const std::string pose = "position_mm = [10, 20, 30]\nrpy_deg = [10, 20, 30]\n";
  Pose<double> wanted;
  wanted.p = Eigen::Vector3d(0.01, 0.02, 0.03);
  wanted.R = rotation_about<double>({0, 0, 1}, 30 * kDegree) *
             rotation_about<double>({0, 1, 0}, 20 * kDegree) *
             rotation_about<double>({1, 0, 0}, 10 * kDegree);
  const std::string carrier =
      ball("carrier",
           "position_mm = [100, 0, 50]\nrpy_deg = [0, 40, 0]\n[body.joint]\n"
           "kind = \"hinge\"\naxis = [1, 2, 3]\npoint_mm = [5, 5, 5]\nstart_deg = 70\n");
  for (const std::string& joint : {
           std::string("[body.joint]\nkind = \"weld\"\n"),
           std::string("[body.joint]\nkind = \"free\"\n"),
           std::string("[body.joint]\nkind = \"ball\"\npoint_mm = [1, 2, 3]\n"),
           std::string("[body.joint]\nkind = \"slide\"\naxis = [1, -1, 2]\nstart_mm = 7\n"),
           std::string("[body.joint]\nkind = \"hinge\"\naxis = [1, -1, 2]\npoint_mm = [4, 5, 6]\n"
                       "start_deg = 50\n"),
       }) {
    for (const char* parent : {"", "parent = \"carrier\"\n"}) {
      if (joint.find("free") != std::string::npos && *parent != 0) continue;
      const BuiltScene scene = built(ball("moved", pose + joint + parent) + carrier);
      const auto X = poses(scene);
      const auto at = static_cast<std::size_t>(body_named(scene.scene.mechanism, "moved"));
      EXPECT_TRUE(matrix_near(X[at].p, wanted.p, 1e-15)) << joint << parent;
      EXPECT_TRUE(matrix_near(X[at].R, wanted.R, 1e-14)) << joint << parent;
    }
  }
}

// The limits of a hinge that begins at 50 degrees are where the body has turned from there.
TEST(BuildScene, CountsAJointFromItsStart) {
  const BuiltScene scene =
      built(ball("arm",
                 "position_mm = [0, 100, 0]\n[body.joint]\nkind = \"hinge\"\naxis = [0, 0, 1]\n"
                 "point_mm = [0, 0, 0]\nstart_deg = 90\nrange_deg = [0, 180]\n"));
  EXPECT_DOUBLE_EQ(scene.scene.q[0], kPi / 2);
  BuiltScene back = scene;
  back.scene.q[0] = 0;
  EXPECT_TRUE(matrix_near(poses(back)[0].p, Eigen::Vector3d(0.1, 0, 0), 1e-15));
}

TEST(BuildScene, VelocityIsThatOfTheCentreOfMass) {
  const BuiltScene scene = built(
      "[[body]]\nname = \"b\"\nmass_g = 100\nrpy_deg = [0, 0, 90]\nvelocity_m_s = [1, 2, 3]\n"
      "angular_velocity_rad_s = [0, 0, 5]\n[[body.shape]]\nkind = \"sphere\"\nsize_mm = [10]\n"
      "position_mm = [50, 0, 0]\n");
  const TreeModel model = tree_model(scene.scene.mechanism);
  TreeMotion<double> motion(model);
  motion.set_position(scene.scene.q);
  motion.set_speed(scene.scene.v);
  EXPECT_TRUE(matrix_near(motion.velocity(0, {0, 0.05, 0}), Eigen::Vector3d(1, 2, 3), 1e-15));
  // The origin turns about the centre: 5 rad/s x 50 mm along x.
  EXPECT_TRUE(matrix_near(motion.velocity(0, {0, 0, 0}), Eigen::Vector3d(1.25, 2, 3), 1e-14));
}

TEST(BuildScene, FrictionIsOfPairsThenOfAllThenOfMaterials) {
  const std::string bodies = ball("a") + ball("b", "position_mm = [100, 0, 0]\n") +
                             ball("c", "position_mm = [200, 0, 0]\n");
  const BuiltScene stated =
      built(bodies +
            "[[friction]]\ncoefficient = 0.9\nrestitution = 0.25\n[[friction]]\n"
            "between = [\"c\", \"a\"]\ncoefficient = 0.1\n");
  EXPECT_EQ(pair_friction(stated.scene, 0, 1).coefficient, 0.9);
  EXPECT_EQ(pair_friction(stated.scene, 0, 2).coefficient, 0.1);
  EXPECT_EQ(pair_friction(stated.scene, 0, 2).restitution, 0.25);
  // Wood on wood: the static coefficient of data/materials.toml.
  const BuiltScene material =
      built(bodies + "[[friction]]\nbetween = [\"c\", \"a\"]\ntorsion_radius_mm = 2\n");
  EXPECT_EQ(pair_friction(material.scene, 0, 1).coefficient, 0.4);
  EXPECT_EQ(pair_friction(material.scene, 0, 2).coefficient, 0.4);
  EXPECT_DOUBLE_EQ(pair_friction(material.scene, 0, 2).torsion_radius, 0.002);
}

TEST(BuildScene, WarnsOfBodiesThatBeginInEachOther) {
  const BuiltScene scene = built(ball("a") + ball("b", "position_mm = [19, 0, 0]\n"));
  EXPECT_THAT(scene.warnings,
              Contains("'a' and 'b' begin in each other by 1 mm and are pushed apart"));
  const BuiltScene apart = built(ball("a") + ball("b", "position_mm = [19, 0, 0]\n") +
                                 "[[apart]]\nbetween = [\"a\", \"b\"]\n");
  EXPECT_TRUE(apart.warnings.empty());
}

TEST(BuildScene, HandsAreMechanismsWithPrefixes) {
  const BuiltScene scene = built(
      "[[hand]]\nname = \"jaw\"\nposition_mm = [0, 0, 300]\nways_mm = {opening = 40}\n"
      "[[drive]]\ncoordinate = \"jaw/opening\"\neffort_N = -5\n",
      {robot("parallel_jaw")});
  ASSERT_EQ(scene.scene.mechanism.bodies.size(), 3U);
  EXPECT_EQ(scene.scene.mechanism.bodies[1].name, "jaw/left jaw");
  EXPECT_EQ(scene.owner, (std::vector<std::string>{"jaw", "jaw", "jaw"}));
  // Each jaw by the way of the motor.
  EXPECT_TRUE(
      matrix_near(poses(scene)[2].p - poses(scene)[1].p, Eigen::Vector3d(0.08, 0, 0), 1e-12));
  // The motor of the robot bounds its drive.
  EXPECT_EQ(scene.scene.drives.at(0).max_effort, 160);
}

// The Barrett hand's motors are behind worms: the spread, which nothing drives, stands still.
TEST(BuildScene, MotorsThatHoldByThemselvesStandStill) {
  const BuiltScene scene = built(
      "[[hand]]\nname = \"barrett\"\nangles_deg = {spread = 30}\n[[drive]]\n"
      "coordinate = \"barrett/finger 1\"\neffort_Nm = 0.1\n",
      {robot("barrett")});
  ASSERT_EQ(scene.scene.mechanism.coordinates.size(), 1U);
  EXPECT_EQ(scene.scene.mechanism.coordinates[0].name, "barrett/finger 1");
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("clutch")));
  EXPECT_THAT(scene.warnings, Not(Contains(HasSubstr("begin in each other"))));
}

TEST(BuildScene, TellsLinesOfWhatDoesNotFit) {
  EXPECT_THAT(
      complaint("[[body]]\nname = \"a\"\n[[body.shape]]\nkind = \"sphere\"\nsize_mm = [1]\n"),
      StartsWith("s.toml:5: body 'a' has neither mass nor density"));
  EXPECT_THAT(complaint(ball("a") + "[[drive]]\ncoordinate = \"a\"\neffort_N = 1\n"),
              StartsWith("s.toml:12: no coordinate 'a'"));
  EXPECT_THAT(complaint(ball("a", "joint = {kind = \"slide\", axis = [1, 0, 0]}\n") +
                        "[[drive]]\ncoordinate = \"a\"\neffort_Nm = 1\n"),
              StartsWith("s.toml:13: 'a' slides, but the drive has units of what turns"));
  EXPECT_THAT(
      complaint("[[hand]]\nname = \"jaw\"\nways_mm = {open = 40}\n", {robot("parallel_jaw")}),
      StartsWith("s.toml:5: no coordinate of hand 'jaw' 'open'"));
  EXPECT_THAT(
      complaint("[[hand]]\nname = \"jaw\"\nways_mm = {opening = 60}\n", {robot("parallel_jaw")}),
      HasSubstr("beyond its limits"));
  EXPECT_THAT(complaint(ball("a") + "[[friction]]\nbetween = [\"a\", \"b\"]\ncoefficient = 1\n" +
                        ball("b", "position_mm = [50, 0, 0]\n") +
                        "[[friction]]\nbetween = [\"b\", \"a\"]\ncoefficient = 1\n"),
              StartsWith("s.toml:23: the friction of 'b' and 'a' is given twice"));
  EXPECT_THAT(message_of<DataError>([] {
                (void)build_scene(parse_scene(kHead + ball("a") +
                                                  "[stepping]\nmethod = \"event\"\n"
                                                  "duration_s = 1\n",
                                              "s.toml"),
                                  {});
              }),
              StartsWith("s.toml:12: no method 'event', did you mean 'events'?"));
}

TEST(BuildScene, TakesTheSpringsOfContactsFromTheFile) {
  const auto options = [](const std::string& stepping) {
    const std::string text = kHead + ball("a") + "[stepping]\nduration_s = 1\n" + stepping;
    return build_scene(parse_scene(text, "s.toml"), {}).options;
  };
  const SceneOptions stated = options(
      "method = \"compliant-sundials\"\nmodulus_MPa = 2\nstiffness_N_per_mm = 3\n"
      "dissipation_s_per_m = 4\nlayer_mm = 5\ntransition_speed_mm_s = 6\n"
      "friction_ramp = \"linear\"\n");
  EXPECT_EQ(stated.method, SteppingMethod::kCompliantSundials);
  EXPECT_DOUBLE_EQ(stated.compliance.modulus, 2e6);
  EXPECT_DOUBLE_EQ(stated.compliance.stiffness, 3e3);
  EXPECT_DOUBLE_EQ(stated.compliance.dissipation, 4);
  EXPECT_DOUBLE_EQ(stated.compliance.layer, 5e-3);
  EXPECT_DOUBLE_EQ(stated.compliance.transition, 6e-3);
  EXPECT_EQ(stated.compliance.ramp, FrictionRamp::kLinear);
  EXPECT_EQ(options("").compliance.stiffness, ContactCompliance().stiffness);
  EXPECT_THAT(message_of<DataError>([&] { (void)options("friction_ramp = \"cubic\"\n"); }),
              StartsWith("s.toml:12: no friction ramp 'cubic'"));
  EXPECT_THAT(message_of<DataError>([&] { (void)options("transition_speed_mm_s = 0\n"); }),
              StartsWith("s.toml:14: wanted 'transition_speed_mm_s' > 0"));
}

TEST(SetNumber, ChangesWhatItNames) {
  BuiltScene scene =
      built(ball("a", "joint = {kind = \"slide\", axis = [1, 0, 0]}\n") +
            ball("b", "position_mm = [50, 0, 0]\n") +
            "[[drive]]\nname = \"grip\"\ncoordinate = \"a\"\neffort_N = -2\n[[force]]\n"
            "name = \"wind\"\nbody = \"b\"\nforce_N = [3, 4, 0]\n");
  set_number(scene, "friction", 0.7);
  EXPECT_EQ(pair_friction(scene.scene, 0, 1).coefficient, 0.7);
  const Eigen::Matrix3d inertia = scene.scene.mechanism.bodies[1].mass.inertia;
  set_number(scene, "mass/b", 0.2);
  EXPECT_EQ(scene.scene.mechanism.bodies[1].mass.mass, 0.2);
  EXPECT_TRUE(matrix_near(scene.scene.mechanism.bodies[1].mass.inertia, 2 * inertia, 1e-18));
  set_number(scene, "drive/grip", 9);
  EXPECT_EQ(scene.scene.drives[0].bias, -9);
  set_number(scene, "force/wind", 10);
  EXPECT_TRUE(matrix_near(scene.scene.forces[0].force, Eigen::Vector3d(6, 8, 0), 1e-14));
  set_number(scene, "step", 0.01);
  EXPECT_EQ(scene.options.step_length, 0.01);
}

TEST(SetNumber, RefusesWhatIsNotThere) {
  BuiltScene scene = built(ball("a"));
  EXPECT_THAT(message_of([&] { set_number(scene, "fricton", 1); }),
              HasSubstr("cannot vary 'fricton'"));
  EXPECT_THAT(message_of([&] { set_number(scene, "mass/b", 1); }), HasSubstr("no body 'b'"));
  EXPECT_THAT(message_of([&] { set_number(scene, "mass/a", -1); }),
              HasSubstr("wanted a mass above 0"));
  EXPECT_THAT(message_of([&] { set_number(scene, "friction", -1); }),
              HasSubstr("wanted friction from 0 up"));
  EXPECT_THAT(message_of([&] { set_number(scene, "drive/x", 1); }), HasSubstr("no drive 'x'"));
}

}  // namespace
}  // namespace thenar
