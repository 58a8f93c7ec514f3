// Tests for dynamics/scene/scene_pads.cpp: pads on the links of robot hands.

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dynamics/mechanism/tree_motion.h"
#include "dynamics/scene/scene_pads.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/data_folder.h"
#include "tests/matrix_near.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kFreeFall = 9.81;
constexpr double kCubeWeight = 0.0216 * kFreeFall;  // of the cube [N]

const std::string kSoftJaws = kData + "/scenes/soft_jaws.toml";

RobotSpec robot_named(const std::string& name) {
  return read_robot(kData + "/robots/" + name + ".toml");
}

SceneRun run_of(const BuiltScene& built) { return simulate_scene(built.scene, built.options); }

/// A gripper whose jaws hold a cube that is free, with pads flush with their faces, pressed by 1 mm
/// times their scale at the start.
struct Grip {
  bool jaws_up = false;
  double gravity = 0;  // upward [m/s^2]
  std::string rung = "soft-finger";
  double scale = 1;   // of the pads
  double effort = 1;  // of the motor [N]
  double cube = 20;   // its edges [mm]
  double duration = 0.1, force_error = 0.05;

  [[nodiscard]] std::string text() const {
    std::string out = fmt::format(
        "name = \"x\"\nsource = \"Mine\"\ngravity_m_s2 = [0, 0, {0}]\n[sources]\nMine = \"Own\"\n"
        "[[hand]]\nname = \"parallel_jaw\"\nposition_mm = [0, 0, {1}]\naxis = [1, 0, 0]\n"
        "angle_deg = {2}\nways_mm = {{opening = {3}}}\n"
        "[[body]]\nname = \"cube\"\nmass_g = 21.6\n[[body.shape]]\nkind = \"box\"\n"
        "size_mm = [{4}, {4}, {4}]\n[[friction]]\ncoefficient = 1\n"
        "[[drive]]\ncoordinate = \"parallel_jaw/opening\"\neffort_N = {5}\n"
        "damping_Ns_per_m = {7}\n[stepping]\ntolerance = 1e-6\nsample_ms = 10\nduration_s = {6}\n",
        gravity, jaws_up ? -50 : 50, jaws_up ? 90 : -90, cube / 2 - scale, cube, -effort, duration,
        50 * scale);
    for (const int side : {-1, 1})
      out += fmt::format(
          "[[pad]]\non = \"parallel_jaw/{0} jaw\"\nagainst = [\"cube\"]\nrung = \"{1}\"\n"
          "scale = {2}\nforce_error = {3}\nposition_mm = [{4}, 50, 0]\n"
          "rotation = [[0, 0, {5}], [1, 0, 0], [0, {5}, 0]]\n",
          side < 0 ? "left" : "right", rung, scale, force_error, side * 10 * scale, -side);
    return out;
  }
  [[nodiscard]] BuiltScene built() const {
    return build_scene(parse_scene(text(), "s.toml"), {robot_named("parallel_jaw")});
  }
  [[nodiscard]] SceneRun run() const { return run_of(built()); }
};

/// Where the motor of the jaws stands, which closes from half of the cube's edge [m].
double depth_at_end(const Grip& grip, const SceneRun& run) {
  return grip.cube / 2 * 1e-3 - run.samples.back().q[0];
}

/// Forces of the left and the right jaw on the cube [N].
std::pair<Vector3d, Vector3d> on_the_cube(const SceneSample& sample) {
  EXPECT_EQ(sample.contacts.size(), 2U);
  // Forces are on the first body of a contact: the jaws, which come before the cube.
  return {-sample.contacts.at(0).force, -sample.contacts.at(1).force};
}

class SoftJaws : public testing::TestWithParam<std::string> {
 protected:
  /// The scene on this rung.
  static BuiltScene built(SceneSpec spec, double seconds) {
    for (ScenePadSpec& pad : spec.pads) pad.rung = GetParam();
    spec.stepping.duration = seconds;
    return build_scene(spec, {robot_named("parallel_jaw")});
  }
  /// The same with a block of 40 mm in place of the cube, lifted by 3 mm.
  static BuiltScene high_block(double friction) {
    SceneSpec spec = read_scene(kSoftJaws);
    for (ScenePadSpec& pad : spec.pads) pad.friction = friction;
    spec.bodies.at(0).placed.body.shapes.at(0).size.z() = 0.04;
    spec.bodies.at(1).placed.X_WB.p.z() -= 0.01;
    return built(spec, 1.1);
  }
};

