// Tests for tendons/muscle/hill_curves.cpp.

#include "tendons/muscle/hill_curves.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thenar {
namespace {

TEST(HillCurves, ActiveForceIsOneAtOptimalLengthAndGreatestNearIt) {
  EXPECT_NEAR(active_force(1), 1, 1e-15);
  for (double l = 0; l < 2.5; l += 0.01) EXPECT_LE(active_force(l), 1.002) << l;
}

// Sums of the published bells with their published rounded constants; b11 differs by 1e-3.
TEST(HillCurves, ActiveForceIsThePublishedSumOfBells) {
  const auto published = [](double l) {
    const auto bell = [&](double b1, double b2, double b3, double b4) {
      return b1 * std::exp(-(l - b2) * (l - b2) / (2 * (b3 + b4 * l) * (b3 + b4 * l)));
    };
    return bell(0.815, 1.055, 0.162, 0.063) + bell(0.433, 0.717, -0.030, 0.200) +
           bell(0.100, 1.000, 0.354, 0);
  };
  for (double l = 0.4; l < 2; l += 0.05) EXPECT_NEAR(active_force(l), published(l), 1e-3) << l;
}

// The second bell's width vanishes at l = 0.15: no blow-up there.
TEST(HillCurves, ActiveForceIsSmallAndSmoothInVeryShortFibres) {
  for (double l = 0; l < 0.3; l += 0.001) {
    EXPECT_GE(active_force(l), 0);
    EXPECT_LT(active_force(l), 0.015);
    EXPECT_NEAR(active_force(l + 1e-6), active_force(l), 1e-6);  // slope below 1
  }
}

TEST(HillCurves, NoForceAtLargestSpeedAndOneAtRest) {
  EXPECT_NEAR(force_velocity(-1), 0, 1e-14);
  EXPECT_NEAR(force_velocity(0), 1, 1e-14);
}

// The constants that are solved for are within the rounding of the fit from the published ones.
TEST(HillCurves, ForceVelocityIsThePublishedCurve) {
  for (double v = -1; v <= 1; v += 0.1) {
    const double x = -8.149 * v - 0.374;
    EXPECT_NEAR(force_velocity(v), -0.318 * std::log(x + std::sqrt(x * x + 1)) + 0.886, 0.013) << v;
  }
}

TEST(HillCurves, ForceVelocitySlopeIsItsDerivative) {
  constexpr double h = 1e-6;
  for (double v = -1.5; v < 2; v += 0.1)
    EXPECT_NEAR(force_velocity_derivative(v),
                (force_velocity(v + h) - force_velocity(v - h)) / (2 * h),
                1e-8)  // rounding / h
        << v;
}

TEST(HillCurves, PassiveForceStartsAtOptimalLengthAndIsOneAtSixtyPercentStretch) {
  EXPECT_EQ(passive_force(0.5), 0);
  EXPECT_EQ(passive_force(1), 0);
  EXPECT_NEAR(passive_force(1.6), 1, 1e-15);
}

TEST(HillCurves, TendonCarriesF0AtItsStrain) {
  EXPECT_NEAR(tendon_force(1 + kTendonStrain), 1, 1e-14);
  EXPECT_NEAR(tendon_force(1.1, 0.1), 1, 1e-14);
  EXPECT_NEAR(tendon_force(1.02), 0.2 * std::exp(35 * 0.025) - 0.25, 1e-14);
}

TEST(HillCurves, SlackTendonCarriesNothing) {
  for (const double strain : {0.01, kTendonStrain, 0.1}) {
    EXPECT_EQ(tendon_force(0.9, strain), 0);
    EXPECT_NEAR(tendon_force(taut_tendon(strain), strain), 0, 1e-14);
    EXPECT_GT(tendon_force(taut_tendon(strain) + 1e-6, strain), 0);
  }
}

// Whole arrays give what single fibres do: to rounding of numbers of the size of F0, or of the
// curve where that is larger; no force is negative, and lengths beyond doubles stay infinite.
// By Simpson's rule over a hundred pieces from where the tendon is just taut.
TEST(HillCurves, EnergyOfATendonIsTheIntegralOfItsForce) {
  for (const double strain : {0.01, kTendonStrain}) {
    const double begin = taut_tendon(strain), end = 1 + 1.2 * strain;
    const int pieces = 100;
    double sum = 0;
    for (int i = 0; i <= 2 * pieces; ++i)
      sum += (i == 0 || i == 2 * pieces ? 1
              : i % 2 == 1              ? 4
                                        : 2) *
             tendon_force(begin + (end - begin) * i / (2 * pieces), strain);
    const double integral = sum * (end - begin) / (6 * pieces);
    EXPECT_NEAR(tendon_energy(end, strain), integral, 1e-8 * integral);
    EXPECT_EQ(tendon_energy(0.999, strain), 0);
  }
}

TEST(HillCurves, ArraysAgreeWithSingleFibres) {
  constexpr double kRounding = 1e-14;
  const auto expect_near = [](double a, double b, double at) {
    EXPECT_NEAR(a, b, kRounding * std::max(1.0, std::abs(b))) << at;
  };
  LengthForces by_length;
  SpeedForces by_speed;
  for (const Eigen::Index fibres : {1, 2, 7}) {
    const Eigen::VectorXd more = Eigen::VectorXd::LinSpaced(fibres, 0, 0.02);
    for (double at = 0; at < 3; at += 0.003) {
      const Eigen::VectorXd l = more.array() + at, v = 4 * (l.array() - 1.5);
      set_length_forces(l, by_length);
      set_speed_forces(v, by_speed);
      for (Eigen::Index i = 0; i < fibres; ++i) {
        expect_near(by_length.active[i], active_force(l[i]), l[i]);
        expect_near(by_length.active_slope[i], active_force_derivative(l[i]), l[i]);
        expect_near(by_length.passive[i], passive_force(l[i]), l[i]);
        expect_near(by_length.passive_slope[i], passive_force_derivative(l[i]), l[i]);
        EXPECT_GE(by_length.passive[i], 0);
        expect_near(by_speed.force[i], force_velocity(v[i]), v[i]);
        expect_near(by_speed.slope[i], force_velocity_derivative(v[i]), v[i]);
      }
    }
  }
  set_length_forces(Eigen::VectorXd::Constant(3, 1000), by_length);
  EXPECT_TRUE((by_length.passive.array() == HUGE_VAL).all());
  EXPECT_TRUE((by_length.passive_slope.array() == HUGE_VAL).all());
}

// The second bell has no width at this length: there and below it adds nothing.
TEST(HillCurves, ArraysPassTheLengthWithoutASecondBell) {
  LengthForces by_length;
  const Eigen::VectorXd l =
      (Eigen::VectorXd(4) << 0.1, 0.15, std::nextafter(0.15, 1), 0.2).finished();
  set_length_forces(l, by_length);
  for (Eigen::Index i = 0; i < l.size(); ++i) {
    EXPECT_NEAR(by_length.active[i], active_force(l[i]), 1e-15);
    EXPECT_NEAR(by_length.active_slope[i], active_force_derivative(l[i]), 1e-15);
  }
}

}  // namespace
}  // namespace thenar
