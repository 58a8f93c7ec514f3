// Tests for hand/tip_manipulability.cpp.

#include "hand/tip_manipulability.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

TEST(TipManipulability, IsTheConditionOfADiagonalJacobian) {
  const Eigen::Matrix3d J = Eigen::Vector3d(0.01, 0.08, 0.02).asDiagonal();
  const TipManipulability mobility = tip_manipulability(J);
  EXPECT_EQ(mobility.rank, 3);
  EXPECT_NEAR(mobility.condition, 8, 1e-12);
  EXPECT_NEAR(mobility.speed[0], 0.08, 1e-15);
  EXPECT_NEAR(std::abs(mobility.directions(0, 2)), 1, 1e-12);  // x is slowest
}

TEST(TipManipulability, NamesTheDirectionThatIsBlocked) {
  Eigen::Matrix3Xd J(3, 4);  // a straight finger along x
  J << 0, 0, 0, 0, -0.09, 0, -0.05, -0.02, 0, 0.09, 0, 0;
  const TipManipulability mobility = tip_manipulability(J);
  EXPECT_EQ(mobility.rank, 2);
  EXPECT_TRUE(std::isinf(mobility.condition));
  EXPECT_NEAR(std::abs(mobility.directions(0, 2)), 1, 1e-12);
  EXPECT_EQ(mobility.speed[2], 0);
}

TEST(TipManipulability, HasAsManyDirectionsAsJoints) {
  EXPECT_EQ(tip_manipulability(Eigen::Vector3d(0, 0.05, 0)).rank, 1);
}

TEST(TipManipulability, RejectsWhatIsNoJacobian) {
  EXPECT_THROW((void)tip_manipulability(Eigen::Matrix3Xd(3, 0)), InputError);
  const Eigen::Vector3d nan(0, std::numeric_limits<double>::quiet_NaN(), 0);
  EXPECT_THROW((void)tip_manipulability(nan), InputError);
}

// Links of 40 and 30 mm, the second at right angles: the tip is at (40, 30) mm of the first axis
// and (0, 30) of the second. J J' = [1800 -1200; -1200 1600] mm^2 has the eigenvalues 1700 -+
// sqrt(100^2 + 1200^2).
TEST(TipManipulability, OfParallelAxesIsThatInTheirPlane) {
  Eigen::Matrix3Xd J(3, 2), W(3, 2);
  J << -0.03, -0.03, 0.04, 0, 0, 0;
  W << 0, 0, 0, 0, 1, -1;
  const TipManipulability mobility = tip_manipulability(J, W);
  const double spread = std::hypot(100, 1200);
  EXPECT_NEAR(mobility.condition, std::sqrt((1700 + spread) / (1700 - spread)), 1e-12);
  EXPECT_EQ(mobility.possible, 2);
  EXPECT_TRUE(std::isinf(tip_manipulability(J).condition));
  J.row(0).setZero();  // straight
  EXPECT_TRUE(std::isinf(tip_manipulability(J, W).condition));
}

TEST(PlaneNormal, IsOfParallelAxesThatTurn) {
  Eigen::Matrix3Xd J(3, 2), W(3, 2);
  J << -0.03, -0.03, 0.04, 0, 0, 0;
  W << 0, 0, 0, 0, 1, -1;
  ASSERT_TRUE(plane_normal(J, W));
  EXPECT_EQ(*plane_normal(J, W), Eigen::Vector3d(0, 0, 1));
  W.col(1) << 0, std::sin(1e-6), std::cos(1e-6);
  EXPECT_FALSE(plane_normal(J, W));
  W.col(1).setZero();  // slides in the plane, as where two hinges of one coordinate cancel
  ASSERT_TRUE(plane_normal(J, W));
  EXPECT_EQ(*plane_normal(J, W), Eigen::Vector3d(0, 0, 1));
  J(2, 1) = 1e-6;  // slides across it
  EXPECT_FALSE(plane_normal(J, W));
}

}  // namespace
}  // namespace thenar
