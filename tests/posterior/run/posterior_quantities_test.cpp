// Tests for posterior/run/posterior_quantities.cpp: draws in the units that people read.

#include "posterior/run/posterior_quantities.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/posterior/run/small_run.h"

namespace thenar {
namespace {

using sample::sampled;

TEST(PosteriorQuantities, AreInTheUnitsOfPeople) {
  const std::vector<PosteriorQuantity> quantities = posterior_quantities(sampled(), 500);
  for (const PosteriorQuantity& q : quantities)
    if (q.name == "sensor/dorsal") {
      EXPECT_EQ(q.unit, "deg");
      EXPECT_NEAR(prior_sd(q), 4, 0.5);  // [deg]; 500 draws know it to 3 %
      return;
    }
  FAIL() << "no sensor tilt";
}

}  // namespace
}  // namespace thenar
