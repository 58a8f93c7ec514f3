// Tests for sampling/methods/target.cpp: densities of tempered chains.

#include "sampling/methods/target.h"

#include <limits>

#include <gtest/gtest.h>

namespace thenar::internal {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

TemperedDensity tempered_at(double log_prior, double log_likelihood, double beta) {
  Densities at;
  at.log_prior = Eigen::VectorXd::Constant(1, log_prior);
  at.log_likelihood = Eigen::VectorXd::Constant(1, log_likelihood);
  return tempered_density(at, 0, beta);
}

TEST(TemperedDensity, WeighsTheLikelihoodAlone) {
  EXPECT_EQ(tempered_at(-2, -8, 0.25).value, -4);
  EXPECT_EQ(tempered_at(-2, -8, 0).value, -2);
}

// Where the prior is zero, whatever the model says is no failure.
TEST(TemperedDensity, CountsFailuresOnlyWhereThePriorAllowsThem) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tempered_at(-kInfinite, nan, 1).value, -kInfinite);
  EXPECT_FALSE(tempered_at(-kInfinite, nan, 1).non_finite);
  for (const double broken : {nan, kInfinite}) {
    EXPECT_EQ(tempered_at(-2, broken, 0.5).value, -kInfinite);
    EXPECT_TRUE(tempered_at(-2, broken, 0.5).non_finite);
  }
}

// Also at beta = 0: a state without a likelihood could not be swapped down.
TEST(TemperedDensity, IsZeroWhereTheLikelihoodIs) {
  EXPECT_EQ(tempered_at(-2, -kInfinite, 0).value, -kInfinite);
  EXPECT_FALSE(tempered_at(-2, -kInfinite, 0).non_finite);
}

}  // namespace
}  // namespace thenar::internal
