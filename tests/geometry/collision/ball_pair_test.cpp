// Tests for geometry/collision/ball_pair.cpp.

#include "geometry/collision/ball_pair.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

// The solid may be where both spheres meet, 4 from the line by Pythagoras.
TEST(BallPair, IsAsNarrowAsTheCircleWhereItsBallsMeet) {
  const BallPair equal{0, 6, 5, 5};
  EXPECT_NEAR(equal.narrowest(), 3, 1e-15);
  EXPECT_NEAR(equal.least(), 4, 1e-15);
  const BallPair unequal{-5, 16, 13, 20};  // the circle is over 0, 12 off: 5-12-13, 16-12-20
  EXPECT_NEAR(unequal.narrowest(), 0, 1e-14);
  EXPECT_NEAR(unequal.least(), 12, 1e-14);
}

TEST(BallPair, EndsAtTheSmallerBallInTheLarger) {
  const BallPair pair{1, 3, 2, 10};
  EXPECT_EQ(pair.narrowest(), 1);
  EXPECT_EQ(pair.least(), 2);
}

// 1 and 2 at a way of 5: it falls by 1 for 1 from both, to -1.
TEST(BallPair, FallsWithTheWayWhereBallsDoNotMeet) {
  EXPECT_NEAR(BallPair({0, 5, 1, 2}).least(), -1, 1e-15);
}

}  // namespace
}  // namespace thenar
