// Tests for sampling/diagnostics/modes.cpp: draws sorted into modes, and their masses.

#include "sampling/diagnostics/modes.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random_stream.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Chains of n coordinates from a function of chain, draw and random numbers.
Draws make_draws(int n, int draws, int chains, unsigned seed,
                 const std::function<Eigen::VectorXd(int chain, int draw, RandomStream&)>& point) {
  Draws all;
  for (int chain = 0; chain < chains; ++chain) {
    RandomStream random(seed, chain, 0);
    Eigen::MatrixXd x(n, draws);
    for (int i = 0; i < draws; ++i) x.col(i) = point(chain, i, random);
    all.x.push_back(x);
    all.group.push_back(chain);
  }
  return all;
}

Eigen::VectorXd normal(int n, RandomStream& random) {
  return Eigen::VectorXd::NullaryExpr(n, [&] { return random.normal(); });
}

/// 1/3 N(-5, I) + 2/3 N(5, I), independent draws.
Draws two_modes(int n, int draws = 1000) {
  return make_draws(n, draws, 4, 1, [n](int, int, RandomStream& random) -> Eigen::VectorXd {
    const double centre = random.uniform() < 1.0 / 3 ? -5 : 5;
    return normal(n, random).array() + centre;
  });
}

TEST(Modes, FindsTwoUnequalOnes) {
  for (const int n : {1, 2, 20}) {
    const ModeTable table = tabulate_modes(two_modes(n));
    ASSERT_EQ(table.modes.size(), 2U) << n;
    const ModeMass& heavy = table.modes[0];
    const double expected = std::sqrt(2.0 / 9 / 4000);  // binomial: the draws are independent
    EXPECT_NEAR(heavy.mcse / expected, 1, 0.1);
    EXPECT_NEAR(heavy.mass, 2.0 / 3, 4 * expected);
    EXPECT_TRUE(matrix_near(heavy.centre, Eigen::VectorXd::Constant(n, 5), 0.1));
    EXPECT_TRUE(matrix_near(table.modes[1].centre, Eigen::VectorXd::Constant(n, -5), 0.15));
    EXPECT_TRUE(matrix_near(heavy.sd, Eigen::VectorXd::Ones(n), 0.1));
    EXPECT_THAT(table.warnings, IsEmpty());
    // An independent draw changes mode with probability 2 * 1/3 * 2/3.
    EXPECT_NEAR(double(table.crossings) / (4 * 999), 4.0 / 9, 0.04);
  }
}

// A chain that leaves the light mode with probability a and the heavy one with b at every step:
// masses b/(a+b), indicators correlated by rho = 1 - a - b, variance p (1-p) (1+rho)/(1-rho) / N.
TEST(Modes, ErrorOfAMassCountsCrossings) {
  const double a = 0.04, b = 0.02, rho = 1 - a - b;
  bool light = false;
  const Draws draws = make_draws(2, 5000, 4, 8, [&](int, int, RandomStream& random) {
    light = random.uniform() < (light ? 1 - a : b);
    return Eigen::VectorXd(normal(2, random).array() + (light ? 8 : 0));
  });
  const ModeTable table = tabulate_modes(draws);
  ASSERT_EQ(table.modes.size(), 2U);
  const double expected = std::sqrt(2.0 / 9 / 20000 * (1 + rho) / (1 - rho));
  EXPECT_NEAR(table.modes[1].mcse / expected, 1, 0.2);
  EXPECT_NEAR(table.modes[1].mass, 1.0 / 3, 4 * expected);
  EXPECT_NEAR(double(table.crossings) / 19996, 2 * a * b / (a + b), 0.005);
  EXPECT_THAT(table.warnings, IsEmpty());
}

