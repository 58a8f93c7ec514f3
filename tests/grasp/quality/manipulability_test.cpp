// Tests for grasp/quality/no_slip_mobility.cpp.

#include "grasp/quality/manipulability.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/grasp/quality/pinch.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

constexpr double kExactMotion = 1e-12;

/// Unit components of two soft fingers on one line: n, t1, t2 of each, then its turn about n.
Eigen::Matrix<double, 6, Eigen::Dynamic> pinch_components() {
  const WrenchSet set = wrench_set(pinch_contacts(1, kScale), {0, 0, 0}, kScale);
  Eigen::Matrix<double, 6, Eigen::Dynamic> G(6, 8);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const WrenchCap& cap = set.caps[static_cast<std::size_t>(i)];
    G.middleCols(4 * i, 4) << cap.c.vector(), cap.A;
  }
  return G;
}

/// Both fingers moving as one body; a column for each of its velocities.
Eigen::MatrixXd as_one(const Eigen::MatrixXd& velocities) {
  return pinch_components().transpose() * velocities;
}

/// Fingers coming together: each along its inward normal.
Eigen::VectorXd together() { return (Eigen::VectorXd(8) << 1, 0, 0, 0, 1, 0, 0, 0).finished(); }

// Jaws of one motor come together: no rigid object follows both.
TEST(NoSlipMobility, JawsOfOneMotorMoveNothing) {
  const NoSlipMobility found = no_slip_mobility(pinch_components(), together());
  EXPECT_EQ(found.drives.cols(), 0);
  EXPECT_EQ(manipulability(found.object).rank, 0);
}

// A slide under both fingers carries the object along y: 2 m of it per m of the drive.
TEST(NoSlipMobility, OfASlideIsItsRatio) {
  Eigen::VectorXd along_y = Eigen::VectorXd::Zero(6);
  along_y(1) = 2;
  const NoSlipMobility found = no_slip_mobility(pinch_components(), as_one(along_y));
  ASSERT_EQ(found.object.cols(), 1);
  EXPECT_TRUE(matrix_near((found.object * found.drives(0, 0)).eval(), along_y, kExactMotion));
  EXPECT_EQ(manipulability(found.object).rank, 1);
}

// Drives of digits that do not touch have no speed at contacts but for rounding: they move nothing,
// though they are as many as directions.
TEST(NoSlipMobility, RoundingIsNoMotion) {
  Eigen::MatrixXd J =
      1e-18 * Eigen::MatrixXd::NullaryExpr(8, 7, [](Eigen::Index i, Eigen::Index j) {
        return std::sin(static_cast<double>(1 + 3 * i + 7 * j * j));
      });
  J.col(0) = together();
  const NoSlipMobility found = no_slip_mobility(pinch_components(), J);
  EXPECT_EQ(found.drives.cols(), 6);
  EXPECT_TRUE(found.object.isZero(0));
  EXPECT_EQ(manipulability(found.object).rank, 0);
  EXPECT_EQ(manipulability(found.object).min_singular_value, 0);
}

// A slide and jaws: the slide is kept, the jaws' closing is not, whatever the order.
TEST(NoSlipMobility, KeepsWhatContactsAllow) {
  Eigen::VectorXd along_z = Eigen::VectorXd::Zero(6);
  along_z(2) = 3;
  Eigen::MatrixXd J(8, 2);
  J << together(), as_one(along_z);
  const NoSlipMobility found = no_slip_mobility(pinch_components(), J);
  ASSERT_EQ(found.drives.cols(), 1);
  EXPECT_NEAR(found.drives(0, 0), 0, kExactMotion);
  EXPECT_NEAR(found.object.norm(), 3, kExactMotion);
}

// Two motors, one a finger: only their difference moves the object, by s / sqrt 2 a unit of both.
TEST(NoSlipMobility, OfTwoMotorsIsTheirDifference) {
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(8, 2);
  J(0, 0) = J(4, 1) = 1;
  const NoSlipMobility found = no_slip_mobility(pinch_components(), J);
  ASSERT_EQ(found.drives.cols(), 1);
  EXPECT_NEAR(found.drives.col(0).sum(), 0, kExactMotion);
  EXPECT_NEAR(found.object.norm(), 1 / std::sqrt(2.0), kExactMotion);
}

TEST(NoSlipMobility, RefusesAnObjectThatIsFree) {
  const Eigen::Matrix<double, 6, Eigen::Dynamic> G = pinch_components().leftCols(4);
  EXPECT_THROW((void)no_slip_mobility(G, Eigen::MatrixXd::Zero(4, 1)), InputError);
}

}  // namespace
}  // namespace thenar
