// Tests for pad_laws/shear_shares.cpp.

#include "pad_laws/shear_shares.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(ShearShares, StickWithinTheRadiusOfTheClosedForm) {
  // Rings of a paraboloid of pressure, p = 1 - s^2, on even springs.
  constexpr int kRings = 4000;
  Eigen::VectorXd normal(kRings), stiffness(kRings);
  for (int i = 0; i < kRings; ++i) {
    const double s = (i + 0.5) / kRings, area = 2 * s / kRings;  // of pi a^2
    normal[i] = (1 - s * s) * area;
    stiffness[i] = 3 * area;
  }
  const double mu = 0.7, all = mu * normal.sum();
  for (const double part : {0.1, 0.5, 0.9}) {
    const ShearShares shares = share_shear(normal, stiffness, mu, part * all);
    EXPECT_NEAR(shares.borne, part * all, 1e-12);
    const auto sticking = std::count(shares.sticks.begin(), shares.sticks.end(), true);
    EXPECT_NEAR(static_cast<double>(sticking) / kRings, std::pow(1 - part, 0.25), 1.0 / kRings);
  }
  // Beyond friction all slips, and without a load nothing does.
  const ShearShares over = share_shear(normal, stiffness, mu, 2 * all);
  EXPECT_NEAR(over.borne, all, 1e-12);
  EXPECT_EQ(std::count(over.sticks.begin(), over.sticks.end(), true), 0);
  const ShearShares free = share_shear(normal, stiffness, mu, 0);
  EXPECT_EQ(std::count(free.sticks.begin(), free.sticks.end(), false), 0);
}

}  // namespace
}  // namespace thenar
