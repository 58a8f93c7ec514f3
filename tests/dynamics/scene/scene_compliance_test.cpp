// Tests for dynamics/scene/scene_compliance.cpp: joints of scenes that give.

#include "dynamics/scene/scene_compliance.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dynamics/scene/build_scene.h"
#include "dynamics/scene/measure_run.h"
#include "dynamics/stepping/contact_step.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::StartsWith;

const std::string kTop = "name = \"x\"\nsource = \"Mine\"\n[sources]\nMine = \"Own\"\n";
const std::string kEnd = "[stepping]\nduration_s = 2\n";

BuiltScene build(const std::string& text, const std::vector<SceneHand>& robots = {}) {
  return build_scene(parse_scene(kTop + text + kEnd, "s.toml"), robots);
}

/// A rod of 100 g that lies along x from a hinge about y.
const std::string kRod = R"([[body]]
name = "rod"
mass_g = 100
position_mm = [50, 0, 0]
[body.joint]
kind = "hinge"
axis = [0, 1, 0]
point_mm = [0, 0, 0]
start_deg = 30
[[body.shape]]
kind = "box"
size_mm = [100, 10, 10]
)";
const std::string kGives = R"([[compliance]]
joint = "rod"
translation_N_per_mm = [50, 50, 50]
translation_damping_Ns_per_m = 100
rotation_Nm_per_rad = [4, 2]
rotation_damping_Nms_per_rad = 0.02
)";

