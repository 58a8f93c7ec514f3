// Tests for geometry/collision/segment_bounds.cpp.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/collision/segment_bounds.h"

namespace thenar {
namespace {

// The solid may be where both spheres meet, 4 from the line by Pythagoras.
TEST(BallPair, IsAsNarrowAsTheCircleWhereItsBallsMeet) {
  const BallPair equal{0, 6, 5, 5};
  EXPECT_NEAR(equal.narrowest_position(), 3, 1e-15);
  EXPECT_NEAR(equal.min_bound(), 4, 1e-15);
  const BallPair unequal{-5, 16, 13, 20};  // the circle is over 0, 12 off: 5-12-13, 16-12-20
  EXPECT_NEAR(unequal.narrowest_position(), 0, 1e-14);
  EXPECT_NEAR(unequal.min_bound(), 12, 1e-14);
}

TEST(BallPair, EndsAtTheSmallerBallInTheLarger) {
  const BallPair pair{1, 3, 2, 10};
  EXPECT_EQ(pair.narrowest_position(), 1);
  EXPECT_EQ(pair.min_bound(), 2);
}

// 1 and 2 at a way of 5: it falls by 1 for 1 from both, to -1.
TEST(BallPair, FallsWithTheWayWhereBallsDoNotMeet) {
  EXPECT_NEAR(BallPair({0, 5, 1, 2}).min_bound(), -1, 1e-15);
}

}  // namespace
namespace {

constexpr double kHalfInterval = 0.05;  // of the interval [m]

struct Found {
  double lower, upper;
  int asked;
};

/// Looks until the least is known to 1 um.
template <typename Function>
Found close_in(Function f) {
  ConvexBracket bracket(-kHalfInterval, kHalfInterval, f(0));
  Found found{bracket.lower(), f(0).value, 1};
  while (found.upper - found.lower > 1e-6 && found.asked < 100) {
    const Tangent tangent = f(bracket.next_position(0.01));
    EXPECT_LE(std::abs(tangent.t), kHalfInterval);
    bracket.add(tangent);
    found = {bracket.lower(), std::min(found.upper, tangent.value), found.asked + 1};
  }
  return found;
}

/// The distance of a line's points from one that lies `off` of it, over `at`: least off, at `at`.
auto distance_to(double at, double off) {
  return [=](double t) {
    const double d = std::hypot(t - at, off);
    return Tangent{t, d, (t - at) / d};
  };
}

TEST(ConvexBracket, EnclosesTheDistanceOfALineFromAPoint) {
  for (const double at : {-0.049, -0.02, 0.0, 0.001, 0.03})
    for (const double off : {0.001, 0.02, 0.5}) {
      const Found found = close_in(distance_to(at, off));
      EXPECT_LE(found.lower, off + 1e-15);
      EXPECT_GE(found.upper, off);
      EXPECT_LE(found.upper - found.lower, 1e-6);
      EXPECT_LT(found.asked, 15) << at << " " << off;
    }
}

TEST(ConvexBracket, FindsTheEndThatIsLowest) {
  for (const double at : {-1.0, 0.06}) {
    const double least = std::hypot(std::abs(at) - kHalfInterval, 0.01);
    const Found found = close_in(distance_to(at, 0.01));
    EXPECT_NEAR(found.upper, least, 1e-6);
    EXPECT_NEAR(found.lower, least, 1e-6);
    EXPECT_LT(found.asked, 8);
  }
}

// Two tangents are all that a kink has.
TEST(ConvexBracket, FindsAKinkAtOnceFromBothSides) {
  const Found found = close_in([](double t) {
    return t < 0.0123 ? Tangent{t, 0.0123 - t, -1} : Tangent{t, 3 * (t - 0.0123), 3};
  });
  EXPECT_NEAR(found.lower, 0, 1e-15);
  EXPECT_LT(found.asked, 6);
}

TEST(ConvexBracket, KnowsAtOnceWhereItIsFlat) {
  ConvexBracket bracket(-kHalfInterval, kHalfInterval, {0, 0.02, 0});
  EXPECT_EQ(bracket.lower(), 0.02);
}

}  // namespace
}  // namespace thenar
