// Tests for live/world/world_edits.cpp: edits that can be undone, and those that are refused.

#include "live/world/world_edits.h"

#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "live/world/world_files.h"
#include "tests/data_folder.h"
#include "tests/message_of.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

class WorldEditsTest : public TemporaryFolder {
 protected:
  [[nodiscard]] Vector3d place_of(const std::string& object) const {
    return live_.state().bodies[object_index(live_.state(), object)].X_WB.p;
  }
  LiveWorld live_{{kData, folder_.string()}};
};

TEST_F(WorldEditsTest, EveryEditIsUndoneAndDoneAgain) {
  (void)add_object(live_, "mug", true, {});
  place_thing(live_, "mug", Vector3d(0.1, 0, 0), {});
  remove_thing(live_, "mug");
  EXPECT_EQ(live_.edit_state().undo, "remove mug");
  (void)live_.undo();
  EXPECT_EQ(place_of("mug"), Vector3d(0.1, 0, 0));
  (void)live_.undo();
  EXPECT_EQ(place_of("mug"), Vector3d(0, 0, 0));
  (void)live_.redo();
  EXPECT_EQ(place_of("mug"), Vector3d(0.1, 0, 0));
  (void)live_.redo();
  EXPECT_TRUE(live_.state().bodies.empty());
}

// Moves of one thing within a gesture are one edit; another thing, or none, begins another.
TEST_F(WorldEditsTest, AGestureIsUndoneAsOne) {
  (void)add_object(live_, "mug", true, {});
  for (const double x : {0.1, 0.2, 0.3}) place_thing(live_, "mug", Vector3d(x, 0, 0), {}, "drag");
  (void)live_.undo();
  EXPECT_EQ(place_of("mug"), Vector3d(0, 0, 0));
  for (const double x : {0.1, 0.2, 0.3}) place_thing(live_, "mug", Vector3d(x, 0, 0), {});
  (void)live_.undo();
  EXPECT_EQ(place_of("mug"), Vector3d(0.2, 0, 0));
}

// Position and rotation are set apart: what is left out stays.
TEST_F(WorldEditsTest, PlacesWhatIsGivenAlone) {
  (void)add_object(live_, "mug", true, {});
  const Eigen::Matrix3d turn = rotation_about<double>({0, 0, 1}, 0.5);
  place_thing(live_, "mug", Vector3d(0.1, 0.2, 0.3), {});
  place_thing(live_, "mug", {}, turn);
  EXPECT_EQ(place_of("mug"), Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(live_.state().bodies[0].X_WB.R, turn);
}

// Joints stop at their limits, which is told of those that came to rest there.
TEST_F(WorldEditsTest, JointsStopAtTheirLimits) {
  (void)load_world(live_, "jaw_box");
  const JointChange within = set_joints(live_, "", {{"opening", 0.02}});
  EXPECT_EQ(within.joints.at("opening"), 0.02);
  EXPECT_TRUE(within.limited.empty());
  const JointChange beyond = set_joints(live_, "", {{"opening", 5}});
  EXPECT_LT(beyond.joints.at("opening"), 5);
  EXPECT_EQ(beyond.limited, std::vector<std::string>{"opening"});
  EXPECT_EQ(joints_of(live_.state(), 0), beyond.joints);
}

// Refusals name what there is, and leave the world as it was.
TEST_F(WorldEditsTest, RefusalsLeaveTheWorldAlone) {
  (void)load_world(live_, "arm_cube");
  const unsigned long changes = live_.changes();
  EXPECT_EQ(message_of([&] { remove_thing(live_, "puma560"); }),
            "'puma560' carries parallel_jaw: remove that first");
  EXPECT_EQ(message_of([&] { place_thing(live_, "parallel_jaw", Vector3d(0, 0, 0), {}); }),
            "'parallel_jaw' is mounted on 'puma560' (link 6): move the joints of that, or place "
            "'xr4000'");
  const std::string unknown = message_of([&] { remove_thing(live_, "puma56"); });
  EXPECT_EQ(unknown.find("the world has no 'puma56', did you mean 'puma560'?"), 0U) << unknown;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] { place_thing(live_, "xr4000", Vector3d(nan, 0, 0), {}); }),
            "wanted a finite position of 'xr4000'");
  EXPECT_EQ(message_of([&] {
              (void)set_joints(live_, "", {{"opening", nan}});
            }),
            "wanted a finite value of joint 'opening'");
  const std::string joint = message_of([&] { (void)set_joints(live_, "", {{"openning", 0}}); });
  EXPECT_NE(joint.find("'opening'"), std::string::npos) << joint;
  EXPECT_EQ(live_.changes(), changes);
}

// An arm whose hand is removed is a hand by itself.
TEST_F(WorldEditsTest, AnArmWithoutItsHandStandsAlone) {
  (void)load_world(live_, "arm_cube");
  remove_thing(live_, "parallel_jaw");
  EXPECT_EQ(hand_names(live_.state()), std::vector<std::string>{"puma560"});
  remove_thing(live_, "puma560");
  EXPECT_EQ(hand_names(live_.state()), std::vector<std::string>{"xr4000"});
  remove_thing(live_, "xr4000");
  EXPECT_TRUE(live_.state().hands.empty());
}

}  // namespace
}  // namespace thenar
