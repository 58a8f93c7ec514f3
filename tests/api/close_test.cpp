// Tests for api/close.cpp.

#include "api/close.h"

#include <gtest/gtest.h>

#include "tests/data_folder.h"

namespace thenar {
namespace {

// Each jaw presses with 80 N and has friction 1 on wood.
TEST(CloseInWorld, HoldsTheCubeBetweenItsJaws) {
  CloseRequest request;
  request.world.world = "arm_cube";
  request.world.data = kData;
  const GraspResult found = close_in_world(request).grasp;
  EXPECT_FALSE(found.request.approach);
  EXPECT_EQ(found.start.approach_distance, 0);
  EXPECT_EQ(found.grasp.closed.stopped.back(), StoppedBy::kContact);
  ASSERT_TRUE(found.measures);
  EXPECT_NEAR(*found.measures->pull.value->active, 160, 1e-4);
}

// The hand of this world stands off its object.
TEST(CloseInWorld, DoesNotApproach) {
  CloseRequest request;
  request.world.world = "jaw_box";
  request.world.data = kData;
  const GraspResult found = close_in_world(request).grasp;
  EXPECT_EQ(found.grasp.outcome, GraspOutcome::kEmpty);
  EXPECT_FALSE(found.measures);
}

}  // namespace
}  // namespace thenar