TEST_P(SoftJaws, LiftTheCubeAndHoldIt) {
  const BuiltScene scene = built(read_scene(kSoftJaws), 2.5);
  const SceneRun run = run_of(scene);
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const SceneSample& end = run.samples.back();
  // 30 mm, less what pads shear.
  EXPECT_GT(end.q.tail<1>()[0], 27.5e-3);
  Vector3d sum(0, 0, 0);
  const int cube = body_named(scene.scene.mechanism, "cube");
  for (const ContactSample& contact : end.contacts) {
    const Vector3d f = contact.a == cube ? contact.force : Vector3d(-contact.force);
    EXPECT_LE(std::hypot(f.y(), f.z()), std::abs(f.x()) * (1 + 1e-9)) << "friction 1";
    sum += f;
  }
  EXPECT_TRUE(matrix_near(sum, Vector3d(0, 0, kCubeWeight), 0.01 * kCubeWeight));
  EXPECT_LT(end.v.tail<3>().norm(), 1e-3) << "creeps at most";
}

// 1 N of grip carries 0.212 N from a friction of 0.212 on. The block is high, so that its edges are
// far from the pads, which slide on it by 3 mm; hard jaws tip
// it by micrometres.
TEST_P(SoftJaws, CarryFromTheFrictionOfStaticsOn) {
  const SceneRun slides = run_of(high_block(0.2)), holds = run_of(high_block(0.23));
  ASSERT_EQ(slides.status, SceneStatus::kDone) << slides.message;
  ASSERT_EQ(holds.status, SceneStatus::kDone) << holds.message;
  EXPECT_NEAR(slides.samples.back().q.tail<1>()[0], 0, 1e-5) << "is left on its post";
  EXPECT_GT(holds.samples.back().q.tail<1>()[0], 0.5e-3) << "is carried, of 3 mm";
}

INSTANTIATE_TEST_SUITE_P(RobotPad, SoftJaws,
                         testing::Values("elements", "foundation", "soft-finger", "power-law",
                                         "hard-point"));

class RobotPadRung : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] Grip grip() const {
    Grip out;
    out.rung = GetParam();
    return out;
  }
};

// Jaws of a mirror image, one motor: forces mirror each other at every instant.
TEST_P(RobotPadRung, BothJawsCarryTheSame) {
  Grip held = grip();
  held.gravity = -kFreeFall;
  const SceneRun run = held.run();
  ASSERT_EQ(run.status, SceneStatus::kDone) << run.message;
  const bool elements = held.rung == "elements";
  for (std::size_t i = 1; i < run.samples.size(); ++i) {
    const auto [left, right] = on_the_cube(run.samples[i]);
    EXPECT_TRUE(matrix_near(left, Vector3d(-right.x(), right.y(), right.z()), 1e-6))
        << run.samples[i].t;
    EXPECT_GT(left.x(), 0);
    EXPECT_NEAR(run.samples[i].contacts[0].area, run.samples[i].contacts[1].area,
                elements ? 1e-9 : 1e-10);
  }
}

// Upside down is the world turned with its gravity, half round about the jaws' way.
TEST_P(RobotPadRung, UpsideDownIsTheWorldTurned) {
  Grip upright = grip(), turned = grip();
  upright.gravity = kFreeFall;
  turned.gravity = -kFreeFall;
  turned.jaws_up = true;
  const SceneRun a = upright.run(), b = turned.run();
  ASSERT_EQ(a.status, SceneStatus::kDone) << a.message;
  ASSERT_EQ(b.status, SceneStatus::kDone) << b.message;
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 1; i < a.samples.size(); ++i) {
    const Vector3d f = on_the_cube(a.samples[i]).first, g = on_the_cube(b.samples[i]).first;
    EXPECT_TRUE(matrix_near(g, Vector3d(f.x(), -f.y(), -f.z()), 1e-6)) << a.samples[i].t;
  }
  // Held against its weight, not let go.
  EXPECT_GT(on_the_cube(b.samples.back()).first.z(), 0.25 * kCubeWeight);
  EXPECT_GT(b.samples.back().q.tail<1>()[0], -5e-3);
}

// Stress depends on strain alone: with a quarter of the force half of the depth.
TEST_P(RobotPadRung, HalfThePadYieldsHalfUnderAQuarter) {
  Grip whole = grip(), half = grip();
  whole.force_error = half.force_error = 0.005;
  half.scale = 0.5;
  half.effort = whole.effort / 4;
  half.cube = whole.cube / 2;
  whole.duration = half.duration = 0.15;
  const SceneRun a = whole.run(), b = half.run();
  ASSERT_EQ(a.status, SceneStatus::kDone) << a.message;
  ASSERT_EQ(b.status, SceneStatus::kDone) << b.message;
  EXPECT_NEAR(depth_at_end(half, b), depth_at_end(whole, a) / 2, 0.02 * depth_at_end(half, b));
  EXPECT_NEAR(b.samples.back().contacts[0].area, a.samples.back().contacts[0].area / 4,
              0.02 * b.samples.back().contacts[0].area);
}

INSTANTIATE_TEST_SUITE_P(Soft, RobotPadRung,
                         testing::Values("elements", "foundation", "soft-finger", "power-law"));

