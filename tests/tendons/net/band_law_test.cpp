// Tests for tendons/net/band_law.cpp.

#include "tendons/net/band_law.h"

#include <gtest/gtest.h>

namespace thenar {
namespace {

constexpr double kSlack = 0.02, kEA = 150, kBlend = 1e-3;

// Tension is the slope of the energy, stiffness that of the tension, at any length and toe.
TEST(BlendedPull, IsOnePotential) {
  for (const double toe : {0.0, 0.02})
    for (const double e : {-0.9, -0.1, -1e-3, -1e-4, 0.0, 1e-4, 1e-3, 0.0195, 0.0205, 0.1}) {
      const double L = kSlack * (1 + e), h = 1e-8;
      const auto at = [&](double length) {
        return smoothed_response(length, kSlack, kEA, toe, kBlend);
      };
      const BandResponse low = at(L - h), here = at(L), high = at(L + h);
      EXPECT_NEAR((high.energy - low.energy) / (2 * h), here.tension, 1e-6 * here.tension + 1e-8)
          << toe << " " << e;
      EXPECT_NEAR((high.tension - low.tension) / (2 * h), here.stiffness,
                  1e-5 * here.stiffness + 1e-3)
          << toe << " " << e;
      EXPECT_GT(here.tension, 0);
      EXPECT_GT(here.stiffness, 0);
    }
}

// Far from the slack length it is the law without a blend, to the order of blend^2.
TEST(BlendedPull, TendsToTheLawWithoutBlend) {
  for (const double toe : {0.0, 0.02})
    for (const double e : {0.03, 0.1}) {
      const double L = kSlack * (1 + e);
      EXPECT_NEAR(smoothed_response(L, kSlack, kEA, toe, kBlend).tension,
                  band_response(L, kSlack, kEA, toe).tension, kEA * kBlend * kBlend / (2 * e));
    }
  EXPECT_LT(smoothed_response(0.9 * kSlack, kSlack, kEA, 0, kBlend).tension, 1e-3);  // [N]
}

TEST(BlendedPull, IsNothingAtNoLength) {
  const BandResponse none = smoothed_response(0, kSlack, kEA, 0, kBlend);
  EXPECT_NEAR(none.tension, 0, 1e-15);
  EXPECT_NEAR(none.energy, 0, 1e-15);
}

}  // namespace
}  // namespace thenar
