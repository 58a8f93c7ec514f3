// Tests for posterior/bounded_table.cpp.

#include "posterior/bounded_table.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(BoundedTable, IsTheMapToTenDigits) {
  for (const auto& [lower, upper] : {std::pair(-1.5, 2.5), {0.0, 8.0}, {-3.9, 3.9}, {-9.0, 0.2}}) {
    const BoundedNormal exact(lower, upper);
    const BoundedTable table(exact);
    for (double x = -12; x <= 12; x += 0.0137) {
      EXPECT_NEAR(table.evaluate(x).z, exact.evaluate(x).z, 1e-10)
          << lower << " " << upper << " " << x;
      EXPECT_NEAR(table.evaluate(x).by_x, exact.evaluate(x).by_x, 1e-8)
          << lower << " " << upper << " " << x;
    }
  }
}

TEST(BoundedTable, IsSmoothWhereCellsMeet) {
  const BoundedTable table(BoundedNormal(-1.5, 2.5));
  constexpr double kLittle = 1e-13;
  for (double x = -8.5; x <= 8.5; x += 1.0 / 64) {
    const auto left = table.evaluate(x - kLittle), right = table.evaluate(x + kLittle);
    EXPECT_NEAR(left.z, right.z, 1e-12);
    EXPECT_NEAR(left.by_x, right.by_x, 1e-11);
  }
}

TEST(BoundedTable, IsInverted) {
  const BoundedTable table(BoundedNormal(-1.5, 2.5));
  for (double x = -3; x <= 3; x += 0.1) EXPECT_NEAR(table.inverse(table.evaluate(x).z), x, 1e-12);
  EXPECT_NEAR(table.evaluate(table.inverse(2.5)).z, 2.499, 1e-10);
}

TEST(BoundedTable, TakesNoNumberForNoNumber) {
  EXPECT_TRUE(std::isnan(BoundedTable(BoundedNormal(-1, 1)).evaluate(std::nan("")).z));
}

}  // namespace
}  // namespace thenar
