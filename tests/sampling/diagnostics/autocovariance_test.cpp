// Tests for sampling/diagnostics/autocovariance.cpp.

#include "sampling/diagnostics/autocovariance.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/matrix_near.h"
#include "tests/sampling/diagnostics/reference_chains.h"

namespace thenar {
namespace {

using sample::autoregressive;

// Sums one by one and FFT are the same numbers.
TEST(Autocovariance, IsTheSameByHandAndByFft) {
  // 1, 2, 4, 1 have the mean 2: deviations -1, 0, 2, -1.
  EXPECT_NEAR(autocovariance(Eigen::Vector4d(1, 2, 4, 1))[0], 6.0 / 4, 1e-15);
  EXPECT_NEAR(autocovariance(Eigen::Vector4d(1, 2, 4, 1))[1], -2.0 / 4, 1e-15);
  const Eigen::VectorXd x = autoregressive(0.9, 777, 1);
  EXPECT_TRUE(matrix_near(autocovariance(x, 50), autocovariance(x).head(50), 1e-14));
}

TEST(Autocovariance, RefusesMoreLagsThanDraws) {
  EXPECT_THROW((void)autocovariance(Eigen::Vector3d(1, 2, 4), 4), InputError);
  EXPECT_EQ(autocovariance(Eigen::Vector3d(1, 2, 4), 0).size(), 0);
}

}  // namespace
}  // namespace thenar
