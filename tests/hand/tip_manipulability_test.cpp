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

}  // namespace
}  // namespace thenar
