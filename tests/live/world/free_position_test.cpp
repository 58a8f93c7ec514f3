// Tests for live/world/free_position.cpp.

#include "live/world/free_position.h"

#include <gtest/gtest.h>

#include "live/world/world_edits.h"
#include "tests/data_folder.h"
#include "tests/temporary_folder.h"

namespace thenar {
namespace {

using FreePlace = TemporaryFolder;

/// The box about a thing of the world, from balls about its surfaces [m].
Eigen::AlignedBox1d reach_along_x(const WorldState& state, std::size_t body) {
  const StateBody& of = state.bodies[body];
  const double x = (of.X_WB * of.built->ball.c).x(), r = of.built->ball.r;
  return Eigen::AlignedBox1d(Eigen::Matrix<double, 1, 1>(x - r),
                             Eigen::Matrix<double, 1, 1>(x + r));
}

TEST_F(FreePlace, IsTheOriginWhereNothingStands) {
  LiveWorld live({folder_.string(), kData});
  add_object(live, "sphere_70", true, {});
  EXPECT_EQ(live.state().bodies[0].X_WB.p, Eigen::Vector3d::Zero());
}

// 20 mm are left between the balls about them.
TEST_F(FreePlace, IsBesideAllThatStandsThere) {
  LiveWorld live({folder_.string(), kData});
  for (int i = 0; i < 3; ++i) add_object(live, "sphere_70", true, {});
  for (const std::size_t i : {0U, 1U})
    EXPECT_NEAR(
        reach_along_x(live.state(), i + 1).min().x() - reach_along_x(live.state(), i).max().x(),
        0.02, 1e-12);
  EXPECT_EQ(live.state().bodies[2].X_WB.p.tail<2>(), Eigen::Vector2d::Zero());
}

TEST_F(FreePlace, KeepsAPositionThatIsAskedFor) {
  LiveWorld live({folder_.string(), kData});
  add_object(live, "sphere_70", true, {});
  add_object(live, "mug", true, {Eigen::Matrix3d::Identity(), Eigen::Vector3d(0, 0.01, 0)});
  EXPECT_EQ(live.state().bodies[1].X_WB.p, Eigen::Vector3d(0, 0.01, 0));
}

TEST_F(FreePlace, OfAHandIsClearOfObjects) {
  LiveWorld live({folder_.string(), kData});
  add_object(live, "sphere_70", true, {});
  add_hand(live, "barrett", {});
  const StateHand& hand = live.state().hands[0];
  for (const Ball& ball : hand.built->balls)
    EXPECT_GE((hand.placement.X_WH * ball.c).x() - ball.r,
              reach_along_x(live.state(), 0).max().x() + 0.02 - 1e-12);
}

}  // namespace
}  // namespace thenar