// Ten walkers that do the same say no more than one: two ensembles are worth 2 x 1000 independent
// draws, not 20000.
TEST(Modes, ErrorOfAMassHeedsEnsembles) {
  Draws draws = make_draws(1, 1000, 20, 9, [](int, int, RandomStream& random) {
    const double centre = random.uniform() < 1.0 / 3 ? -5 : 5;
    return Eigen::VectorXd(normal(1, random).array() + centre);
  });
  for (int chain = 0; chain < 20; ++chain) {
    draws.group[chain] = chain / 10;
    draws.x[chain] = draws.x[chain / 10 * 10];
  }
  const ModeTable table = tabulate_modes(draws);
  ASSERT_EQ(table.modes.size(), 2U);
  EXPECT_NEAR(table.modes[0].mcse / std::sqrt(2.0 / 9 / 2000), 1, 0.1);
}

// The gap is oblique: no coordinate shows it, nor does the direction of largest variance.
TEST(Modes, FindsAnObliqueGap) {
  Eigen::Vector3d across(1, -1, 1);
  across.normalize();
  const Draws draws = make_draws(3, 2000, 4, 3, [&](int, int, RandomStream& random) {
    const double side = random.uniform() < 0.3 ? -0.5 : 0.5;
    Eigen::VectorXd x = 20 * normal(3, random);
    x += across * (side + 0.1 * random.normal() - across.dot(x));
    return x;
  });
  const ModeTable table = tabulate_modes(draws);
  ASSERT_EQ(table.modes.size(), 2U);
  EXPECT_NEAR(table.modes[1].mass, 0.3, 4 * std::sqrt(0.21 / 8000));
}

TEST(Modes, FindsThreeInARow) {
  const Draws draws = make_draws(2, 2000, 4, 4, [](int, int, RandomStream& random) {
    Eigen::VectorXd x = normal(2, random);
    x[0] += 8 * random.index(3);
    return x;
  });
  EXPECT_EQ(tabulate_modes(draws).modes.size(), 3U);
}

TEST(Modes, OneModeStaysOne) {
  const auto gauss = [](int n) {
    return [n](int, int, RandomStream& random) { return normal(n, random); };
  };
  for (unsigned seed = 1; seed <= 5; ++seed) {
    EXPECT_EQ(tabulate_modes(make_draws(2, 500, 4, seed, gauss(2))).modes.size(), 1U) << seed;
    EXPECT_EQ(tabulate_modes(make_draws(30, 250, 4, seed, gauss(30))).modes.size(), 1U) << seed;
  }
  const auto banana = [](int, int, RandomStream& random) -> Eigen::VectorXd {
    const double x = 1 + std::sqrt(10.0) * random.normal();
    return Eigen::Vector2d(x, x * x + std::sqrt(0.1) * random.normal());
  };
  EXPECT_EQ(tabulate_modes(make_draws(2, 2000, 4, 1, banana)).modes.size(), 1U);
  const auto funnel = [](int, int, RandomStream& random) {
    Eigen::VectorXd x = normal(5, random);
    x[0] *= 3;
    x.tail(4) *= std::exp(x[0] / 2);
    return x;
  };
  EXPECT_EQ(tabulate_modes(make_draws(5, 2000, 4, 1, funnel)).modes.size(), 1U);
}

// A slow chain wanders; its clusters of draws are no modes.
TEST(Modes, SlowChainsAreNoModes) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Eigen::VectorXd x;
    const auto walk = [&](int, int draw, RandomStream& random) {
      if (draw == 0) x = normal(3, random);
      x = 0.98 * x + std::sqrt(1 - 0.98 * 0.98) * normal(3, random);
      return x;
    };
    EXPECT_EQ(tabulate_modes(make_draws(3, 2000, 4, seed, walk)).modes.size(), 1U) << seed;
  }
}

TEST(Modes, StuckChainsAreNotTrusted) {
  const Draws draws = make_draws(2, 500, 4, 5, [](int chain, int, RandomStream& random) {
    return Eigen::VectorXd(normal(2, random).array() + (chain == 0 ? 10 : 0));
  });
  const ModeTable table = tabulate_modes(draws);
  ASSERT_EQ(table.modes.size(), 2U);
  EXPECT_EQ(table.crossings, 0);
  EXPECT_EQ(table.modes[1].mass, 0.25);
  EXPECT_TRUE(matrix_near(table.modes[1].visits, Eigen::Vector4d(1, 0, 0, 0), 0));
  EXPECT_THAT(table.warnings,
              ElementsAre("no chain crosses between modes: their masses only repeat "
                          "where the chains began"));
}

