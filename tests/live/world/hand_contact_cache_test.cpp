// Tests for live/world/hand_contact_cache.cpp: contacts are found where bodies are near, and not elsewhere.

#include "live/world/hand_contact_cache.h"

#include <gtest/gtest.h>

#include "live/world/live_world.h"
#include "live/world/world_edits.h"
#include "live/world/world_files.h"
#include "tests/data_folder.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

class HandTouchTest : public TemporaryFolder {
 protected:
  void SetUp() override { (void)load_world(live_, "jaw_box"); }
  /// Puts the box around the origin of the hand's own palm, so that they overlap.
  void put_box_into_the_hand() {
    const StateHand& hand = live_.state().hands[0];
    place_thing(live_, "box", Vector3d(hand.placement.X_WH * hand.built->balls[0].c), {});
  }
  [[nodiscard]] const StateBody& box() const {
    return live_.state().bodies[object_index(live_.state(), "box")];
  }
  LiveWorld live_{{kData, folder_.string()}};
};

// Balls around surfaces and body tell who is near: with enough margin everything is.
TEST_F(HandTouchTest, FarThingsMayNotTouch) {
  place_thing(live_, "box", Vector3d(5, 0, 0), {});
  EXPECT_FALSE(may_touch(live_.state().hands[0], box(), 1e-3));
  EXPECT_TRUE(may_touch(live_.state().hands[0], box(), 6));
  put_box_into_the_hand();
  EXPECT_TRUE(may_touch(live_.state().hands[0], box(), 0));
}

TEST_F(HandTouchTest, FindsContactsWhereBodiesOverlap) {
  HandContactCache touch;
  EXPECT_TRUE(touch.contacts(live_.state(), 1).empty());  // above the box, open
  put_box_into_the_hand();
  const std::vector<HandObjectContacts>& found = touch.contacts(live_.state(), 2);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].hand, 0U);
  EXPECT_EQ(found[0].body, object_index(live_.state(), "box"));
  EXPECT_FALSE(found[0].contacts.empty());
}

// What it remembers changes no answer: the same contacts as one that has seen nothing before.
TEST_F(HandTouchTest, RemembersWithoutATrace) {
  HandContactCache old;
  put_box_into_the_hand();
  const std::size_t first = old.contacts(live_.state(), 1).front().contacts.size();
  place_thing(live_, "box", Vector3d(5, 0, 0), {});
  EXPECT_TRUE(old.contacts(live_.state(), 2).empty());
  put_box_into_the_hand();
  const std::vector<HandObjectContacts>& again = old.contacts(live_.state(), 3);
  HandContactCache fresh;
  const std::vector<HandObjectContacts>& anew = fresh.contacts(live_.state(), 1);
  ASSERT_EQ(again.size(), 1U);
  ASSERT_EQ(anew.size(), 1U);
  EXPECT_EQ(again[0].contacts.size(), first);
  EXPECT_EQ(anew[0].contacts.size(), first);
}

// The number of changes is what it looks at: with the same one the answer is the same.
TEST_F(HandTouchTest, LooksAgainOnlyAfterAChange) {
  HandContactCache touch;
  put_box_into_the_hand();
  EXPECT_EQ(touch.contacts(live_.state(), 7).size(), 1U);
  const CollisionHand* model = &touch.collision_of(live_.state(), live_.state().hands[0]);
  place_thing(live_, "box", Vector3d(5, 0, 0), {});
  EXPECT_EQ(touch.contacts(live_.state(), 7).size(), 1U);  // the same number: not looked again
  EXPECT_TRUE(touch.contacts(live_.state(), 8).empty());
  EXPECT_EQ(&touch.collision_of(live_.state(), live_.state().hands[0]), model);  // built once
}

// Obstacles are never touched for a grasp.
TEST_F(HandTouchTest, PassesObstaclesOver) {
  HandContactCache touch;
  place_thing(live_, "box", Vector3d(5, 0, 0), {});
  const StateHand& hand = live_.state().hands[0];
  place_thing(live_, "table", Vector3d(hand.placement.X_WH * hand.built->balls[0].c), {});
  EXPECT_TRUE(touch.contacts(live_.state(), 1).empty());
}

}  // namespace
}  // namespace thenar
