// Tests for base/bounded_normal.cpp.

#include "base/bounded_normal.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/numbers.h"

namespace thenar {
namespace {

// Given bounds at -1.5 and 2.5 sds, x must have as much of the whole below it as z of the rest.
TEST(BoundedNormal, KeepsProbabilities) {
  const BoundedNormal map(-1.5, 2.5);
  const double whole = normal_probability(2.5) - normal_probability(-1.5);
  for (double x = -6; x <= 6; x += 0.37) {
    const double z = map.evaluate(x).z;
    EXPECT_GT(z, -1.5);
    EXPECT_LT(z, 2.5);
    EXPECT_NEAR((normal_probability(z) - normal_probability(-1.5)) / whole, normal_probability(x),
                1e-15);
  }
}

TEST(BoundedNormal, DerivativesAreThoseOfDifferences) {
  constexpr double kStep = 1e-5;
  for (const auto& [lower, upper] : {std::pair(-1.5, 2.5), {0.0, 8.0}, {-40.0, 0.3}})
    for (double x = -5; x <= 5; x += 0.5) {
      const auto z = [&](double l, double h, double at) {
        return BoundedNormal(l, h).evaluate(at).z;
      };
      const BoundedNormal::Image image = BoundedNormal(lower, upper).evaluate(x);
      EXPECT_NEAR(image.by_x, (z(lower, upper, x + kStep) - z(lower, upper, x - kStep)) / 2e-5,
                  1e-8);
      EXPECT_NEAR(image.by_upper, (z(lower, upper + kStep, x) - z(lower, upper - kStep, x)) / 2e-5,
                  1e-8);
      if (lower == 0) continue;  // the bound may not pass the prior mean
      EXPECT_NEAR(image.by_lower, (z(lower + kStep, upper, x) - z(lower - kStep, upper, x)) / 2e-5,
                  1e-8);
    }
}

// Close to a bound, h - z = Z Q(x) / phi(h) (1 - h d / 2 ..) with d = h - z itself.
TEST(BoundedNormal, IsAccurateNearABound) {
  constexpr double kUpper = 2;
  const BoundedNormal map(-kInfinity, kUpper);
  const double density = std::exp(-0.5 * kUpper * kUpper) / std::sqrt(2 * M_PI);
  for (const double x : {5.0, 6.0, 7.0}) {
    const double away = normal_probability(kUpper) * normal_probability(-x) / density;
    EXPECT_NEAR(kUpper - map.evaluate(x).z, away, 2 * away * away + 4e-16 * kUpper);
  }
  EXPECT_EQ(map.evaluate(45).z, kUpper);
  EXPECT_EQ(map.evaluate(45).by_x, 0);
}

TEST(BoundedNormal, LeavesAloneWhatNoBoundReaches) {
  const BoundedNormal map(-15, 12);
  for (double x = -8; x <= 6; x += 0.1) {
    EXPECT_NEAR(map.evaluate(x).z, x, 1e-14);
    EXPECT_NEAR(map.evaluate(x).by_x, 1, 1e-13);
  }
  const BoundedNormal half(-kInfinity, 1);
  EXPECT_EQ(half.evaluate(-50).z, -50);
}

TEST(BoundedNormal, IsInvertedWithinItsBounds) {
  const BoundedNormal map(-1.5, 2.5);
  for (double x = -3; x <= 3; x += 0.1) EXPECT_NEAR(map.inverse(map.evaluate(x).z), x, 1e-12);
  EXPECT_NEAR(map.evaluate(map.inverse(2.5)).z, 2.499, 1e-12);
  EXPECT_NEAR(map.evaluate(map.inverse(-7)).z, -1.499, 1e-12);
}

TEST(BoundedNormal, RefusesBoundsThatLeaveOutTheMean) {
  try {
    (void)BoundedNormal(1, 2);
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(), "bounds must enclose the prior mean, got 1 .. 2 prior sds");
  }
}

}  // namespace
}  // namespace thenar
