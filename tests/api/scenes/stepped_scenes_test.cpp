// Scenes of files that are stepped while their inputs change: dynamics/stepping/scene_stepper.cpp,
// controls of dynamics/human/digit_pull.cpp.

#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "api/scenes/simulate_scene.h"
#include "base/file_io.h"
#include "dynamics/stepping/scene_stepper.h"
#include "dynamics/stepping/simulate_scene.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class SteppedHand : public TemporaryFolder {
 protected:
  /// A human hand beside nothing, with one more entry of its file.
  [[nodiscard]] BuiltScene hand_with(const std::string& entry) const {
    const std::string text = R"(
name = "hand"
description = "A hand"
source = "Scene"
[sources]
Scene = "Arranged for a test"
[[hand]]
name = "human:skewed"
skin_triangles = 100
)" + entry + R"(
[stepping]
method = "time-stepping"
step_ms = 1
duration_s = 1
)";
    write_file(path("hand.toml"), text);
    return open_scene(read_scene(path("hand.toml")), kData).built;
  }
};

SceneState stepped(SceneStepper& stepper, int steps) {
  for (int i = 0; i < steps; ++i) stepper.step();
  return stepper.now().state;
}

// Pads by elements take minutes by fixed steps; all else is here, hands of all kinds among it.
TEST(SteppedScenes, AreThoseOfSimulateScene) {
  const std::set<std::string> slow{"thumb_key"};
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kData + "/scenes")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".toml" || slow.count(name) > 0) continue;
    SCOPED_TRACE(name);
    OpenScene open = open_scene(read_scene(entry.path().string()), kData);
    SceneOptions& options = open.built.options;
    options.method = SteppingMethod::kTimeStepping;
    options.step_length = 1e-3;
    options.duration = 0.06;
    options.sample_interval = 0.02;
    const SceneRun run = simulate_scene(open.built.scene, options);
    SceneStepper stepper(open.built.scene, options);
    (void)stepped(stepper, 17);
    stepper.reset();
    for (const SceneSample& wanted : run.samples) {
      while (stepper.now().state.t < wanted.t - 1e-4) stepper.step();
      EXPECT_EQ(stepper.now().state.t, wanted.t);
      EXPECT_EQ(stepper.now().state.q, wanted.q);
      EXPECT_EQ(stepper.now().state.v, wanted.v);
      EXPECT_EQ(stepper.now().state.z, wanted.z);
    }
    ++scenes;
  }
  EXPECT_GE(scenes, 20);
}

TEST_F(SteppedHand, TensionSetByHandIsThatOfTheFile) {
  const BuiltScene by_file = hand_with(R"(
[[tendon]]
hand = "human:skewed"
tension_N = {FDP2 = 3, FDS2 = 1.5}
)");
  const BuiltScene by_hand = hand_with(R"(
[[tendon]]
hand = "human:skewed"
tension_N = {FDP2 = 0}
)");
  SceneStepper wanted(by_file.scene, by_file.options), got(by_hand.scene, by_hand.options);
  got.set_control("human:skewed/index/FDP2", 3);
  got.set_control("human:skewed/index/FDS2", 1.5);
  const SceneState a = stepped(wanted, 200), b = stepped(got, 200);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.v, b.v);
  EXPECT_EQ(a.z, b.z);
  EXPECT_NE(a.q, by_file.scene.q);
  // The readings say so, and controls say what is set.
  for (const ElementValue& value : got.readings())
    if (value.name == "human:skewed/index/FDP2") {
      EXPECT_EQ(value.value, 3);
    }
  int set = 0;
  for (const ElementControl& control : got.controls()) set += control.set ? 1 : 0;
  EXPECT_EQ(set, 2);
}

TEST_F(SteppedHand, ExcitationSetByHandIsThatOfTheFile) {
  const BuiltScene by_file = hand_with(R"(
[[muscle]]
hand = "human:skewed"
rung = "bounds"
excitation = {FDP2 = 0.02}
)");
  const BuiltScene by_hand = hand_with(R"(
[[muscle]]
hand = "human:skewed"
rung = "bounds"
excitation = {FDP2 = 0}
)");
  SceneStepper wanted(by_file.scene, by_file.options), got(by_hand.scene, by_hand.options);
  std::string name;
  for (const ElementControl& control : got.controls())
    if (control.name.find("FDP2") != std::string::npos) {
      name = control.name;
      EXPECT_EQ(control.unit, "1");
      EXPECT_EQ(control.upper, 1);
    }
  got.set_control(name, 0.02);
  const SceneState a = stepped(wanted, 100), b = stepped(got, 100);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.z, b.z);
  EXPECT_THROW(got.set_control(name, 1.5), InputError);
  EXPECT_NE(message_of([&] { got.set_control(name + "x", 0); }).find("did you mean"),
            std::string::npos);
}

// Controls stay when the stepper goes back to an instant, and end with a reset.
TEST_F(SteppedHand, ControlsLastUntilTheReset) {
  const BuiltScene built = hand_with(R"(
[[tendon]]
hand = "human:skewed"
tension_N = {FDP2 = 0}
)");
  SceneStepper stepper(built.scene, built.options);
  const SceneState slack = stepped(stepper, 20);
  stepper.reset();
  stepper.set_control("human:skewed/index/FDP2", 5);
  (void)stepped(stepper, 10);
  const SceneInstant branch = stepper.now();
  const SceneState first = stepped(stepper, 10);
  stepper.go_to(branch);
  const double same = (stepped(stepper, 10).q - first.q).norm();
  EXPECT_LT(same, 1e-8);  // slopes of arms are found anew [rad]
  EXPECT_GT((first.q - slack.q).norm(), 1e4 * same);
  stepper.reset();
  EXPECT_EQ(stepped(stepper, 20).q, slack.q);
}

}  // namespace
}  // namespace thenar
