// Tests for data/io/scene/: scenes read and refused.

#include "data/io/scene/scene.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/file_io.h"
#include "base/units.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// Lines are counted by the tests below.
const std::string kScene = R"(name = "door"
source = "Mine"
gravity_m_s2 = [0, 0, -1.62]
[sources]
Mine = "Own measurement, calliper"
[[hand]]
name = "jaw"
position_mm = [0, 0, 300]
ways_mm = {opening = 40}
joint = {kind = "slide", axis = [0, 0, 1], start_mm = 5, speed_mm_s = 20}
[[body]]
name = "frame"
material = "wood"
joint = {kind = "weld"}
[[body.shape]]
kind = "box"
size_mm = [50, 50, 900]
[[body]]
name = "leaf"
material = "wood"
mass_kg = 4
position_mm = [400, 0, 0]
[body.joint]
kind = "hinge"
parent = "frame"
axis = [0, 0, 2]
point_mm = [30, 0, 0]
range_deg = [-10, 90]
start_deg = 20
speed_deg_s = 90
stiffness_Nm_per_rad = 0.5
rest_deg = 45
damping_Nms_per_rad = 0.1
friction_Nm = 0.2
[[body.shape]]
kind = "box"
size_mm = [700, 20, 900]
[[body]]
name = "ball"
material = "rubber"
mass_g = 50
position_mm = [0, 0, 800]
velocity_m_s = [1, 2, 3]
angular_velocity_deg_s = [180, 0, 0]
[[body.shape]]
kind = "sphere"
size_mm = [30]
[[force]]
name = "push"
body = "leaf"
force_N = [0, 2, 0]
point_mm = [300, 0, 0]
from_ms = 100
to_s = 0.5
[[drive]]
coordinate = "leaf"
target_deg = 0
stiffness_Nm_per_rad = 3
damping_Nms_per_rad = 0.2
max_effort_Nm = 1.5
speed_deg_s = 10
[[friction]]
coefficient = 0.4
[[friction]]
between = ["ball", "leaf"]
coefficient = 0.7
torsion_radius_mm = 2
restitution = 0.5
[[apart]]
between = ["ball", "jaw/body"]
[stepping]
method = "time-stepping"
duration_s = 2
sample_ms = 5
step_ms = 0.5
)";

SceneSpec parsed(const std::string& text) { return parse_scene(text, "s.toml"); }

/// The scene with one text replaced. The text must be there.
std::string with(const std::string& old, const std::string& text) {
  std::string changed = kScene;
  const std::size_t at = changed.find(old);
  if (at == std::string::npos) throw std::logic_error("not in the scene: " + old);
  return changed.replace(at, old.size(), text);
}

std::string complaint(const std::string& old, const std::string& text) {
  return message_of<DataError>([&] { (void)parsed(with(old, text)); });
}

TEST(Scene, JointsAreReadInSi) {
  const SceneSpec scene = parsed(kScene);
  ASSERT_EQ(scene.bodies.size(), 3U);
  const SceneJointSpec& joint = scene.bodies[1].joint;
  EXPECT_EQ(joint.kind, JointKind::kHinge);
  EXPECT_EQ(joint.parent, "frame");
  EXPECT_TRUE(matrix_near(joint.axis, Eigen::Vector3d(0, 0, 1), 1e-15));
  EXPECT_TRUE(matrix_near(joint.point, Eigen::Vector3d(0.03, 0, 0), 1e-15));
  EXPECT_DOUBLE_EQ(joint.lower, -10 * kDegree);
  EXPECT_DOUBLE_EQ(joint.upper, 90 * kDegree);
  EXPECT_DOUBLE_EQ(joint.start, 20 * kDegree);
  EXPECT_DOUBLE_EQ(joint.speed, 90 * kDegree);
  EXPECT_DOUBLE_EQ(joint.rest, 45 * kDegree);
  EXPECT_EQ(joint.stiffness, 0.5);
  EXPECT_EQ(joint.damping, 0.1);
  EXPECT_EQ(joint.friction, 0.2);
}

TEST(Scene, BodiesAreFreeIfNothingElseIsSaid) {
  const SceneSpec scene = parsed(kScene);
  EXPECT_EQ(scene.bodies[0].joint.kind, JointKind::kWeld);
  EXPECT_EQ(scene.bodies[2].joint.kind, JointKind::kFree);
  EXPECT_TRUE(matrix_near(scene.bodies[2].velocity.linear, Eigen::Vector3d(1, 2, 3), 0));
  EXPECT_NEAR(scene.bodies[2].velocity.angular.x(), kPi, 1e-15);
  EXPECT_TRUE(matrix_near(scene.gravity, Eigen::Vector3d(0, 0, -1.62), 0));
}

