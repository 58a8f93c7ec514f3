// Tests for grasp/robot/approach_direction.cpp: axes and faces tell directions, roundings do not.

#include "grasp/robot/approach_direction.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A direction so many degrees from z, towards x.
Vector3d near_z(double deg) { return {std::sin(deg * kPi / 180), 0, std::cos(deg * kPi / 180)}; }

const double kTenDegrees = std::cos(10 * kPi / 180);

TEST(ClosingAxes, OfAChuckSpanAPlane) {
  Matrix3Xd axes(3, 3);
  for (int i = 0; i < 3; ++i)
    axes.col(i) << std::cos(2 * kPi * i / 3), std::sin(2 * kPi * i / 3), 0;
  const ClosingAxes found = find_closing_axes(axes);
  ASSERT_TRUE(found.normal && !found.line);
  EXPECT_NEAR(std::abs(found.normal->z()), 1, 1e-12);
}

TEST(ClosingAxes, OfTwoJawsAreALineWhateverTheirSigns) {
  Matrix3Xd axes(3, 2);
  axes << 0, 0, 1, -1, 0, 0;
  const ClosingAxes found = find_closing_axes(axes);
  ASSERT_TRUE(found.line && !found.normal);
  EXPECT_NEAR(std::abs(found.line->y()), 1, 1e-12);
}

TEST(ClosingAxes, OfFingersEveryWayTellNothing) {
  const ClosingAxes found = find_closing_axes(Eigen::Matrix3d::Identity());
  EXPECT_FALSE(found.normal || found.line);
  EXPECT_FALSE(find_closing_axes(Matrix3Xd(3, 0)).line);
}

TEST(FacingDirection, IsThatOfTheLargestFaceNearby) {
  Matrix3Xd faces(3, 3);
  faces << 2 * near_z(4), 0.5 * near_z(-6), 5 * Vector3d::UnitX();
  const auto found = facing_direction(faces, Vector3d::UnitZ(), kTenDegrees, {});
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found - near_z(4)).norm(), 0, 1e-12);
}

// A cylinder of 40 sides that lies across: sides 9 deg apart, all alike.
TEST(FacingDirection, IsNoneOfARoundedSurface) {
  Matrix3Xd faces(3, 40);
  for (int i = 0; i < 40; ++i) faces.col(i) = near_z(2 + 9.0 * i);
  EXPECT_FALSE(facing_direction(faces, Vector3d::UnitZ(), kTenDegrees, {}));
}

// A jaw that slides along y and points to near_z(3): its side tells what its end would.
TEST(FacingDirection, FollowsTheSidesOfAJawAcrossItsSlide) {
  Matrix3Xd faces(3, 2);
  faces << near_z(93), 3 * Vector3d::UnitY();
  EXPECT_FALSE(facing_direction(faces, Vector3d::UnitZ(), kTenDegrees, {}));
  const auto found = facing_direction(faces, Vector3d::UnitZ(), kTenDegrees, Vector3d::UnitY());
  ASSERT_TRUE(found);
  EXPECT_NEAR((*found - near_z(3)).norm(), 0, 1e-12);
}

TEST(WithoutRounding, TakesAnAxisForTheRoundedOneAlone) {
  EXPECT_EQ(snap_to_axis(Vector3d(0, -1, 3e-6).normalized()), -Vector3d::UnitY());
  EXPECT_EQ(snap_to_axis(near_z(0.01)), near_z(0.01));
}

}  // namespace
}  // namespace thenar