// A pad of half the lengths by its own numbers is the pad at scale 0.5.
TEST(RobotPads, ScaledPadIsThatOfHalfTheNumbers) {
  Grip scaled;
  scaled.rung = "elements";
  scaled.scale = 0.5;
  scaled.cube = 10;
  scaled.effort = 0.25;
  SceneSpec own = parse_scene(scaled.text(), "s.toml");
  for (ScenePadSpec& pad : own.pads) {
    pad.scale = 1;
    PadSpec& half = pad.spec;
    for (double* length : {&half.length, &half.width, &half.height, &half.bone_length,
                           &half.bone_width, &half.bone_height})
      *length *= 0.5;
  }
  const SceneRun a = scaled.run(), b = run_of(build_scene(own, {robot_named("parallel_jaw")}));
  ASSERT_EQ(a.status, SceneStatus::kDone) << a.message;
  ASSERT_EQ(a.samples.size(), b.samples.size());
  for (std::size_t i = 0; i < a.samples.size(); ++i)
    EXPECT_TRUE(matrix_near(a.samples[i].q, b.samples[i].q, 1e-9)) << a.samples[i].t;
}

/// A Franka hand over a cube on a slide, with a pad on one of its links.
std::string on_franka(const std::string& pad) {
  return "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n"
         "[[hand]]\nname = \"franka_hand\"\n"
         "[[drive]]\ncoordinate = \"franka_hand/panda_finger_joint1\"\ntarget_mm = 40\n"
         "stiffness_N_per_m = 1000\ndamping_Ns_per_m = 10\n"
         "[[body]]\nname = \"cube\"\nmass_g = 30\nposition_mm = [0, 0, 143.6]\n"
         "joint = {kind = \"slide\", axis = [0, 0, 1], damping_Ns_per_m = 3}\n"
         "[[body.shape]]\nkind = \"box\"\nsize_mm = [20, 20, 20]\n"
         "[[friction]]\ncoefficient = 1\n"
         "[stepping]\nduration_s = 0.3\ntolerance = 1e-8\n"
         "[[pad]]\non = \"franka_hand/" +
         pad + "rung = \"soft-finger\"\n";
}
constexpr int kFrankaPadLine = 25;

// The tip frame is fixed to the palm 103.4 mm along z, and has no shape of its own.
TEST(RobotPads, LinkOnAFixedJointCarriesAPad) {
  const auto run = [](const std::string& pad) {
    return run_of(build_scene(parse_scene(on_franka(pad), "s.toml"), {robot_named("franka_hand")}));
  };
  const std::string against = "against = [\"cube\"]\n";
  const SceneRun tip = run("panda_hand_tcp\"\n" + against + "position_mm = [0, 0, 20]\n");
  const SceneRun palm = run("panda_hand\"\n" + against + "position_mm = [0, 0, 123.4]\n");
  ASSERT_EQ(tip.status, SceneStatus::kDone) << tip.message;
  ASSERT_EQ(tip.samples.back().contacts.size(), 1U);
  EXPECT_GT(std::abs(tip.samples.back().contacts[0].force.z()), 0.5 * 0.03 * kFreeFall);
  EXPECT_TRUE(matrix_near(tip.samples.back().q, palm.samples.back().q, 1e-9));
}

TEST(RobotPads, SayAtTheirLineWhatDoesNotFit) {
  const auto error_of = [](const std::string& pad, const std::string& more = "") {
    return message_of<DataError>([&] {
      (void)build_scene(parse_scene(on_franka(pad) + more, "s.toml"), {robot_named("franka_hand")});
    });
  };
  const std::string at = fmt::format("s.toml:{}: ", kFrankaPadLine);
  const std::string against = "against = [\"cube\"]\n", here = "position_mm = [0, 0, 0]\n";
  EXPECT_THAT(error_of("panda_leftfingr\"\n" + against + here),
              AllOf(StartsWith(at), HasSubstr("did you mean 'franka_hand/panda_leftfinger'?")));
  EXPECT_THAT(error_of("panda_leftfinger\"\n" + against),
              AllOf(StartsWith(at + "a pad needs a 'position': 'franka_hand/panda_leftfinger'"),
                    HasSubstr("give 'position_mm' and 'rotation'"), HasSubstr("x distal")));
  // Neither the tip frame nor what is welded to the palm moves against it.
  EXPECT_THAT(error_of("panda_hand_tcp\"\nagainst = [\"franka_hand/panda_hand\"]\n" + here),
              StartsWith(at + "'franka_hand/panda_hand_tcp' and 'franka_hand/panda_hand' do not "
                              "move against each other"));
  EXPECT_THAT(error_of("panda_hand_tcp\"\nagainst = [\"table\"]\n" + here,
                       "[[body]]\nname = \"table\"\njoint = {kind = \"weld\"}\n[[body.shape]]\n"
                       "kind = \"sphere\"\nsize_mm = [10]\nposition_mm = [500, 0, 0]\n"),
              StartsWith(at + "'franka_hand/panda_hand_tcp' and 'table' do not move"));
}

}  // namespace
}  // namespace thenar