TEST(Scene, HandsStandOnJoints) {
  const SceneHandSpec hand = parsed(kScene).hands.at(0);
  EXPECT_EQ(hand.placed.name, "jaw");
  EXPECT_DOUBLE_EQ(hand.placed.posture.at("opening"), 0.04);
  EXPECT_EQ(hand.joint.kind, JointKind::kSlide);
  EXPECT_DOUBLE_EQ(hand.joint.start, 0.005);
  EXPECT_DOUBLE_EQ(hand.joint.speed, 0.02);
  // A hand of which nothing is said is fixed.
  const SceneHandSpec fixed =
      parsed(
          with("joint = {kind = \"slide\", axis = [0, 0, 1], start_mm = 5, speed_mm_s = 20}\n", ""))
          .hands.at(0);
  EXPECT_EQ(fixed.joint.kind, JointKind::kWeld);
}

TEST(Scene, ForcesAndDrivesAreRead) {
  const SceneSpec scene = parsed(kScene);
  const SceneForceSpec& force = scene.forces.at(0);
  EXPECT_EQ(force.name, "push");
  EXPECT_TRUE(matrix_near(force.point.value(), Eigen::Vector3d(0.3, 0, 0), 1e-15));
  EXPECT_DOUBLE_EQ(force.from, 0.1);
  EXPECT_EQ(force.to, 0.5);
  const SceneDriveSpec& drive = scene.drives.at(0);
  EXPECT_EQ(drive.name, "leaf");
  EXPECT_TRUE(drive.turns);
  EXPECT_EQ(drive.stiffness, 3);
  EXPECT_DOUBLE_EQ(drive.speed, 10 * kDegree);
  EXPECT_EQ(drive.max_effort.value(), 1.5);
  EXPECT_EQ(drive.from, 0);
  EXPECT_TRUE(std::isinf(drive.to));
}

TEST(Scene, FrictionApartAndTimeAreRead) {
  const SceneSpec scene = parsed(kScene);
  ASSERT_EQ(scene.frictions.size(), 2U);
  EXPECT_TRUE(scene.frictions[0].between.empty());
  EXPECT_EQ(scene.frictions[0].coefficient.value(), 0.4);
  EXPECT_DOUBLE_EQ(scene.frictions[1].torsion_radius.value(), 0.002);
  EXPECT_EQ(scene.frictions[1].restitution.value(), 0.5);
  EXPECT_EQ(scene.apart.at(0).between, (std::vector<std::string>{"ball", "jaw/body"}));
  EXPECT_EQ(scene.stepping.method, "time-stepping");
  EXPECT_EQ(scene.stepping.duration, 2);
  EXPECT_DOUBLE_EQ(scene.stepping.sample, 0.005);
  EXPECT_DOUBLE_EQ(scene.stepping.step.value(), 0.0005);
  EXPECT_FALSE(scene.stepping.tolerance.has_value());
  EXPECT_FALSE(scene.stepping.modulus.has_value());
}

struct SceneMistake {
  std::string old, text, message;
};
class SceneMistakes : public testing::TestWithParam<SceneMistake> {};

