// Tests for grasp/closing/grasp.cpp: whole grasps whose contacts are known.

#include "grasp/closing/grasp.h"

#include <gmock/gmock.h>

#include "grasp/robot/robot_hand.h"
#include "tests/grasp/jaws.h"
#include "tests/message_of.h"

namespace thenar {
namespace {

using testing::HasSubstr;

const ShapeSpec kCube = sample::jaw_cube();

Grasp squeeze(const std::vector<PlacedBody>& bodies, double way) {
  const RobotHand hand(sample::plates());
  GraspOptions options;
  options.approach_distance = way;
  return grasp(collision_hand(hand), {}, open_posture(hand.layout()), sample::setup(bodies),
               options);
}

// Plates 40 x 20 mm on faces 30 x 30 mm: each touches at (+-15, +-15, +-10) mm.
TEST(Grasp, OfACubeByPlatesTouchesAtTheCornersOfTheOverlaps) {
  const Grasp done = squeeze({sample::placed("cube", kCube, {0, 0, 0})}, 0);
  ASSERT_EQ(done.outcome, GraspOutcome::kGrasped);
  ASSERT_EQ(done.contacts.size(), 8u);
  const Eigen::Vector3d corner(0.015, 0.015, 0.01);
  for (const HandContact& contact : done.contacts) {
    EXPECT_LT((contact.contact.p.cwiseAbs() - corner).norm(), 1e-3);  // resolution of patches
    const double side = contact.contact.p.x() > 0 ? 1 : -1;
    EXPECT_LT((contact.contact.n + side * Eigen::Vector3d::UnitX()).norm(), 1e-6);
    EXPECT_EQ(contact.contact.friction, 1.0);  // rubber on wood, data/materials.toml
  }
  EXPECT_TRUE(done.quality.force_closure);
}

TEST(Grasp, SaysHowFarItCame) {
  EXPECT_EQ(squeeze({sample::placed("cube", kCube, {0, 1, 0})}, 0.5).outcome,
            GraspOutcome::kMissed);
  EXPECT_EQ(squeeze({sample::placed("cube", kCube, {0, 1, 0})}, 0).outcome, GraspOutcome::kEmpty);
  EXPECT_EQ(squeeze({sample::placed("cube", kCube, {0.05, 0, 0})}, 0.5).outcome,
            GraspOutcome::kOverlaps);
  EXPECT_EQ(squeeze({sample::placed("cube", kCube, {0, 1, 0}),
                     sample::placed("wall", kCube, {0.05, 0.2, 0}, false)},
                    0.5)
                .outcome,
            GraspOutcome::kBlocked);
}

// The right plate stops at the wall, whose face is at y = 115 mm, with the cube between both.
TEST(Grasp, ClosesWhereAnObstacleBlocksTheWay) {
  const Grasp done = squeeze({sample::placed("cube", kCube, {0, 0.1, 0}),
                              sample::placed("wall", kCube, {0.05, 0.13, 0}, false)},
                             0.5);
  EXPECT_EQ(done.outcome, GraspOutcome::kGrasped);
  EXPECT_EQ(done.approached.body, "wall");
  EXPECT_NEAR(done.approached.X_WH.p.y(), 0.095, 2e-4);  // plates reach 20 mm ahead
  EXPECT_TRUE(done.quality.force_closure);
}

/// Where jaws come to whose palm, 25 mm behind their middle, meets a cube of 30 mm.
double stands(double stand_off) {
  const RobotHand hand(sample::jaws());
  GraspOptions options;
  options.approach_distance = 0.5;
  options.stand_off = stand_off;
  return grasp(collision_hand(hand), {}, open_posture(hand.layout()),
               sample::setup({sample::placed("cube", kCube, {0, 0.2, 0})}), options)
      .approached.X_WH.p.y();
}

// Against the palm the cube's centre is 10 mm behind the tips, the middles of the jaws.
TEST(Grasp, GoesBackUntilTipsCloseRoundTheCentre) {
  EXPECT_NEAR(stands(0), 0.2 - 0.015 + 0.025, 2e-4);
  EXPECT_NEAR(stands(1), 0.2, 1e-9);
  EXPECT_NEAR(stands(0.5), (stands(0) + stands(1)) / 2, 1e-9);
  EXPECT_THAT(message_of([] { (void)stands(2); }), HasSubstr("got 2"));
}

TEST(Grasp, RefusesMaterialsWithoutFriction) {
  PlacedBody cube = sample::placed("cube", kCube, {0, 0, 0});
  cube.body.material = "cheese";
  EXPECT_THAT(message_of([&] { (void)squeeze({cube}, 0); }), HasSubstr("cheese"));
}

}  // namespace
}  // namespace thenar
