// Tests for sampling/methods/hamiltonian_trajectory.cpp: leapfrogs on a harmonic oscillator.

#include "sampling/methods/hamiltonian_trajectory.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random_stream.h"

namespace thenar::internal {
namespace {

/// A leapfrog for the standard normal density, whose gradient is -x.
void leap(PhasePoint& point, const MassMatrix& metric, double step) {
  begin_leapfrog(point, metric, step);
  end_leapfrog(point, metric, -point.x, step);
}

PhasePoint oscillator() {
  PhasePoint point{Eigen::Vector2d(1, -0.4), Eigen::Vector2d(0.3, 0.8), {}};
  point.slope = -point.x;
  return point;
}

// Leapfrogs of step h conserve  |r|^2 + (1 - h^2 / 4) |x|^2  on this density, however many.
TEST(Leapfrog, ConservesTheModifiedEnergy) {
  const MassMatrix metric(Metric::kDiagonal, 2);
  const double h = 0.7;
  const auto energy = [h](const PhasePoint& point) {
    return point.r.squaredNorm() + (1 - h * h / 4) * point.x.squaredNorm();
  };
  PhasePoint point = oscillator();
  const double before = energy(point);
  for (int k = 0; k < 1000; ++k) leap(point, metric, h);
  EXPECT_NEAR(energy(point), before, 1e-12);
}

TEST(Leapfrog, RunsBackToItsStart) {
  const MassMatrix metric(Metric::kDense, 2, Eigen::Vector2d(2, 0.5).asDiagonal());
  const PhasePoint start = oscillator();
  PhasePoint point = start;
  metric.whiten_gradient(-point.x, point.slope);
  for (int k = 0; k < 20; ++k) leap(point, metric, 0.1);
  EXPECT_GT((point.x - start.x).norm(), 0.1);
  for (int k = 0; k < 20; ++k) leap(point, metric, -0.1);
  EXPECT_LT((point.x - start.x).norm() + (point.r - start.r).norm(), 1e-13);
}

// A whitened length of pi/2 times a factor in 0.5 .. 1.5, in steps of 0.01; energy is conserved.
TEST(JitteredLength, TakesAsManyStepsAsItsLength) {
  RandomStream random(1, 0, 0);
  const auto trajectory = jittered_length();
  for (int run = 0; run < 20; ++run) {
    trajectory->start(oscillator(), 0.01, random);
    int steps = 1;
    while (!trajectory->judge(0, random).end) ++steps;
    EXPECT_GE(steps, 78);
    EXPECT_LE(steps, 236);
    EXPECT_EQ(trajectory->acceptance(), 1);
  }
}

// Divergence ends a trajectory without a new choice.
TEST(NoUTurn, EndsWhereTheEnergyErrorIsLarge) {
  RandomStream random(1, 0, 0);
  const auto trajectory = no_u_turn(2, 10);
  trajectory->start(oscillator(), 0.1, random);
  const Verdict verdict = trajectory->judge(kMaxEnergyError + 1, random);
  EXPECT_TRUE(verdict.end);
  EXPECT_FALSE(verdict.take);
  EXPECT_FALSE(verdict.adopt);
}

}  // namespace
}  // namespace thenar::internal
