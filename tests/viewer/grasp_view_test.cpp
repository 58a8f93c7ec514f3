// Tests for viewer/grasp_view.cpp.

#include "viewer/grasp_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "grasp/closing_drives.h"
#include "grasp/grasp.h"
#include "grasp/robot_hand.h"
#include "tests/grasp/jaws.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

/// The view of a cube between jaws that close along x. @param scene  with the cube as its object
Vector3d view(const Scene& scene, const Vector3d& from) {
  const RobotHand hand(sample::plates());
  const TouchingHand touching = touching_hand(hand);
  GraspOptions options;
  options.way = 0;
  const Grasp held = grasp(touching, {}, open_posture(hand.layout()), scene, options);
  const PosedHand posed{touching, {}, hand.pose(held.closed.q)};
  return view_of_contacts(posed, scene, held.contacts, from);
}

const PlacedBody kCube = sample::placed("cube", sample::jaw_cube(), {0, 0, 0});
const Vector3d kFront(0, -1, 0.5), kSide(1, -0.1, 0.3);

// Along x jaws hide all contacts, from the front none, and normals are seen from the side.
TEST(GraspView, LooksAcrossTheNormals) {
  EXPECT_LT(std::abs(view(sample::scene({kCube}), kSide).x()), 0.5);
}

TEST(GraspView, StaysWhereContactsAreSeen) {
  EXPECT_GT(view(sample::scene({kCube}), kFront).dot(kFront.normalized()), 0.9);
}

// A wall of 400 mm before the cube: from behind all is seen.
TEST(GraspView, GoesRoundAWall) {
  const PlacedBody wall =
      sample::placed("wall", sample::shape(ShapeKind::kBox, {0.4, 0.01, 0.4}), {0, -0.1, 0}, false);
  EXPECT_GT(view(sample::scene({kCube, wall}), kFront).y(), 0);
}

TEST(GraspView, OfNoContactsIsTheGivenOne) {
  const RobotHand hand(sample::plates());
  const TouchingHand touching = touching_hand(hand);
  const Eigen::VectorXd q = open_posture(hand.layout());
  const PosedHand posed{touching, {}, hand.pose(q)};
  EXPECT_EQ(view_of_contacts(posed, sample::scene({kCube}), {}, {0, 0, 2}), Vector3d(0, 0, 1));
}

}  // namespace
}  // namespace thenar
