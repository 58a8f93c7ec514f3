// Tests for studies/demo/moving_scenes.cpp, on the scenes of the demo.

#include "studies/demo/demo.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "studies/demo/demo_findings.h"
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
  const std::vector<SetPage> pages = moving_scene_pages(motion());
  ASSERT_EQ(pages.size(), 3u);
  for (const std::size_t p : {0u, 1u}) {
    const Json film = first_block(pages[p].page, "scene");
    EXPECT_GE(film["strip"].size(), 6u);
    for (const Json& layer : film["layers"])
      for (const Json& item : layer["items"])
        if (item["kind"] == "mesh") {
          EXPECT_TRUE(pages[p].page["meshes"].contains(item["mesh"].get<std::string>()));
        }
  }
}

// The carpus stands still, the thumb moves: both are parts of one hand.
TEST(MovingScenes, HandsHaveOneColour) {
  const Json film = first_block(moving_scene_pages(motion())[1].page, "scene");
  std::set<std::string> resting, moving;
  for (const Json& layer : film["layers"])
    for (const Json& item : layer["items"])
      if (item.contains("color"))
        (layer["name"] == "stands still" ? resting : moving)
            .insert(item["color"].get<std::string>());
  ASSERT_EQ(resting.size(), 1U);
  EXPECT_EQ(moving.count(*resting.begin()), 1U);
}

// The chart, and with it the page, says what the numbers say.
TEST(MovingScenes, FindingTellsHowFarThePadTurned) {
  const std::vector<PadState>& pad = motion().pad;
  const double turned = (pad.front().angle - pad.back().angle) / kDegree;
  EXPECT_NE(thumb_mug_finding(motion()).line.find(fmt::format("{:.1f} degrees", turned)),
            std::string::npos);
}

}  // namespace
}  // namespace thenar