TEST_P(SceneMistakes, AreToldByLine) {
  EXPECT_THAT(complaint(GetParam().old, GetParam().text), StartsWith(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Everywhere, SceneMistakes,
    testing::Values(
        SceneMistake{"name = \"leaf\"", "name = \"ball\"",
                     "s.toml:38: two things are called 'ball'"},
        SceneMistake{"name = \"leaf\"", "name = \"jaw\"", "s.toml:6: two things are called 'jaw'"},
        SceneMistake{"parent = \"frame\"", "parent = \"fram\"",
                     "s.toml:23: there is no body or hand 'fram', did you mean 'frame'?"},
        SceneMistake{"parent = \"frame\"", "parent = \"leaf\"",
                     "s.toml:23: the parents of 'leaf' lead back to themselves"},
        SceneMistake{"parent = \"frame\"", "parent = \"jaw\"",
                     "s.toml:23: 'jaw' is a hand: name one of its links, 'jaw/LINK'"},
        SceneMistake{"mass_kg = 4", "mass_kg = -4", "s.toml:21: wanted 'mass_kg' > 0, got -4"},
        SceneMistake{"kind = \"hinge\"", "kind = \"hing\"",
                     "s.toml:24: wanted 'kind' to be one of weld, hinge, slide, ball, free"},
        SceneMistake{"axis = [0, 0, 2]", "axis = [0, 0, 0]",
                     "s.toml:26: wanted 'axis' as a direction"},
        SceneMistake{"point_mm = [30, 0, 0]\n", "", "s.toml:23: [joint] needs a length (point_mm"},
        SceneMistake{"range_deg = [-10, 90]", "range_deg = [90, -10]",
                     "s.toml:28: wanted 'range' from low to high"},
        SceneMistake{"start_deg = 20", "start_deg = 95",
                     "s.toml:29: wanted 'start' within 'range'"},
        SceneMistake{"start_deg = 20", "start_mm = 20",
                     "s.toml:29: wanted an angle (start_deg, start_rad), got 'start_mm'"},
        SceneMistake{"friction_Nm = 0.2", "friction_Nm = -0.2",
                     "s.toml:34: wanted 'friction_Nm' >= 0, got -0.2"},
        SceneMistake{"material = \"rubber\"", "material = \"ruber\"",
                     "s.toml:40: no material 'ruber', did you mean 'rubber'?"},
        SceneMistake{"joint = {kind = \"weld\"}",
                     "joint = {kind = \"weld\"}\nvelocity_m_s = [1, 0, 0]",
                     "s.toml:15: only what is free has 'velocity'"},
        SceneMistake{"joint = {kind = \"weld\"}", "joint = {kind = \"free\", parent = \"ball\"}",
                     "s.toml:14: what is free has no parent"},
        SceneMistake{"body = \"leaf\"\n", "body = \"lefa\"\n",
                     "s.toml:48: there is no body or hand 'lefa', did you mean 'leaf'?"},
        SceneMistake{"force_N = [0, 2, 0]", "force_N = [0, 0, 0]",
                     "s.toml:48: [[force]] needs a 'force' or a 'moment'"},
        SceneMistake{"to_s = 0.5", "to_s = 0.05", "s.toml:54: wanted 'to' after 'from'"},
        SceneMistake{"coordinate = \"leaf\"", "coordinate = \"jaw\"", "s.toml:55: 'jaw' is a hand"},
        SceneMistake{"target_deg = 0\nstiffness_Nm_per_rad = 3\n", "target_deg = 0\n",
                     "s.toml:57: a 'target' needs a 'stiffness'"},
        SceneMistake{"max_effort_Nm = 1.5", "max_effort_N = 1.5",
                     "s.toml:55: wanted the units of a turn (Nm, deg ..) or those of a slide"},
        SceneMistake{"coefficient = 0.4", "coefficient = -0.4",
                     "s.toml:63: wanted 'coefficient' >= 0, got -0.4"},
        SceneMistake{"restitution = 0.5", "restitution = 1.5",
                     "s.toml:68: wanted 'restitution' in 0..1, got 1.5"},
        SceneMistake{"between = [\"ball\", \"leaf\"]\n", "",
                     "s.toml:64: two [[friction]] are for all pairs"},
        SceneMistake{"between = [\"ball\", \"leaf\"]", "between = [\"ball\", \"ball\"]",
                     "s.toml:65: 'ball' cannot touch itself"},
        SceneMistake{"between = [\"ball\", \"leaf\"]", "between = [\"ball\"]",
                     "s.toml:65: wanted two names in 'between', got 1"},
        SceneMistake{"between = [\"ball\", \"jaw/body\"]", "between = [\"ball\", \"claw\"]",
                     "s.toml:69: there is no body or hand 'claw'"},
        SceneMistake{"duration_s = 2\n", "", "s.toml:71: [stepping] needs a time (duration_ms"},
        SceneMistake{"duration_s = 2", "duration_s = 0", "s.toml:73: wanted 'duration_s' > 0"},
        SceneMistake{"sample_ms = 5", "sample_ms = 1e-9",
                     "s.toml:74: wanted at most 1e+06 samples"},
        SceneMistake{"step_ms = 0.5", "stp_ms = 0.5", "s.toml:75: unknown key 'stp_ms'"},
        SceneMistake{"gravity_m_s2 = [0, 0, -1.62]", "gravity_m_s2 = [0, 0, nan]",
                     "s.toml:3: wanted 'gravity_m_s2' as a finite number"},
        SceneMistake{"source = \"Mine\"\n", "source = \"Yours\"\n", "s.toml:2: source 'Yours'"}));

TEST(Scene, NeedsTimeAndThings) {
  const std::size_t stepping = kScene.find("[stepping]");
  EXPECT_THAT(message_of<DataError>([&] { (void)parsed(kScene.substr(0, stepping)); }),
              HasSubstr("a scene needs [stepping] with its 'duration'"));
  EXPECT_THAT(message_of<DataError>([] {
                (void)parsed(
                    "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n"
                    "[stepping]\nduration_s = 1\n");
              }),
              HasSubstr("a scene needs something that moves: [[body]] or [[hand]]"));
}

TEST(Scene, LongChainsOfParentsAreReadInGoodTime) {
  std::string text =
      "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[stepping]\n"
      "duration_s = 1\n";
  for (int i = 0; i < 3000; ++i)
    text += "[[body]]\nname = \"b" + std::to_string(i) +
            "\"\nmass_g = 1\njoint = {kind = \"weld\"" +
            (i + 1 < 3000 ? ", parent = \"b" + std::to_string(i + 1) + "\"" : "") +
            "}\n[[body.shape]]\nkind = \"sphere\"\nsize_mm = [1]\n";
  EXPECT_EQ(parsed(text).bodies.size(), 3000U);
}

const std::string kHuman =
    "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[[hand]]\nname = \"human\"\n"
    "[stepping]\nduration_s = 1\n";

TEST(Scene, MusclesAreGivenTensionsOrExcitations) {
  const SceneSpec scene =
      parsed(kHuman +
             "[[tendon]]\nhand = \"human\"\ntension_N = {FDP2 = 5, FDS2 = 3}\nfrom_s = 0.5\n"
             "[[muscle]]\nhand = \"human\"\nexcitation = {FPL = 0.3}\n"
             "rung = \"elastic-tendon\"\nto_s = 2\n");
  ASSERT_EQ(scene.muscles.size(), 2U);
  const SceneMuscleSpec &tendon = scene.muscles[0], &muscle = scene.muscles[1];
  EXPECT_TRUE(tendon.tensions);
  EXPECT_EQ(tendon.value.at("FDP2"), 5);
  EXPECT_EQ(tendon.value.at("FDS2"), 3);
  EXPECT_EQ(tendon.from, 0.5);
  EXPECT_FALSE(muscle.tensions);
  EXPECT_EQ(muscle.value.at("FPL"), 0.3);
  EXPECT_EQ(muscle.rung, "elastic-tendon");
  EXPECT_EQ(muscle.to, 2);
}

TEST(Scene, SaysWhatIsWrongWithMuscles) {
  const auto complaint = [](const std::string& more) {
    return message_of<DataError>([&] { (void)parsed(kHuman + more); });
  };
  EXPECT_THAT(message_of<DataError>([] {
                (void)parsed(
                    "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[[hand]]\n"
                    "name = \"human\"\nskin_triangles = 50\n[stepping]\nduration_s = 1\n");
              }),
              HasSubstr("s.toml:7: wanted 'skin_triangles' from 100 to 10000, got 50"));
  EXPECT_THAT(message_of<DataError>([] {
                (void)parsed(
                    "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[[hand]]\n"
                    "name = \"human\"\nskin = \"leather\"\n[stepping]\nduration_s = 1\n");
              }),
              HasSubstr("s.toml:7: wanted 'skin' triangles or capsules, got 'leather'"));
  EXPECT_THAT(complaint("[[tendon]]\nhand = \"humn\"\ntension_N = {FDP2 = 5}\n"),
              HasSubstr("s.toml:9: there is no hand 'humn'"));
  EXPECT_THAT(complaint("[[tendon]]\nhand = \"human\"\n"),
              HasSubstr("s.toml:9: [[tendon]] needs 'tension' or 'tension_file'"));
  EXPECT_THAT(complaint("[[tendon]]\nhand = \"human\"\ntension_N = {FDP2 = -5}\n"),
              HasSubstr("s.toml:11: wanted 'tension_N.FDP2' >= 0"));
  EXPECT_THAT(complaint("[[muscle]]\nhand = \"human\"\nexcitation = {FDP2 = 1.5}\n"),
              HasSubstr("s.toml:11: wanted 'excitation.FDP2'"));
  // Nothing would call it by a name.
  EXPECT_THAT(complaint("[[tendon]]\nhand = \"human\"\nname = \"pinch\"\ntension_N = {FDP2 = 5}\n"),
              HasSubstr("s.toml:11: "));
  EXPECT_THAT(complaint("[[muscle]]\nhand = \"human\"\nexcitation_file = \"no.csv\"\n"),
              HasSubstr("s.toml:11: there is no file"));
}

using SceneFile = TemporaryFolder;

TEST_F(SceneFile, NamesAllThatWasRead) {
  write_file(path("ball.toml"),
             "name = \"ball\"\nsource = \"Mine\"\nmaterial = \"wood\"\n"
             "mass_g = 120\n[sources]\nMine = \"Own\"\n[[shape]]\n"
             "kind = \"sphere\"\nsize_mm = [35]\n");
  write_file(path("s.toml"),
             "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[[body]]\n"
             "file = \"ball.toml\"\nname = \"my ball\"\n[stepping]\nduration_s = 1\n");
  const SceneSpec scene = read_scene(path("s.toml"));
  EXPECT_EQ(scene.bodies.at(0).placed.body.name, "my ball");
  EXPECT_EQ(scene.files.size(), 2U);
  write_file(path("t.toml"),
             "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n[[body]]\n"
             "file = \"bal.toml\"\n[stepping]\nduration_s = 1\n");
  EXPECT_THAT(message_of<DataError>([&] { (void)read_scene(path("t.toml")); }),
              HasSubstr("t.toml:6: there is no file"));
}

}  // namespace
}  // namespace thenar
