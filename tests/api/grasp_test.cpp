// Tests for api/grasp.cpp.

#include "api/grasp.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

GraspRequest bobbin() {
  GraspRequest request;
  request.world.world = "barrett_bobbin";
  request.world.data = kData;
  return request;
}

TEST(GraspInWorld, OwnsWhatItFound) {
  GraspResult found = grasp_in_world(bobbin());
  const GraspResult copy = found;
  found = GraspResult{};  // its hand lives on in the copy
  EXPECT_TRUE(copy.complete);
  EXPECT_EQ(copy.started(), 1);
  EXPECT_EQ(copy.grasp.outcome, GraspOutcome::kGrasped);
  EXPECT_EQ(copy.collision_hand.hand, copy.setting.hand.named.hand.get());
  EXPECT_FALSE(copy.collision_hand.hand->surfaces().empty());
  ASSERT_TRUE(copy.measures);
  EXPECT_FALSE(copy.robustness);  // not asked
}

TEST(GraspInWorld, SavesTheHandWhereItEnded) {
  const GraspResult found = grasp_in_world(bobbin());
  const WorldSpec world = grasped_world(found);
  ASSERT_EQ(world.hands.size(), 1U);
  EXPECT_TRUE(world.hands[0].X_WH.p.isApprox(found.grasp.approached.X_WH.p));
  GraspResult none = found;
  none.grasp.outcome = GraspOutcome::kMissed;
  EXPECT_THROW((void)grasped_world(none), InputError);
}

TEST(GraspInWorld, CountsEveryStart) {
  GraspRequest request = bobbin();
  request.starts = 2;
  request.world.hand = "parallel_jaw";  // not of this world
  try {
    const GraspResult found = grasp_in_world(request);
    EXPECT_EQ(found.started(), 2);
    EXPECT_GE(found.best, 0);
  } catch (const InputError&) {  // both starts may begin in something
  }
}

TEST(GraspInWorld, RefusesNumbersOutOfRange) {
  const auto refused = [](auto change) {
    GraspRequest request = bobbin();
    change(request);
    EXPECT_THROW((void)grasp_in_world(request), InputError);
  };
  refused([](GraspRequest& r) { r.tolerance = 0; });
  refused([](GraspRequest& r) { r.approach_distance = 0; });
  refused([](GraspRequest& r) { r.starts = -1; });
  refused([](GraspRequest& r) { r.edges = 2; });
  refused([](GraspRequest& r) { r.robustness.draws = -1; });
  refused([](GraspRequest& r) { r.approach = false, r.starts = 1; });
}

TEST(GraspInWorld, StopsBeforeTheFirstGraspWithNothing) {
  Progress progress;
  progress.stop_requested = [] { return true; };
  EXPECT_ANY_THROW((void)grasp_in_world(bobbin(), progress));
}

}  // namespace
}  // namespace thenar
