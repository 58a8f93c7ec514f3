// Tests for report/pages/moving_scenes.cpp, on the scenes of the demo.

#include "report/pages/demo.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

const DemoMotion& motion() {
  static const DemoMotion made = move_demo_scenes(kData);
  return made;
}

const PadState& at_force(const std::vector<PadState>& states, double force) {
  return *std::min_element(states.begin(), states.end(), [&](const PadState& a, const PadState& b) {
    return std::abs(a.force - force) < std::abs(b.force - force);
  });
}

// Muscles balance the force on pins, whatever it is; joints that give turn on with it, from what
// is at once more than a facet of the skin. The ladder of the thumb on a mug compares the numbers.
TEST(MovingScenes, ThumbRollsOnJointsThatGiveAlone) {
  const double pinned = at_force(motion().pad_on_pins, 5).angle;
  double before = pinned - 5 * kDegree;
  for (const double force : {10.0, 20.0, 30.0}) {
    EXPECT_NEAR(at_force(motion().pad_on_pins, force).angle, pinned, 0.1 * kDegree);
    const double angle = at_force(motion().pad, force).angle;
    EXPECT_LT(angle, before);
    before = angle;
  }
}

// A tolerance of 1e-9 comes nearer than steps of 10 us do, with a tenth of the steps or less.
TEST(MovingScenes, EventsAreMoreAccurateForTheirSteps) {
  const WorkPoint *events = nullptr, *fixed = nullptr;
  for (const WorkPoint& point : motion().work) {
    EXPECT_EQ(point.status, SceneStatus::kDone);
    if (point.method == SteppingMethod::kEvents && point.setting == 1e-9) events = &point;
    if (point.method == SteppingMethod::kTimeStepping && point.setting == 1e-5) fixed = &point;
  }
  ASSERT_TRUE(events != nullptr && fixed != nullptr);
  EXPECT_LT(events->error, 1e-9);
  EXPECT_LT(events->error, fixed->error);
  EXPECT_LT(10 * events->steps, fixed->steps);
}

TEST(MovingScenes, FilmsNameMeshesThatThePageHas) {
  MeshTable meshes;
  const Json sections = moving_scene_sections(motion(), meshes);
  ASSERT_EQ(sections.size(), 3u);
  for (const std::size_t s : {0u, 1u}) {
    const Json& film = sections[s]["blocks"][1];
    ASSERT_EQ(film["type"], "scene");
    EXPECT_GE(film["strip"].size(), 6u);
    for (const Json& layer : film["layers"])
      for (const Json& item : layer["items"])
        if (item["kind"] == "mesh") {
          EXPECT_TRUE(meshes.json().contains(item["mesh"].get<std::string>()));
        }
  }
}

}  // namespace
}  // namespace thenar
