// Tests for live/live_pads.cpp.

#include "live/world/live_pads.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "live/world/world_files.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

std::unique_ptr<LiveWorld> human_on_mug() {
  auto live = std::make_unique<LiveWorld>(LiveWorldFolders{kData, "."});
  (void)load_world(*live, "human_mug");
  (void)grasp_object(*live, {}, 1);
  return live;
}

TEST(LivePads, PressuresAddUpToTheForceOfEveryPad) {
  const auto live = human_on_mug();
  for (const double force : {0.1, 0.25}) {  // the wall of 4 mm lets no pad sink deeper than 2 mm
    const LivePads found = press_pads(*live, {}, force);
    ASSERT_GE(found.pads.size(), 4U);
    for (const LoadedPad& pad : found.pads) {
      EXPECT_NEAR(pad.force, force, 0.03 * force) << pad.link;  // columns come one by one
      EXPECT_GT(pad.area, 0);
      EXPECT_FALSE(pad.points.empty());
      for (const PadPoint& point : pad.points) EXPECT_GT(point.pressure, 0);
    }
  }
}

TEST(LivePads, GrowWithTheForce) {
  const auto live = human_on_mug();
  const LivePads light = press_pads(*live, {}, 0.05), heavy = press_pads(*live, {}, 0.25);
  ASSERT_EQ(light.pads.size(), heavy.pads.size());
  for (std::size_t i = 0; i < light.pads.size(); ++i) {
    EXPECT_GT(heavy.pads[i].area, light.pads[i].area);
    EXPECT_GT(heavy.pads[i].depth, light.pads[i].depth);
  }
}

TEST(LivePads, ThatDoNotComeToTheirForceSaySo) {
  const auto live = human_on_mug();
  const LivePads found = press_pads(*live, {}, 50);
  EXPECT_THAT(found.reasons, testing::Contains(testing::HasSubstr("reach through mug")));
}

TEST(LivePads, SlipFirstAtTheRimUnderTheWeight) {
  const auto live = human_on_mug();
  // The mug weighs 3 N: light pads slip in part, firmly pressed ones stick more.
  const LivePads light = press_pads(*live, {}, 0.3), firm = press_pads(*live, {}, 2);
  double slipping = 0, still = 0;
  for (const LoadedPad& pad : light.pads) slipping += 1 - pad.stick;
  for (const LoadedPad& pad : firm.pads) still += 1 - pad.stick;
  EXPECT_GT(slipping, still);
  // What slips is pressed less than what sticks, on the whole.
  for (const LoadedPad& pad : light.pads) {
    double stick = 0, slip = 0;
    int sticking = 0, sliding = 0;
    for (const PadPoint& point : pad.points) {
      (point.sticks ? stick : slip) += point.pressure;
      ++(point.sticks ? sticking : sliding);
    }
    if (sticking > 0 && sliding > 0) {
      EXPECT_GT(stick / sticking, slip / sliding) << pad.link;
    }
  }
}

TEST(LivePads, OfRigidHandsAreNoneAndSayWhy) {
  LiveWorld live({kData, "."});
  (void)load_world(live, "barrett_bobbin");
  EXPECT_THAT(press_pads(live, {}, 1).reasons,
              testing::ElementsAre("hand 'barrett' does not touch 'bobbin'"));
  (void)grasp_object(live, {}, 1);
  const LivePads found = press_pads(live, {}, 1);
  EXPECT_TRUE(found.pads.empty());
  EXPECT_THAT(found.reasons, testing::Contains(testing::HasSubstr("has no soft layer")));
  for (const double force : {0.0, -1.0, std::nan("")})
    EXPECT_THROW((void)press_pads(live, {}, force), InputError);
}

}  // namespace
}  // namespace thenar
