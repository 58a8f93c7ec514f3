// Bounds of distance from balls and half-spaces that are known to be empty.

#include <limits>

#include <gtest/gtest.h>

#include "geometry/collision/empty_space.h"

namespace thenar {
namespace {

const Eigen::Vector3d kUp(0, 0, 1);

Eigen::Matrix3d triangle_at(double z) {
  Eigen::Matrix3d corners;
  corners << 0, 3, 0, 0, 0, 4, z, z, z;
  return corners;
}

TEST(EmptySpace, KnowsNothingAtFirst) {
  const EmptySpace empty;
  EXPECT_FALSE(empty.has_planes());
  EXPECT_EQ(empty.bound(Ball{{0, 0, 0}, 1}), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(empty.bound(triangle_at(0), 0), -std::numeric_limits<double>::infinity());
}

TEST(EmptySpace, KeepsOffByWhatIsLeftOfABall) {
  EmptySpace empty;
  empty.add_ball({{0, 0, 0}, 10});
  EXPECT_DOUBLE_EQ(empty.bound(Ball{{0, 3, 4}, 2}), 10 - 5 - 2);
  EXPECT_DOUBLE_EQ(empty.bound(triangle_at(0), 1), 10 - 4 - 1);  // the farthest corner counts
}

TEST(EmptySpace, KeepsOffByTheHeightOverAPlane) {
  EmptySpace empty;
  empty.add_plane(kUp, 2);
  EXPECT_TRUE(empty.has_planes());
  EXPECT_DOUBLE_EQ(empty.bound(Ball{{7, 7, 6}, 1}), 6 - 2 - 1);
  EXPECT_DOUBLE_EQ(empty.bound(triangle_at(5), 0.5), 5 - 2 - 0.5);
}

TEST(EmptySpace, ForgetsTheOldestPlaneAndKeepsTheFirstBalls) {
  EmptySpace empty;
  empty.add_plane(kUp, 0);
  for (int i = 0; i < 8; ++i) empty.add_plane(kUp, 1);
  EXPECT_DOUBLE_EQ(empty.bound(Ball{{0, 0, 5}, 0}), 4);
  for (int i = 1; i <= 9; ++i) empty.add_ball({{0, 0, 5}, static_cast<double>(i)});
  EXPECT_DOUBLE_EQ(empty.bound(Ball{{0, 0, 5}, 0}), 8);
}

}  // namespace
}  // namespace thenar
