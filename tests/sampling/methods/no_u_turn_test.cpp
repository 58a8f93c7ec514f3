// Tests for sampling/methods/no_u_turn.cpp and the leapfrog, against recursion written out.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "sampling/methods/hamiltonian_trajectory.h"
#include "tests/matrix_near.h"

namespace thenar::internal {
namespace {

// A bent density in two dimensions: energies and turns vary from place to place.
double log_density(const Eigen::VectorXd& x) {
  const double bend = x[1] - 0.5 * x[0] * x[0];
  return -0.5 * x[0] * x[0] - 2 * bend * bend;
}

Eigen::VectorXd gradient(const Eigen::VectorXd& x) {
  const double bend = x[1] - 0.5 * x[0] * x[0];
  return Eigen::Vector2d(-x[0] + 4 * bend * x[0], -4 * bend);
}

/// Bent coordinates, in which points run along orbits.
Whitening whitening() {
  Whitening made(Metric::kDense, Eigen::Vector2d(0.1, -0.2));
  Bend bend;
  bend.drivers = 1;
  bend.strength = Eigen::Vector2d(0, 0.2);
  const Eigen::Matrix2d F = (Eigen::Matrix2d() << 1, 0, 0.3, 0.6).finished();
  EXPECT_TRUE(made.set_map(Eigen::Vector2d(0.1, -0.2), F, bend, true));
  return made;
}
const Whitening kWhitening = whitening();

Eigen::VectorXd place(const PhasePoint& p) {
  Eigen::VectorXd x;
  kWhitening.to_position(p.y, x);
  return x;
}

double energy(const PhasePoint& p) { return 0.5 * p.r.squaredNorm() - log_density(place(p)); }

PhasePoint at(const Eigen::Vector2d& y, const Eigen::Vector2d& r) {
  PhasePoint p{y, r, Eigen::VectorXd(2)};
  kWhitening.whiten_gradient(p.y, gradient(place(p)), p.slope);
  return p;
}

void leapfrog(PhasePoint& p, double step) {
  begin_leapfrog(p, kWhitening, step);
  end_leapfrog(p, kWhitening, gradient(place(p)), step);
}

TEST(Leapfrog, RunsBackToWhereItCameFrom) {
  PhasePoint p = at({0.3, -0.4}, {1.1, 0.7});
  for (int i = 0; i < 50; ++i) leapfrog(p, 0.2);
  EXPECT_GT((p.y - Eigen::Vector2d(0.3, -0.4)).norm(), 0.1);
  for (int i = 0; i < 50; ++i) leapfrog(p, -0.2);
  EXPECT_TRUE(matrix_near(p.y, Eigen::Vector2d(0.3, -0.4), 1e-10));
  EXPECT_TRUE(matrix_near(p.r, Eigen::Vector2d(1.1, 0.7), 1e-10));
}

// Over a fixed time the energy error falls by 4 when the step is halved.
TEST(Leapfrog, IsOfSecondOrder) {
  const auto error = [](int steps) {
    PhasePoint p = at({0.3, -0.4}, {1.1, 0.7});
    const double before = energy(p);
    for (int i = 0; i < steps; ++i) leapfrog(p, 1.3 / steps);
    return energy(p) - before;
  };
  EXPECT_GT(std::abs(error(20)), 1e-5);
  EXPECT_NEAR(error(100) / error(200), 4, 0.01);
}

// The map (y, r) -> (y, r) keeps volume: its Jacobian, by differences, has determinant 1.
TEST(Leapfrog, KeepsVolume) {
  const double h = 1e-5;
  Eigen::Matrix4d jacobian;
  for (int k = 0; k < 4; ++k) {
    Eigen::Vector4d to = Eigen::Vector4d::Zero();
    for (const double sign : {1.0, -1.0}) {
      Eigen::Vector4d z(0.3, -0.4, 1.1, 0.7);
      z[k] += sign * h;
      PhasePoint p = at(z.head<2>(), z.tail<2>());
      for (int i = 0; i < 5; ++i) leapfrog(p, 0.3);
      to += sign * (Eigen::Vector4d() << p.y, p.r).finished() / (2 * h);
    }
    jacobian.col(k) = to;
  }
  EXPECT_NEAR(jacobian.determinant(), 1, 1e-7);
}

/// All points of a trajectory in the order of time; the start is one of them.
struct Line {
  std::vector<PhasePoint> points;
  double start_energy = 0;

