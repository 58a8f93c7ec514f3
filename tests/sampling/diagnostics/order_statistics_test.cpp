// Tests for sampling/diagnostics/order_statistics.cpp, by hand.

#include "sampling/diagnostics/order_statistics.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/special_functions.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

// 1 < 3 = 3 < 5: the two in the middle share rank 2.5.
TEST(OrderStatistics, TiesShareTheirRanks) {
  const Eigen::Matrix2d x = (Eigen::Matrix2d() << 3, 1, 5, 3).finished();
  const Eigen::Matrix2d ranks = (Eigen::Matrix2d() << 2.5, 1, 4, 2.5).finished();
  EXPECT_EQ(average_ranks(x), ranks);
}

// Of three numbers the scores are the quantiles at 2.5/13, 1/2 and 10.5/13.
TEST(OrderStatistics, NormalScoresAreQuantilesOfRanks) {
  const Eigen::Vector3d scores = normal_scores(Eigen::Vector3d(7, -2, 1e6));
  const double tail = normal_quantile(2.5 / 13);
  EXPECT_TRUE(matrix_near(scores, Eigen::Vector3d(0, tail, -tail), 1e-12));
}

// Type 7: the position of share s among n numbers is s (n - 1).
TEST(OrderStatistics, QuantilesAreLinearBetweenNumbers) {
  const Eigen::Vector4d rising(1, 2, 4, 8);
  EXPECT_EQ(quantile(rising, 0), 1);
  EXPECT_EQ(quantile(rising, 1), 8);
  EXPECT_NEAR(quantile(rising, 0.5), 3, 1e-15);
  EXPECT_NEAR(quantile(rising, 0.75), 5, 1e-15);
  EXPECT_EQ(sorted(Eigen::Vector4d(4, 1, 8, 2)), rising);
}

TEST(OrderStatistics, RefuseSharesThatAreNone) {
  EXPECT_THROW((void)quantile(Eigen::Vector2d(1, 2), 1.1), InputError);
  EXPECT_THROW((void)quantile(Eigen::VectorXd(0), 0.5), InputError);
}

}  // namespace
}  // namespace thenar
