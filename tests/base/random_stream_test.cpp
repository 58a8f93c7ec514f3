// Tests for base/random_stream.cpp.

#include "base/random_stream.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thenar {
namespace {

// Known answers of the authors' Random123 library.
TEST(Philox, GivesThePublishedBits) {
  const auto zero = philox({0, 0, 0, 0}, {0, 0});
  EXPECT_EQ(zero[0], 0x6627e8d5U);
  EXPECT_EQ(zero[1], 0xe169c58dU);
}

TEST(RandomStream, DependsOnEachOfItsNumbers) {
  const double first = RandomStream(1, 2, 3, 4).uniform();
  EXPECT_EQ(first, RandomStream(1, 2, 3, 4).uniform());
  EXPECT_NE(first, RandomStream(2, 2, 3, 4).uniform());
  EXPECT_NE(first, RandomStream(1, 3, 3, 4).uniform());
  EXPECT_NE(first, RandomStream(1, 2, 4, 4).uniform());
  EXPECT_NE(first, RandomStream(1, 2, 3, 5).uniform());
}

// Moments within 5 standard errors of 1e5 draws.
TEST(RandomStream, NormalHasTheMomentsOfANormal) {
  RandomStream stream(7, 0, 0);
  const int n = 100000;
  double sum = 0, square = 0, fourth = 0;
  for (int i = 0; i < n; ++i) {
    const double x = stream.normal();
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(square / n, 1, 5 * std::sqrt(2.0 / n));
  EXPECT_NEAR(fourth / n, 3, 5 * std::sqrt(96.0 / n));
}

// Mean nu, variance 2 nu; below two degrees of freedom as above. The standard error of a variance
// s is s sqrt((2 + 12 / nu) / n), by the kurtosis 3 + 12 / nu.
TEST(RandomStream, ChiSquareHasItsMoments) {
  for (const double nu : {0.5, 1.0, 7.3, 20.0}) {
    RandomStream stream(3, 1, 4);
    const int n = 50000;
    double sum = 0, square = 0;
    for (int i = 0; i < n; ++i) {
      const double x = stream.chi_square(nu);
      sum += x;
      square += (x - nu) * (x - nu);
    }
    EXPECT_NEAR(sum / n, nu, 5 * std::sqrt(2 * nu / n)) << nu;
    EXPECT_NEAR(square / n, 2 * nu, 5 * 2 * nu * std::sqrt((2 + 12 / nu) / n)) << nu;
  }
}

TEST(RandomStream, UniformStaysInsideAndIndexReachesAll) {
  RandomStream stream(1, 1, 1);
  std::array<int, 7> seen{};
  for (int i = 0; i < 7000; ++i) {
    const double u = stream.uniform();
    ASSERT_GT(u, 0);
    ASSERT_LT(u, 1);
    ++seen.at(static_cast<std::size_t>(stream.index(7)));
  }
  for (const int count : seen) EXPECT_NEAR(count, 1000, 5 * std::sqrt(1000));
}

}  // namespace
}  // namespace thenar