  [[nodiscard]] Eigen::VectorXd rho(int first, int last) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(2);
    for (int i = first; i <= last; ++i) sum += points[static_cast<std::size_t>(i)].r;
    return sum;
  }
  [[nodiscard]] bool straight(const Eigen::VectorXd& sum, int first, int last) const {
    return sum.dot(points[static_cast<std::size_t>(first)].r) > 0 &&
           sum.dot(points[static_cast<std::size_t>(last)].r) > 0;
  }
  /// The criterion for points first .. last as two halves.
  [[nodiscard]] bool halves_straight(int first, int last) const {
    const int middle = (first + last) / 2;
    return straight(rho(first, last), first, last) &&
           straight(rho(first, middle + 1), first, middle + 1) &&
           straight(rho(middle, last), middle, last);
  }
  /// The same for it and all subtrees, by recursion.
  [[nodiscard]] bool all_straight(int first, int last) const {
    if (first == last) return true;
    const int middle = (first + last) / 2;
    return all_straight(first, middle) && all_straight(middle + 1, last) &&
           halves_straight(first, last);
  }
};

struct TreeChoice {
  PhasePoint choice;
  int depth = 0, leapfrogs = 0;
};

/// The sampler's algorithm as it is in books: a half is built whole, then judged by recursion.
TreeChoice by_recursion(const PhasePoint& from, double step, int max_depth, RandomStream& random) {
  Line line{{from}, energy(from)};
  TreeChoice outcome{from};
  double weight = 1;
  while (outcome.depth < max_depth) {
    const bool forward = random.uniform() < 0.5;
    const int size = 1 << outcome.depth;
    PhasePoint moving = forward ? line.points.back() : line.points.front();
    PhasePoint candidate;
    double half = 0;
    for (int i = 0; i < size; ++i) {
      leapfrog(moving, forward ? step : -step);
      line.points.insert(forward ? line.points.end() : line.points.begin(), moving);
      ++outcome.leapfrogs;
      if (energy(moving) - line.start_energy > 1000) return outcome;
      const double own = std::exp(line.start_energy - energy(moving));
      half += own;
      if (i == 0 || random.uniform() < own / half) candidate = moving;
      // Complete subtrees that end here, the longest last.
      for (int length = 2; length <= i + 1 && (i + 1) % length == 0; length *= 2) {
        const int last = forward ? static_cast<int>(line.points.size()) - 1 : length - 1;
        if (!line.all_straight(last - length + 1, last)) return outcome;
      }
    }
    if (random.uniform() < half / weight) outcome.choice = candidate;
    weight += half;
    ++outcome.depth;
    if (!line.halves_straight(0, static_cast<int>(line.points.size()) - 1)) return outcome;
  }
  return outcome;
}

TreeChoice by_loop(const PhasePoint& from, double step, int max_depth, RandomStream& random) {
  const auto trajectory = no_u_turn_trajectory(2, max_depth);
  const double start_energy = energy(from);
  TreeChoice outcome{from};
  PhasePoint candidate;
  trajectory->start(from, step, random);
  while (true) {
    PhasePoint& moving = trajectory->moving_point();
    leapfrog(moving, trajectory->leapfrog_length());
    const PhasePoint latest = moving;
    ++outcome.leapfrogs;
    const PointVerdict verdict = trajectory->assess_point(energy(latest) - start_energy, random);
    if (verdict.is_candidate) candidate = latest;
    if (verdict.selects_candidate) outcome.choice = candidate;
    if (verdict.is_complete) break;
  }
  outcome.depth = trajectory->depth();
  return outcome;
}

TEST(NoUTurn, ChoosesAsRecursionDoes) {
  std::vector<int> seen(8, 0);
  for (std::uint32_t chain = 0; chain < 2000; ++chain) {
    RandomStream place(5, chain, 0), a(5, chain, 1), b(5, chain, 1);
    const PhasePoint from = at({place.normal(), place.normal()}, {place.normal(), place.normal()});
    const double step = 0.6 * std::pow(0.02, place.uniform());
    const TreeChoice wanted = by_recursion(from, step, 7, a), got = by_loop(from, step, 7, b);
    ASSERT_EQ(got.leapfrogs, wanted.leapfrogs) << chain;
    ASSERT_EQ(got.depth, wanted.depth) << chain;
    ASSERT_EQ(got.choice.y, wanted.choice.y) << chain;
    ++seen[static_cast<std::size_t>(got.depth)];
  }
  // Each depth that can occur did; 7 is the limit.
  for (std::size_t depth = 1; depth < 8; ++depth) EXPECT_GT(seen[depth], 10) << depth;
}

TEST(NoUTurn, EndsWhereTheEnergyErrorIsTooLarge) {
  RandomStream random(1, 0, 0);
  const auto trajectory = no_u_turn_trajectory(2, 10);
  trajectory->start(at({0, 0}, {1, 0}), 0.1, random);
  const PointVerdict verdict = trajectory->assess_point(1001, random);
  EXPECT_TRUE(verdict.is_complete);
  EXPECT_FALSE(verdict.selects_candidate);
  EXPECT_EQ(trajectory->acceptance(), 0);
}

TEST(JitteredLength, RunsAQuarterTurnOrSomewhatMore) {
  const double quarter = std::acos(-1.0) / 2, step = 0.01;
  int least = 1000, most = 0;
  for (std::uint32_t i = 0; i < 500; ++i) {
    RandomStream random(1, 0, i);
    const auto trajectory = jittered_trajectory();
    trajectory->start(at({0, 0}, {1, 0}), step, random);
    int leapfrogs = 1;
    while (!trajectory->assess_point(0, random).is_complete) ++leapfrogs;
    least = std::min(least, leapfrogs);
    most = std::max(most, leapfrogs);
  }
  // Uniform over 0.9 .. 1.6: the extremes of 500 are within 2 % of the range of its ends.
  EXPECT_NEAR(least * step, 0.9 * quarter, 0.02 * quarter);
  EXPECT_NEAR(most * step, 1.6 * quarter, 0.02 * quarter);
}

}  // namespace
}  // namespace thenar::internal
