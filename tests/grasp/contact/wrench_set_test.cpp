// Tests for grasp/contact/wrench_set.cpp; the sets themselves are tested by grasp/quality.

#include "grasp/contact/wrench_set.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

const Wrench kWrench{{0.1, -0.2, 0.4}, {1, 2, 3}};  // [N m], [N]

// By hand: the force first, and moments over 0.5 m doubled.
TEST(ScaledWrench, HasTheForceFirstAndTheMomentOverTheScale) {
  ScaledWrench expected;
  expected << 1, 2, 3, 0.2, -0.4, 0.8;
  EXPECT_EQ(scaled_wrench(kWrench, 0.5), expected);
}

TEST(ScaledWrench, ConvertsBack) {
  const Wrench back = unscaled_wrench(scaled_wrench(kWrench, 0.5), 0.5);
  EXPECT_EQ(back.moment, kWrench.moment);
  EXPECT_EQ(back.force, kWrench.force);
}

}  // namespace
}  // namespace thenar
