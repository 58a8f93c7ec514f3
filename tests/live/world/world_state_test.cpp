// Tests for live/world/world_state.cpp: names, places and postures of a state as a value.

#include "live/world/world_state.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "live/world/world_edits.h"
#include "live/world/world_files.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

class WorldStateTest : public TemporaryFolder {
 protected:
  [[nodiscard]] WorldState loaded(const std::string& world) {
    (void)load_world(live_, world);
    return live_.state();
  }
  LiveWorld live_{{kData, folder_.string()}};
};

TEST_F(WorldStateTest, ANewNameIsFree) {
  WorldState state = loaded("jaw_box");
  EXPECT_EQ(free_name(state, "mug"), "mug");
  EXPECT_EQ(free_name(state, "box"), "box 2");
  EXPECT_EQ(free_name(state, "parallel_jaw"), "parallel_jaw 2");  // of hands as well
}

TEST_F(WorldStateTest, FindsTheOnlyOneWithoutAName) {
  const WorldState state = loaded("jaw_box");
  EXPECT_EQ(hand_index(state, ""), 0U);
  EXPECT_EQ(object_index(state, ""), object_index(state, "box"));
  EXPECT_EQ(message_of([&] { (void)hand_index(state, "parallel_jav"); }),
            "the world has no hand 'parallel_jav', did you mean 'parallel_jaw'? it has "
            "parallel_jaw");
  EXPECT_EQ(message_of([&] { (void)object_index(state, "table"); }),
            "body 'table' is an obstacle, wanted an object; there are box");
  EXPECT_EQ(message_of([&] { (void)hand_index(empty_world("new", "."), ""); }),
            "the world has no hand");
}

TEST_F(WorldStateTest, AsksWhichOfSeveral) {
  (void)add_object(live_, "mug", true, {});
  (void)add_object(live_, "mug", true, {});
  EXPECT_EQ(message_of([&] { (void)object_index(live_.state(), ""); }),
            "the world has the objects mug, mug 2; choose one with 'object'");
  EXPECT_EQ(object_index(live_.state(), "mug 2"), 1U);
}

// A posture is a new value: the state before is as it was.
TEST_F(WorldStateTest, APostureIsWrittenOutInFull) {
  const WorldState before = loaded("jaw_box");
  Eigen::VectorXd q = before.hands[0].placement.q;
  q.setConstant(0.01);
  const WorldState after = with_posture(before, 0, q);
  EXPECT_EQ(after.hands[0].placement.q, q);
  EXPECT_NE(before.hands[0].placement.q, q);
  for (const auto& [joint, value] : after.placed[after.hands[0].parts.front()].posture)
    EXPECT_EQ(value, 0.01) << joint;
}

// A hand on an arm on a base: what stands below moves all of it, and nothing else.
TEST_F(WorldStateTest, AMountedHandMovesWithItsRoot) {
  const WorldState before = loaded("arm_cube");
  ASSERT_EQ(before.hands.size(), 1U);
  EXPECT_EQ(hand_name(before, before.hands[0]), "parallel_jaw");
  EXPECT_EQ(root_name(before, before.hands[0]), "xr4000");
  Pose<double> X;
  X.p = {1, 2, 3};
  const WorldState after = with_hand_placed(before, 0, X);
  EXPECT_EQ(after.hands[0].placement.X_WH.p, X.p);
  for (std::size_t i = 0; i < after.placed.size(); ++i) {
    const bool is_root = after.placed[i].name == "xr4000";
    EXPECT_EQ(after.placed[i].X_WH.p, is_root ? X.p : before.placed[i].X_WH.p);
  }
}

// What closing is asked about: one object, all other bodies in the way.
TEST_F(WorldStateTest, OtherBodiesAreObstacles) {
  const WorldState state = loaded("jaw_box");
  const std::size_t box = object_index(state, "box");
  const GraspSetup setup = grasp_setup(state, box);
  EXPECT_EQ(setup.obstacles.size(), state.bodies.size() - 1);
  EXPECT_EQ(setup.object.X_WB.p, state.bodies[box].X_WB.p);
}

}  // namespace
}  // namespace thenar
