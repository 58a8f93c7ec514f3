// Tests for sampling/diagnostics/split_chains.cpp, by hand.

#include "sampling/diagnostics/split_chains.h"

#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"

namespace thenar {
namespace {

// The middle one of five draws is left out.
TEST(SplitChains, HalvesOfAnOddNumberLeaveTheMiddleOut) {
  const Eigen::MatrixXd x = Eigen::VectorXd::LinSpaced(5, 1, 5);
  EXPECT_EQ(split_chains(x), (Eigen::Matrix2d() << 1, 4, 2, 5).finished());
  EXPECT_THROW((void)split_chains(x.topRows(3)), InputError);
}

// Chains 0 and 2 are group 7: their draws alternate.
TEST(SplitChains, WalkersOfAGroupTakeTurns) {
  const Eigen::MatrixXd x = (Eigen::MatrixXd(2, 4) << 1, 10, 3, 30, 2, 20, 4, 40).finished();
  const Eigen::MatrixXd pooled = pool_groups(x, {7, 8, 7, 8});
  EXPECT_EQ(pooled, (Eigen::MatrixXd(4, 2) << 1, 10, 3, 30, 2, 20, 4, 40).finished());
  EXPECT_THROW((void)pool_groups(x, {7, 7, 7, 8}), InputError);
  EXPECT_THROW((void)pool_groups(x, {7, 8}), InputError);
}

TEST(SplitChains, TellDrawsThatVary) {
  Eigen::Vector3d x(1, 1, 1);
  EXPECT_FALSE(finite_and_varying(x));
  x[1] = 2;
  EXPECT_TRUE(finite_and_varying(x));
  x[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(finite_and_varying(x));
}

}  // namespace
}  // namespace thenar
