// Tests for base/special_functions.cpp.

#include "base/special_functions.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/numbers.h"

namespace thenar {
namespace {

TEST(NormalQuantile, IsThePublishedOne) {
  // Tables: 97.5 %, 99.9 % and a billionth.
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-15);
  EXPECT_NEAR(normal_quantile(0.975), kNormal95HalfWidth, 1e-15);
  EXPECT_NEAR(normal_quantile(0.999), 3.090232306167814, 2e-15);
  EXPECT_NEAR(normal_quantile(1e-9), -5.997807015007687, 2e-15);
  EXPECT_EQ(normal_quantile(0.5), 0);
  EXPECT_EQ(normal_quantile(0), -kInfinity);
  EXPECT_EQ(normal_quantile(1), kInfinity);
}

// dp / p = z dz in the far tail, so an error of 1e-15 of z becomes z^2 1e-15 of p.
TEST(NormalQuantile, InvertsTheProbabilityInAllTails) {
  for (double log10_p = -300; log10_p < -0.31; log10_p += 0.7) {
    const double p = std::pow(10, log10_p), z = normal_quantile(p);
    EXPECT_NEAR(0.5 * std::erfc(-z * std::sqrt(0.5)) / p, 1, 2e-15 * (1 + z * z)) << p;
  }
}

}  // namespace
}  // namespace thenar
