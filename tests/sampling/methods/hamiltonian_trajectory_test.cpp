// Tests for sampling/methods/hamiltonian_trajectory.cpp: leapfrogs on a harmonic oscillator.

#include "sampling/methods/hamiltonian_trajectory.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random_stream.h"

namespace thenar::internal {
namespace {

/// A leapfrog for the standard normal density, whose gradient is -x.
void leap(PhasePoint& point, const Whitening& whitening, double step) {
  begin_leapfrog(point, whitening, step);
  Eigen::VectorXd x;
  whitening.to_position(point.y, x);
  end_leapfrog(point, whitening, -x, step);
}

const Eigen::VectorXd kOrigin = Eigen::VectorXd::Zero(2);

PhasePoint oscillator() {
  PhasePoint point{Eigen::Vector2d(1, -0.4), Eigen::Vector2d(0.3, 0.8), {}};
  point.slope = -point.y;
  return point;
}

// Leapfrogs of step h conserve  |r|^2 + (1 - h^2 / 4) |x|^2  on this density, however many.
TEST(Leapfrog, ConservesTheModifiedEnergy) {
  const Whitening whitening(Metric::kDiagonal, kOrigin);
  const double h = 0.7;
  const auto energy = [h](const PhasePoint& point) {
    return point.r.squaredNorm() + (1 - h * h / 4) * point.y.squaredNorm();
  };
  PhasePoint point = oscillator();
  const double before = energy(point);
  for (int k = 0; k < 1000; ++k) leap(point, whitening, h);
  EXPECT_NEAR(energy(point), before, 1e-12);
}

TEST(Leapfrog, RunsBackToItsStart) {
  const Whitening whitening(Metric::kDense, kOrigin, Eigen::Vector2d(2, 0.5).asDiagonal());
  const PhasePoint start = oscillator();
  PhasePoint point = start;
  Eigen::VectorXd x;
  whitening.to_position(point.y, x);
  whitening.whiten_gradient(point.y, -x, point.slope);
  for (int k = 0; k < 20; ++k) leap(point, whitening, 0.1);
  EXPECT_GT((point.y - start.y).norm(), 0.1);
  for (int k = 0; k < 20; ++k) leap(point, whitening, -0.1);
  EXPECT_LT((point.y - start.y).norm() + (point.r - start.r).norm(), 1e-13);
}

/// Coordinates of a standard normal density that run along its orbits.
Whitening orbiting() {
  Whitening whitening(Metric::kDense, kOrigin);
  EXPECT_TRUE(whitening.set_map(kOrigin, Eigen::Matrix2d::Identity(), {}, true));
  return whitening;
}

// For the standard normal itself nothing is left of the gradient, and any step is exact.
TEST(Leapfrog, FollowsAnOrbitExactly) {
  const PhasePoint start = oscillator();
  PhasePoint point = start;
  point.slope.setZero();
  const double step = 1.3;
  for (int k = 0; k < 7; ++k) leap(point, orbiting(), step);
  const double angle = 7 * step;
  EXPECT_LT((point.y - std::cos(angle) * start.y - std::sin(angle) * start.r).norm(), 1e-14);
  EXPECT_LT((point.r - std::cos(angle) * start.r + std::sin(angle) * start.y).norm(), 1e-14);
}

// Where the target is an oscillator of another frequency w, a step is half a kick of (1 - w^2) y,
// a turn, and half a kick: a linear map of trace 2 cos h + h (1 - w^2) sin h, stable below pi for
// any w < 1.
TEST(Leapfrog, IsStableAlongOrbitsOfAWiderTarget) {
  for (const double w : {0.0, 0.3, 0.9})
    for (const double h : {0.1, 1.0, 1.57}) {
      PhasePoint point{Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), {}};
      point.slope = (1 - w * w) * point.y;
      const PhasePoint start = point;
      begin_leapfrog(point, orbiting(), h);
      end_leapfrog(point, orbiting(), -w * w * point.y, h);
      // The first coordinate began at (1, 0), the second at (0, 1): columns of the map.
      const double trace = point.y[0] + point.r[1],
                   determinant = point.y[0] * point.r[1] - point.y[1] * point.r[0];
      EXPECT_NEAR(trace, 2 * std::cos(h) + h * (1 - w * w) * std::sin(h), 1e-14);
      EXPECT_LT(std::abs(trace), 2);
      EXPECT_NEAR(determinant, 1, 1e-14);
    }
}

// A whitened length of pi/2 times a factor in 0.9 .. 1.6, 1.414 to 2.513, in the fewest equal
// leapfrogs.
TEST(JitteredLength, TakesAsManyStepsAsItsLength) {
  RandomStream random(1, 0, 0);
  const auto trajectory = jittered_trajectory();
  for (const double step : {0.01, 0.7, 5.0})
    for (int run = 0; run < 20; ++run) {
      trajectory->start(oscillator(), step, random);
      int steps = 1;
      while (!trajectory->assess_point(0, random).is_complete) ++steps;
      const double length = steps * trajectory->leapfrog_length();
      EXPECT_GE(length, 1.413);
      EXPECT_LE(length, 2.514);
      EXPECT_LE(trajectory->leapfrog_length(), step);
      EXPECT_LT(length, (steps - 1) * step + step * (1 + 1e-12));
      EXPECT_GT(length, (steps - 1) * step);
      EXPECT_EQ(trajectory->acceptance(), 1);
    }
}

// Divergence ends a trajectory without a new choice.
TEST(NoUTurn, EndsWhereTheEnergyErrorIsLarge) {
  RandomStream random(1, 0, 0);
  const auto trajectory = no_u_turn_trajectory(2, 10);
  trajectory->start(oscillator(), 0.1, random);
  const PointVerdict verdict = trajectory->assess_point(kMaxEnergyError + 1, random);
  EXPECT_TRUE(verdict.is_complete);
  EXPECT_FALSE(verdict.is_candidate);
  EXPECT_FALSE(verdict.selects_candidate);
}

}  // namespace
}  // namespace thenar::internal
