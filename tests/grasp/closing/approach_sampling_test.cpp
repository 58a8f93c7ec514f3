// Tests for grasp/sample_approach_pose.cpp and what it stands on: boxes of bodies and ways of tips.

#include "grasp/closing/approach_sampling.h"

#include <set>

#include <gtest/gtest.h>

#include "grasp/closing/clearance.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/fingertip_paths.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/jaws.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

constexpr double kRound = 1e-9;  // rounding of frames

RobotHand jaws() { return RobotHand(sample::jaws()); }

/// 120 x 60 x 40 mm, turned in its own frame and in the world.
GraspBody turned_box() {
  ShapeSpec box = sample::shape(ShapeKind::kBox, {0.04, 0.12, 0.06});
  box.X_BS.R = rotation_about<double>(Eigen::Vector3d(1, 2, 2) / 3, 0.7);
  PlacedBody placed = sample::placed("box", box, {0.1, 0.2, 0.3});
  placed.X_WB.R = rotation_about<double>(Eigen::Vector3d::UnitZ(), 0.4);
  return build_body(placed);
}

/// Along which of the axes a direction is; -1: along none.
int axis_of(const Eigen::Matrix3d& axes, const Eigen::Vector3d& direction) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(axes.col(i).dot(direction)) > 1 - kRound) return i;
  return -1;
}

TEST(BodyBox, FindsTheSidesOfATurnedBox) {
  const BodyBox box = turned_box().box;
  EXPECT_TRUE(matrix_near(box.half, Eigen::Vector3d(0.06, 0.03, 0.02), kRound));
  EXPECT_NEAR(box.axes.determinant(), 1, kRound);
}

TEST(BodyBox, KeepsTheFrameOfACube) {
  const GraspBody cube =
      sample::setup({sample::placed("cube", sample::jaw_cube(), {0, 0, 0})}).object;
  EXPECT_EQ(cube.box.axes, Eigen::Matrix3d::Identity());
}

TEST(FingertipPaths, OfJawsGoAcrossTheApproach) {
  const RobotHand hand = jaws();
  const FingertipPaths ways = fingertip_paths(hand, open_posture(hand.layout()));
  EXPECT_NEAR(std::abs(ways.axis.x()), 1, kRound);
  // Tips of plates of 40 mm about the middle of the hand, at every width.
  const double ahead = mean_tip_advance(ways, hand.layout().approach, 0.03);
  EXPECT_NEAR(ahead, hand.layout().tip_points[0].p.y(), kRound);
}

// A tip at l (cos a, sin a) is l sin a ahead; both are 2 l cos a nearer than their knuckles.
TEST(FingertipPaths, OfHingesAreAheadByTheSineWhereTheyAreAsWideApart) {
  const RobotHand hand(sample::pincer(0.06));
  const FingertipPaths ways = fingertip_paths(hand, open_posture(hand.layout()));
  const double l = sample::kLength + sample::kRadius, width = 0.02;
  const double sine = (0.06 - width) / 2 / l;
  const double step = kPi / 2 / 20;  // between times, by which the width may be missed
  EXPECT_NEAR(mean_tip_advance(ways, hand.layout().approach, width), l * std::sqrt(1 - sine * sine),
              l * step * sine + l * step * step);
}

TEST(DrawStart, GoesAlongAxesInHalfOfTheCasesAndClosesAcrossTheShorterSide) {
  const RobotHand hand = jaws();
  const CollisionHand touching = collision_hand(hand);
  const GraspBody box = turned_box();
  const Eigen::VectorXd q = open_posture(hand.layout());
  const Eigen::Matrix3d axes = box.X_WB.R * box.box.axes;
  const Eigen::Vector3d closing = fingertip_paths(hand, q).axis;
  std::mt19937 random(1);
  int along = 0;
  std::set<int> seen;
  Eigen::Vector3d sum(0, 0, 0);
  for (int i = 0; i < 400; ++i) {
    const Pose<double> X = sample_approach_pose(touching, q, box, random);
    const Eigen::Vector3d towards = X.R * hand.layout().approach.direction;
    const int from = axis_of(axes, towards);
    sum += towards;
    if (from < 0) continue;
    ++along;
    seen.insert(from);
    EXPECT_EQ(axis_of(axes, X.R * closing), from == 2 ? 1 : 2);
  }
  EXPECT_NEAR(along, 200, 30);  // three standard deviations
  EXPECT_EQ(seen.size(), 3u);
  EXPECT_LT(sum.norm() / 400, 0.15);  // every sense: 3 / sqrt(400)
}

TEST(DrawStart, IsClearOfTheObjectAndGoesPastIt) {
  const RobotHand hand = jaws();
  const CollisionHand touching = collision_hand(hand);
  const Eigen::VectorXd q = open_posture(hand.layout());
  GraspSetup setup = sample::setup({sample::placed("cube", sample::jaw_cube(), {0, 0, 0})});
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) {
    const Pose<double> X = sample_approach_pose(touching, q, setup.object, random);
    const PosedCollisionHand posed{touching, X, hand.pose(q)};
    EXPECT_TRUE(find_overlaps(posed, setup, 1e-4).empty());
    const double way = approach_distance(touching, q, setup.object);
    const Eigen::Vector3d end =
        X * hand.layout().approach.point + way * (X.R * hand.layout().approach.direction);
    EXPECT_GT((end - setup.object.com).norm(), setup.object.torque_scale);
  }
}

TEST(DrawStart, TakesAsManyDrawsForEveryHand) {
  const RobotHand a = jaws(), b(sample::pincer(0.06));
  const GraspBody box = turned_box();
  std::mt19937 with_a(3), with_b(3);
  for (int i = 0; i < 10; ++i) {
    (void)sample_approach_pose(collision_hand(a), open_posture(a.layout()), box, with_a);
    (void)sample_approach_pose(collision_hand(b), open_posture(b.layout()), box, with_b);
  }
  EXPECT_EQ(with_a, with_b);
}

TEST(DrawStandOff, IsNoneForHalfOfAllGrasps) {
  std::mt19937 random(4);
  int none = 0;
  for (int i = 0; i < 400; ++i) {
    const double share = sample_stand_off(random);
    EXPECT_GE(share, 0);
    EXPECT_LT(share, 1);
    none += share == 0 ? 1 : 0;
  }
  EXPECT_NEAR(none, 200, 30);
}

TEST(DrawPreshape, TurnsTheThumbButNotTheWrist) {
  const RobotHand hand(read_robot(THENAR_DATA_DIR "/robots/shadow.toml"));
  const CollisionHand touching = collision_hand(hand);
  const std::vector<std::string>& names = hand.layout().coordinates;
  const Eigen::VectorXd open = open_posture(hand.layout());
  std::mt19937 random(5);
  EXPECT_EQ(sample_preshape(touching, 0, random), open);
  const Eigen::VectorXd q = sample_preshape(touching, 1, random);
  for (std::size_t j = 0; j < names.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    if (names[j].rfind("WR", 0) == 0) {
      EXPECT_EQ(q[i], open[i]) << names[j];
    } else if (names[j] == "THJ5") {
      EXPECT_NE(q[i], open[i]);
    }
  }
}

}  // namespace
}  // namespace thenar