TEST(Modes, FewCrossingsAreNotTrusted) {
  const Draws draws = make_draws(1, 500, 4, 6, [](int, int draw, RandomStream& random) {
    return Eigen::VectorXd(normal(1, random).array() + (draw < 200 ? 10 : 0));
  });
  const ModeTable table = tabulate_modes(draws);
  EXPECT_EQ(table.crossings, 4);
  ASSERT_EQ(table.warnings.size(), 2U);
  EXPECT_EQ(table.warnings[1],
            "chains cross into or out of mode 2 only 4 times, fewer than 10: its mass of 0.4 is "
            "not to be trusted");
}

TEST(Modes, KnownOnesAreKeptByNumber) {
  const Eigen::MatrixXd I = Eigen::Matrix2d::Identity();
  const std::vector<KnownMode> known = {
      {Eigen::Vector2d(-5, -5), I}, {Eigen::Vector2d(0, 30), I}, {Eigen::Vector2d(5, 5), I}};
  const ModeTable table = tabulate_modes(two_modes(2), known);
  ASSERT_EQ(table.modes.size(), 3U);
  EXPECT_EQ(table.modes[0].known, 2);
  EXPECT_EQ(table.modes[1].known, 0);
  EXPECT_EQ(table.modes[2].known, 1);
  EXPECT_EQ(table.modes[2].mass, 0);
  EXPECT_THAT(table.warnings, ElementsAre("mode 3, known beforehand, holds no draw"));
}

// All chains are in the one mode that they should be in: nothing is to be crossed.
TEST(Modes, AKnownOneWithoutDrawsIsNotCrossedInto) {
  const Eigen::MatrixXd I = Eigen::Matrix2d::Identity();
  std::vector<KnownMode> known = {{Eigen::Vector2d(0, 0), I}, {Eigen::Vector2d(0, 30), I}};
  const Draws draws =
      make_draws(2, 500, 4, 7, [](int, int, RandomStream& random) { return normal(2, random); });
  EXPECT_THAT(tabulate_modes(draws, known).warnings,
              ElementsAre("mode 2, known beforehand, holds no draw"));
  known[1].mass = 1e-3;  // 2 of 2000 draws
  EXPECT_THAT(tabulate_modes(draws, known).warnings,
              ElementsAre("mode 2, known beforehand, holds no draw"));
  known[1].mass = 1e-7;
  EXPECT_THAT(tabulate_modes(draws, known).warnings, IsEmpty());
}

// Two modes that chains never leave, and one that none began in.
TEST(Modes, StuckChainsAreToldBesideAnEmptyMode) {
  const Eigen::MatrixXd I = Eigen::MatrixXd::Identity(1, 1);
  const auto at = [](double x) { return Eigen::VectorXd::Constant(1, x); };
  const Draws draws = make_draws(1, 500, 4, 7, [](int chain, int, RandomStream& random) {
    return Eigen::VectorXd(normal(1, random).array() + (chain == 0 ? 10 : 0));
  });
  EXPECT_THAT(tabulate_modes(draws, {{at(0), I}, {at(10), I}, {at(30), I}}).warnings,
              ElementsAre("no chain crosses between modes: their masses only repeat where the "
                          "chains began",
                          "mode 3, known beforehand, holds no draw"));
}

TEST(Modes, KnownOnesThatMissAClumpSaySo) {
  const ModeTable table =
      tabulate_modes(two_modes(2), {{Eigen::Vector2d(5, 5), Eigen::MatrixXd::Identity(2, 2)}});
  EXPECT_THAT(table.warnings,
              ElementsAre("the draws fall into 2 clumps, more than the 1 known modes "
                          "that they visit"));
}

TEST(Modes, RefusesBrokenDrawsAndCovariances) {
  Draws draws = two_modes(2, 100);
  EXPECT_THROW((void)tabulate_modes(draws, {{Eigen::Vector2d(5, 5), -Eigen::Matrix2d::Identity()}}),
               InputError);
  draws.x[0](0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)tabulate_modes(draws), InputError);
}

}  // namespace
}  // namespace thenar
