// Tests for base/units.h.

#include "base/units.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(Angles, HalfATurnIsThatOfTheCosine) {
  EXPECT_EQ(kPi, std::acos(-1.0));
  EXPECT_DOUBLE_EQ(radians(180), kPi);
  EXPECT_DOUBLE_EQ(degrees(kPi / 2), 90);
}

}  // namespace
}  // namespace thenar
