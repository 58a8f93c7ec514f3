// Tests for posterior/tilt_density.cpp.

#include "posterior/tilt_density.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::Vector2d;

double density(const Vector2d& tilt, const Vector2d& centre, double k) {
  return std::exp(tilt_density(tilt, centre, k).log_density);
}

// Over the whole hemisphere: radius tan(a), midpoint rule in angle a and turn.
TEST(TiltDensity, IntegratesToOne) {
  constexpr int kAngles = 4000, kTurns = 8;
  for (const double k : {0.9, 32.8, 800.0}) {
    double sum = 0;
    for (int i = 0; i < kAngles; ++i)
      for (int j = 0; j < kTurns; ++j) {
        const double a = (i + 0.5) / kAngles * kPi / 2, turn = 2 * kPi * j / kTurns;
        const double radius = std::tan(a), area = radius / std::pow(std::cos(a), 2);
        sum += density(radius * Vector2d(std::cos(turn), std::sin(turn)), {0, 0}, k) * area *
               (kPi / 2 / kAngles) * (2 * kPi / kTurns);
      }
    EXPECT_NEAR(sum, 1, 1e-5) << k;
  }
}

// exp(k cos) of the angle between two directions, times the solid angle of the chart.
TEST(TiltDensity, DependsOnTheAngleBetweenDirections) {
  const auto direction = [](const Vector2d& t) {
    return Eigen::Vector3d(1, t.x(), t.y()).normalized();
  };
  const Vector2d centre(0.3, -0.2), a(0.1, 0.4), b(-0.5, -0.1);
  constexpr double kConcentration = 20;
  const double expected = kConcentration * (direction(a) - direction(b)).dot(direction(centre)) -
                          1.5 * std::log((1 + a.squaredNorm()) / (1 + b.squaredNorm()));
  EXPECT_NEAR(tilt_density(a, centre, kConcentration).log_density -
                  tilt_density(b, centre, kConcentration).log_density,
              expected, 1e-13);
}

TEST(TiltDensity, IsNormalForSmallTilts) {
  constexpr double kTiltSd = 1e-4;
  for (const Vector2d& z : {Vector2d(0, 0), Vector2d(1, -2)}) {
    const double normal = -std::log(2 * kPi * kTiltSd * kTiltSd) - 0.5 * z.squaredNorm();
    EXPECT_NEAR(tilt_density(kTiltSd * z, {0, 0}, 1 / (kTiltSd * kTiltSd)).log_density, normal,
                1e-6);
  }
}

TEST(TiltDensity, DerivativesAreThoseOfDifferences) {
  const Vector2d tilt(0.5, -0.8), centre(-0.2, 0.3);
  constexpr double kConcentration = 3, kStep = 1e-5;
  const TiltDensity at = tilt_density(tilt, centre, kConcentration);
  const auto f = [&](const Vector2d& t, const Vector2d& c, double log_k) {
    return tilt_density(t, c, std::exp(log_k)).log_density;
  };
  const double log_k = std::log(kConcentration);
  for (int i = 0; i < 2; ++i) {
    const Vector2d step = kStep * Vector2d::Unit(i);
    EXPECT_NEAR(at.by_tilt[i],
                (f(tilt + step, centre, log_k) - f(tilt - step, centre, log_k)) / (2 * kStep),
                1e-8);
    EXPECT_NEAR(at.by_centre[i],
                (f(tilt, centre + step, log_k) - f(tilt, centre - step, log_k)) / (2 * kStep),
                1e-8);
  }
  EXPECT_NEAR(at.by_log_concentration,
              (f(tilt, centre, log_k + kStep) - f(tilt, centre, log_k - kStep)) / (2 * kStep),
              1e-8);
}

// Over a hemisphere, E cos = 1 / (1 - exp(-k)) - 1 / k, by parts.
TEST(TiltDensity, DrawsHaveItsMeanCosine) {
  constexpr int kDraws = 20000;
  for (const double k : {0.9, 30.0}) {
    RandomStream random(7, 0, 0);
    double sum = 0, squares = 0;
    Vector2d mean(0, 0);
    for (int i = 0; i < kDraws; ++i) {
      const Vector2d t = draw_tilt({0, 0}, k, random);
      const double cosine = 1 / std::sqrt(1 + t.squaredNorm());
      sum += cosine / kDraws;
      squares += cosine * cosine / kDraws;
      mean += t * cosine / kDraws;
    }
    const double error = std::sqrt((squares - sum * sum) / kDraws);
    EXPECT_NEAR(sum, 1 / -std::expm1(-k) - 1 / k, 4 * error);
    EXPECT_LT(mean.norm(), 4 / std::sqrt(kDraws)) << "directions have no side";
  }
}

TEST(TiltDensity, DrawsLieAboutTheirCentre) {
  RandomStream random(8, 0, 0);
  Vector2d mean(0, 0);
  for (int i = 0; i < 4000; ++i) mean += draw_tilt({0.5, -0.25}, 1e4, random) / 4000;
  // sd 0.01 rad; tilts stretch it by at most 1 + |t|^2 = 1.31.
  EXPECT_TRUE(matrix_near(mean, Vector2d(0.5, -0.25), 4 * 0.0131 / std::sqrt(4000.0)));
}

}  // namespace
}  // namespace thenar
