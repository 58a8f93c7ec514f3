// Tests for api/named/worlds.cpp.

#include "api/named/worlds.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/data_folder.h"

namespace thenar {
namespace {

TEST(OpenWorld, BuildsItsHandAndItsScene) {
  WorldRequest request;
  request.world = "barrett_bobbin";
  request.data = kData;
  const WorldCase found = open_world(request, false);
  EXPECT_EQ(found.hand.q.size(),
            static_cast<int>(found.hand.named.hand->layout().coordinates.size()));
  request.hand = found.hand.named.name;
  EXPECT_TRUE(has_hand(request));
}

TEST(OpenWorld, TakesAHandFromElsewhere) {
  WorldRequest request;
  request.world = "barrett_bobbin";
  request.hand = "barrett";
  request.data = kData;
  EXPECT_TRUE(open_world(request, true).hand.parts.empty());  // it has no place in the world
  request.hand = "nobody";
  EXPECT_FALSE(has_hand(request));
  EXPECT_THROW((void)open_world(request, true), InputError);
}

}  // namespace
}  // namespace thenar