// Held at its angle, the rod sinks by its weight over the stiffness, and what it carries with it.
TEST(SceneCompliance, LetsARodSink) {
  const BuiltScene built = build(kRod + kGives +
                                 "[[body]]\nname = \"bob\"\nmass_g = 100\n"
                                 "position_mm = [150, 0, 0]\n[body.joint]\nkind = \"weld\"\n"
                                 "parent = \"rod\"\n[[body.shape]]\nkind = \"sphere\"\n"
                                 "size_mm = [10]\n[[drive]]\ncoordinate = \"rod\"\n"
                                 "target_deg = 30\nstiffness_Nm_per_rad = 1e6\n"
                                 "damping_Nms_per_rad = 1e3\n");
  ASSERT_EQ(built.scene.elements.size(), 1u);
  const Mechanism& mechanism = built.scene.mechanism;
  EXPECT_EQ(mechanism.coordinates[5].name, "rod/twist");
  EXPECT_EQ(built.owner[0], "rod");
  ContactStep step(built.scene);
  std::vector<Pose<double>> start, end;
  step.compute_poses(step.initial_state(), start);
  const auto rod = static_cast<std::size_t>(body_named(mechanism, "rod"));
  EXPECT_LT((start[rod].p - Eigen::Vector3d(0.05, 0, 0)).norm(), 1e-12);
  EXPECT_LT((start[rod].R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  const SceneRun run = simulate_scene(built.scene, built.options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  step.compute_poses({0, run.samples.back().q, run.samples.back().v, run.samples.back().z}, end);
  const double sunk = 0.2 * 9.81 / 50e3;  // [m]
  EXPECT_NEAR(end[rod].p.z(), -sunk, 0.02 * sunk);
  EXPECT_NEAR(end[rod].p.x(), 0.05, 1e-8);
}

// data/scenes/loose_joint.toml: the deviation solves  k s sinh(a / s) = F L cos a.
TEST(SceneCompliance, DeviatesAsTheSampleSays) {
  const BuiltScene built = build_scene(read_scene(kData + "/scenes/loose_joint.toml"), {});
  const SceneRun run = simulate_scene(built.scene, built.options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  double a = 0.1;
  for (int i = 0; i < 100; ++i) a = 0.1 * std::asinh(0.4 * std::cos(a) / 0.15);
  ASSERT_EQ(built.scene.mechanism.coordinates[4].name, "phalanx/abduction");
  const MechanismLayout layout = layout_of(built.scene.mechanism);
  EXPECT_NEAR(std::abs(run.samples.back().q[layout.coordinate_q[4]]), a, 1e-6);
  // The force works along its end's way; the capsule keeps k s^2 (cosh(a / s) - 1) and half of what
  // the shift takes, its dampers have the rest.
  const double shift = 10 / 1e5, way = 0.04 * std::sin(a) + shift;
  const double kept = 1.5 * 0.01 * (std::cosh(a / 0.1) - 1) + 0.5 * 10 * shift;
  const RunMeasures measures = measure_run(built.scene, run);
  EXPECT_NEAR(measures.work, 10 * way, 1e-7);
  EXPECT_NEAR(run.samples.back().energy.springs, kept, 1e-7);
  EXPECT_NEAR(measures.dissipated, 10 * way - kept, 1e-7);
}

// A ball of 100 g on a cord of 40 mm from the world: it sinks by  L0 sqrt(4 e_l m g / K).
TEST(SceneLigament, CarriesABall) {
  const std::string ball =
      "[[body]]\nname = \"ball\"\nmass_g = 100\n[[body.shape]]\nkind = \"sphere\"\n"
      "size_mm = [10]\n";
  const BuiltScene built =
      build(ball +
            "[[ligament]]\nto = \"ball\"\nto_point_mm = [0, 0, 0]\nfrom_point_mm = [0, 0, 40]\n"
            "stiffness_N = 2000\ndamping_ms = 200\n");
  ASSERT_EQ(built.scene.elements.size(), 1u);
  EXPECT_EQ(built.scene.elements[0]->name(), "ligament of ball");
  const SceneRun run = simulate_scene(built.scene, built.options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const double strain = std::sqrt(4 * 0.03 * 0.1 * 9.81 / 2000);
  EXPECT_NEAR(run.samples.back().q[6], -0.04 * strain, 1e-7);
  EXPECT_THAT(message_of<DataError>([&] {
                (void)build(ball +
                            "[[ligament]]\nto = \"ball\"\nto_point_mm = [0, 0, 0]\n"
                            "from_point_mm = [0, 0, 0]\nstiffness_N = 2000\n");
              }),
              StartsWith("s.toml:11: ligament: wanted a slack length above 0"));
}

TEST(SceneCompliance, TellsTheLineOfWhatCannotGive) {
  EXPECT_THAT(message_of<DataError>([&] {
                (void)build(kGives +
                            "[[body]]\nname = \"rod\"\nmass_g = 1\n[[body.shape]]\n"
                            "kind = \"sphere\"\nsize_mm = [10]\n");
              }),
              StartsWith("s.toml:5: joint 'rod' is a free: only hinges give"));
}

// Joints of hands by name; posture and drives stay as they are.
TEST(SceneCompliance, GivesToJointsOfHands) {
  const RobotSpec hand = read_robot(kData + "/robots/allegro.toml");
  const std::string text = "[[hand]]\nname = \"allegro\"\n";
  const BuiltScene pins = build(text, {hand});
  std::string gives = kGives + "bone = [0, 0, 1]\n";
  gives.replace(gives.find("rod"), 3, "allegro/joint_1.0");
  const BuiltScene built = build(text + gives, {hand});
  EXPECT_EQ(built.scene.mechanism.coordinates.size(), pins.scene.mechanism.coordinates.size() + 5);
  EXPECT_EQ(built.scene.mechanism.bodies.size(), pins.scene.mechanism.bodies.size() + 5);
  // All links stand where they stood.
  ContactStep a(pins.scene), b(built.scene);
  std::vector<Pose<double>> X_a, X_b;
  a.compute_poses(a.initial_state(), X_a);
  b.compute_poses(b.initial_state(), X_b);
  for (std::size_t i = 0; i < X_a.size(); ++i) {
    const int j = body_named(built.scene.mechanism, pins.scene.mechanism.bodies[i].name);
    EXPECT_LT((X_a[i].p - X_b[static_cast<std::size_t>(j)].p).norm(), 1e-12);
  }
}

/// Two cranks of 100 mm side by side, and a coupler of 200 mm on one of them: a parallelogram,
/// whose loop a bushing closes.
const std::string kParallelogram = R"([[body]]
name = "left"
mass_g = 100
position_mm = [0, 0, 50]
joint = {kind = "hinge", axis = [0, 1, 0], point_mm = [0, 0, 0]}
[[body.shape]]
kind = "box"
size_mm = [10, 10, 100]
[[body]]
name = "right"
mass_g = 100
position_mm = [200, 0, 50]
joint = {kind = "hinge", axis = [0, 1, 0], point_mm = [200, 0, 0], speed_rad_s = 2}
[[body.shape]]
kind = "box"
size_mm = [10, 10, 100]
[[body]]
name = "coupler"
mass_g = 200
position_mm = [100, 20, 100]
joint = {kind = "hinge", axis = [0, 1, 0], point_mm = [0, 0, 100], parent = "left"}
[[body.shape]]
kind = "box"
size_mm = [200, 10, 10]
)";

// With both cranks at the same angle and the coupler in translation, it is a pendulum upside down:
//   (2 m l^2 / 3 + M l^2) a'' = (m + M) g l sin a,   energy of motion and weight kept.
TEST(SceneCompliance, ABushingClosesALoop) {
  std::string text = kParallelogram;
  text.replace(text.find("point_mm = [0, 0, 0]"), 20, "point_mm = [0, 0, 0], speed_rad_s = 2");
  text.replace(text.find("parent = \"left\""), 15, "parent = \"left\", speed_rad_s = -2");
  text +=
      "[[bushing]]\nfrom = \"right\"\nto = \"coupler\"\npoint_mm = [200, 0, 100]\n"
      "axis = [0, 1, 0]\ntranslation_N_per_mm = [1e4, 1e4, 1e4]\n"
      "translation_damping_Ns_per_m = 2e3\n[[apart]]\nbetween = [\"right\", \"coupler\"]\n"
      "[[apart]]\nbetween = [\"left\", \"coupler\"]\n";
  BuiltScene built = build(text);
  built.options.duration = 0.3;
  const SceneRun run = simulate_scene(built.scene, built.options);
  ASSERT_EQ(run.status, SceneStatus::kDone);
  const MechanismLayout layout = layout_of(built.scene.mechanism);
  const auto& at = run.samples.back();
  const double a = at.q[layout.coordinate_q[0]], rate = at.v[layout.coordinate_v[0]];
  EXPECT_GT(a, 0.6);
  // Some 10 N over 1e7 N/m, on a crank of 0.1 m.
  EXPECT_NEAR(at.q[layout.coordinate_q[1]], a, 2e-5);
  EXPECT_NEAR(at.q[layout.coordinate_q[2]], -a, 2e-5);
  // A box of 10 x 100 mm about its end.
  const double l = 0.1, m = 0.1, M = 0.2, g = 9.81;
  const double end = m * ((l * l + 0.01 * 0.01) / 12 + l * l / 4);
  const double inertia = 2 * end + M * l * l, moment = (m + M) * g * l;
  EXPECT_NEAR(rate * rate, 4 + 2 * moment * (1 - std::cos(a)) / inertia, 2e-3);
}

TEST(SceneCompliance, RefusesABushingWithoutSprings) {
  EXPECT_THAT(message_of<DataError>(
                  [&] { (void)build(kRod + "[[bushing]]\nto = \"rod\"\npoint_mm = [0, 0, 0]\n"); }),
              testing::HasSubstr("needs a 'translation' or 'rotation'"));
  EXPECT_THAT(message_of<DataError>([&] {
                (void)build(kRod +
                            "[[bushing]]\nto = \"rood\"\npoint_mm = [0, 0, 0]\n"
                            "translation_N_per_mm = [1, 1, 1]\n");
              }),
              testing::HasSubstr("there is no body or hand 'rood', did you mean 'rod'"));
}

}  // namespace
}  // namespace thenar
