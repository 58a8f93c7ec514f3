// Tests for report/picture/grasp_view.cpp.

#include "report/picture/grasp_view.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "grasp/closing/closing_drives.h"
#include "grasp/closing/grasp.h"
#include "grasp/robot/robot_hand.h"
#include "tests/grasp/jaws.h"

namespace thenar {
namespace {

using Eigen::Vector3d;

const Vector3d kUp(0, 0, 1), kFront(0, -1, 0.5), kSide(1, -0.1, 0.3);
const PlacedBody kCube = sample::placed("cube", sample::jaw_cube(), {0, 0, 0});

PlacedBody wall(const Vector3d& size, const Vector3d& at) {
  return sample::placed("wall", sample::shape(ShapeKind::kBox, size), at, false);
}

/// The view of a cube between plates that close along x. @param setup  with it as its object
Vector3d view(const GraspSetup& setup, const Eyes& eyes) {
  const RobotHand hand(sample::plates());
  GraspOptions options;
  options.approach_distance = 0;
  const Grasp held = grasp(collision_hand(hand), {}, open_posture(hand.layout()), setup, options);
  return view_of_contacts({hand, held.closed.q, {}, {}}, setup, held.contacts, eyes);
}

/// The view of one contact at the origin, between open plates 50 mm away along x.
Vector3d view_of(const Vector3d& normal, const GraspSetup& setup, const Eyes& eyes) {
  const RobotHand hand(sample::plates());
  HandContact contact;
  contact.contact.p = Vector3d::Zero();
  contact.contact.n = normal;
  return view_of_contacts({hand, open_posture(hand.layout()), {}, {}}, setup, {contact}, eyes);
}

// Along x plates hide all contacts, from the front none, and normals are seen from the side.
TEST(GraspView, LooksAcrossTheNormals) {
  EXPECT_LT(std::abs(view(sample::setup({kCube}), {kSide, kUp}).x()), 0.5);
}

TEST(GraspView, StaysWhereContactsAreSeen) {
  EXPECT_GT(view(sample::setup({kCube}), {kFront, kUp}).dot(kFront.normalized()), 0.9);
}

// A wall of 400 mm before the cube: from behind all is seen.
TEST(GraspView, GoesRoundAWall) {
  const PlacedBody before = wall({0.4, 0.01, 0.4}, {0, -0.1, 0});
  EXPECT_GT(view(sample::setup({kCube, before}), {kFront, kUp}).y(), 0);
}

// A wide wall before the upper half of a pole leaves the contact amid it to be seen.
TEST(GraspView, ShowsTheObjectToo) {
  const PlacedBody pole =
      sample::placed("pole", sample::shape(ShapeKind::kBox, {0.03, 0.03, 0.2}), {0, 0, 0});
  const PlacedBody before = wall({0.4, 0.01, 0.1}, {0, -0.1, 0.07});
  const Eyes eyes{{0, -1, 0}, kUp};
  EXPECT_LT(view_of(-kUp, sample::setup({pole}), eyes).y(), -0.9);
  const Vector3d found = view_of(-kUp, sample::setup({pole, before}), eyes);
  EXPECT_GT(std::abs(found.x()), std::abs(found.y()));
}

// Seen through the object, a contact of which the eye sees the other side, it counts less.
TEST(GraspView, PrefersTheSideOfTheContactThatNoObjectIsBefore) {
  const Eyes eyes{{0, 0.2, 1}, kUp, -kPi / 2};
  EXPECT_LT(view_of(kUp, sample::setup({kCube}), eyes).z(), 0);
}

// As above, but from below no eye may look.
TEST(GraspView, LooksFromNoLowerThanItMay) {
  const Eyes eyes{{0, 0.2, 1}, kUp, 20 * kDegree};
  EXPECT_GE(view_of(kUp, sample::setup({kCube}), eyes).z(), std::sin(20 * kDegree));
}

TEST(GraspView, OfNoContactsIsTheUsualOne) {
  const RobotHand hand(sample::plates());
  const HandPicture open{hand, open_posture(hand.layout()), {}, {}};
  EXPECT_EQ(view_of_contacts(open, sample::setup({kCube}), {}, {{0, 0, 2}, {1, 0, 0}}), kUp);
}

}  // namespace
}  // namespace thenar
