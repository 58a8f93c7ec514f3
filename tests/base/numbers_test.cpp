// Tests for base/worst.h.

#include "base/numbers.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(Worst, IsTheLargestOrTheSmallest) {
  EXPECT_EQ(max_or_nan(1, 2), 2);
  EXPECT_EQ(max_or_nan(2, 1), 2);
  EXPECT_EQ(min_or_nan(1, 2), 1);
  EXPECT_EQ(min_or_nan(2, 1), 1);
  EXPECT_EQ(max_or_nan({1, 3, 2}), 3);
  EXPECT_EQ(max_or_nan(Eigen::Vector3d(1, 3, 2)), 3);
}

TEST(Worst, IsNotANumberWhereverOneIsNot) {
  EXPECT_TRUE(std::isnan(max_or_nan(1, kNaN)));
  EXPECT_TRUE(std::isnan(max_or_nan(kNaN, 1)));
  EXPECT_TRUE(std::isnan(min_or_nan(1, kNaN)));
  EXPECT_TRUE(std::isnan(min_or_nan(kNaN, 1)));
  for (int at = 0; at < 5; ++at) {
    Eigen::VectorXd entries = Eigen::VectorXd::LinSpaced(5, -1, 3);
    entries(at) = kNaN;
    EXPECT_TRUE(std::isnan(max_or_nan(entries))) << at;
    EXPECT_TRUE(
        std::isnan(max_or_nan({entries(0), entries(1), entries(2), entries(3), entries(4)})))
        << at;
  }
}

}  // namespace
}  // namespace thenar
