// Tests for tendons/muscle/exponentials.h.

#include "tendons/muscle/exponentials.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thenar {
namespace {

// Against the C library, whose exp() is within one unit in the last place.
TEST(Exponentials, AreThoseOfSingleNumbers) {
  for (const Eigen::Index n : {1, 2, 5}) {
    for (double from = -708; from < 709; from += 0.0371) {
      const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(n, from, std::min(from + 0.3, 709.0));
      Eigen::VectorXd y = x;
      exponentials(y);
      for (Eigen::Index i = 0; i < n; ++i) EXPECT_NEAR(y[i] / std::exp(x[i]), 1, 1e-15) << x[i];
    }
  }
}

TEST(Exponentials, AreOneAtZeroAndNeverInfinite) {
  Eigen::VectorXd x = (Eigen::VectorXd(5) << 0, -1e300, 1e300, -HUGE_VAL, HUGE_VAL).finished();
  exponentials(x);
  EXPECT_EQ(x[0], 1);
  EXPECT_LT(x[1], 1e-307);
  EXPECT_LT(x[3], 1e-307);
  EXPECT_GT(x[2], 1e307);
  EXPECT_TRUE(std::isfinite(x[2]) && std::isfinite(x[4]));
}

}  // namespace
}  // namespace thenar
