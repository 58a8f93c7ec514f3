// Tests for posterior/force_density.cpp.

#include "posterior/force_density.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

double normal(double r, double sd) {
  return std::exp(-0.5 * r * r / (sd * sd)) / (sd * std::sqrt(2 * kPi));
}

const Matrix3Xd kUnit = (Matrix3Xd(3, 2) << 0.3, -0.1, 0.2, 0.25, -0.4, 0.05).finished();
const std::vector<MuscleTension> kPulls{{0, 12, 9}, {1, 20, 36}};  // 12 +- 3 N, 20 +- 6 N
const Vector3d kForce(1, 9, -3), kSd(0.5, 0.8, 0.4);

/// Density of a force of which the tensions are known, integrated over what they may be.
double marginal(double noise) {
  constexpr int kSteps = 600;
  constexpr double kReach = 9;  // [sds]
  const double h = 2 * kReach / kSteps;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      const double a = -kReach + (i + 0.5) * h, b = -kReach + (j + 0.5) * h;
      const Vector3d r = kForce - kUnit * Eigen::Vector2d(12 + 3 * a, 20 + 6 * b);
      double density = normal(a, 1) * normal(b, 1) * h * h;
      for (int k = 0; k < 3; ++k) density *= normal(r[k], noise * kSd[k]);
      sum += density;
    }
  return std::log(sum);
}

TEST(TaskDensity, IsTheMarginalOverActivations) {
  for (const double noise : {1.0, 1.7})
    EXPECT_NEAR(task_density(ForceNoise(0), kUnit, kPulls, kForce, kSd, noise).log_density,
                marginal(noise), 1e-10);
}

TEST(TaskDensity, OfExactActivationsIsThatOfATrial) {
  std::vector<MuscleTension> exact = kPulls;
  for (MuscleTension& pull : exact) pull.variance = 0;
  double expected = 0;
  const Vector3d r = kForce - kUnit * Eigen::Vector2d(12, 20);
  for (int k = 0; k < 3; ++k) expected += std::log(normal(r[k], kSd[k]));
  EXPECT_NEAR(task_density(ForceNoise(0), kUnit, exact, kForce, kSd, 1).log_density, expected,
              1e-12);
}

TEST(TaskDensity, DerivativesAreThoseOfDifferences) {
  constexpr double kStep = 1e-5, kNoise = 1.3;
  for (const double robust : {0.0, 3.0}) {
    const ForceNoise model(robust);
    const auto f = [&](const Matrix3Xd& unit, double log_noise) {
      return task_density(model, unit, kPulls, kForce, kSd, std::exp(log_noise)).log_density;
    };
    const TaskDensity at = task_density(model, kUnit, kPulls, kForce, kSd, kNoise);
    for (Eigen::Index i = 0; i < kUnit.size(); ++i) {
      Matrix3Xd more = kUnit, less = kUnit;
      more.data()[i] += kStep;
      less.data()[i] -= kStep;
      const double slope = (f(more, std::log(kNoise)) - f(less, std::log(kNoise))) / (2 * kStep);
      EXPECT_NEAR(at.by_unit.data()[i], slope, 1e-6);
    }
    EXPECT_NEAR(
        at.by_log_noise,
        (f(kUnit, std::log(kNoise) + kStep) - f(kUnit, std::log(kNoise) - kStep)) / (2 * kStep),
        1e-8);
  }
}

// In spherical shells, radius r = tan(a): the tails of Cauchy's distribution are long.
TEST(ForceNoise, IsAProperDensity) {
  for (const double robust : {0.0, 1.0, 2.0, 3.0}) {
    const ForceNoise model(robust);
    constexpr int kSteps = 20000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double a = (i + 0.5) / kSteps * kPi / 2, r = std::tan(a);
      const double shell = 4 * kPi * r * r / std::pow(std::cos(a), 2) * (kPi / 2 / kSteps);
      sum += shell * std::exp(model.log_constant(3) + model.tail(r * r).log_density);
    }
    EXPECT_NEAR(sum, 1, 1e-6) << robust;
  }
}

// The fit's loss: 1/2 c^2 log(1 + m / c^2).
TEST(ForceNoise, IsCauchysLossOfTheFit) {
  const ForceNoise model(3);
  for (const double m : {1e-3, 1.0, 1e4})
    EXPECT_NEAR(model.tail(m).log_density, -4.5 * std::log1p(m / 9), 1e-12 * m);
}

}  // namespace
}  // namespace thenar
