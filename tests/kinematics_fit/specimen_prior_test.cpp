// Tests for kinematics_fit/specimen_prior.cpp: how specimens differ from their population.

#include "kinematics_fit/specimen_prior.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::between_sds;
using sample::FitSetup;
using sample::kAxes;
using sample::kFriction;
using sample::middle_finger;
using sample::population_sds;

// Where data say nothing (C = 1), an unseen person varies by sd^2 + between^2 again.
TEST(SpecimenPrior, UnseenVarianceAddsUpToThePrior) {
  const FitSetup setup = middle_finger(kAxes);
  const FitProblem problem = setup.problem();
  const Eigen::MatrixXd J =
      displacement_jacobian(problem.coordinates(), VectorXd::Zero(problem.size()), -1);
  const VectorXd variance = (J * J.transpose()).diagonal() + unseen_variance(problem.coordinates());
  EXPECT_TRUE(matrix_near(
      variance,
      population_sds(setup.parameters).cwiseAbs2() + between_sds(setup.parameters).cwiseAbs2(),
      1e-15));
}

// The sum of population and deviation is bounded, which no box about either could do.
TEST(SpecimenPrior, BoundsHoldForSpecimensOfAPopulation) {
  FitSetup setup = middle_finger(kFriction);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  ASSERT_EQ(problem.size(), 3);
  for (const double population :
       {problem.coordinates().lower()[0], -1.0, 0.0, 2.0, problem.coordinates().upper()[0]})
    for (const double own : {-20.0, -3.0, 0.0, 3.0, 20.0}) {
      const double friction =
          0.1 + displacements(problem.coordinates(), Eigen::Vector3d(population, own, 0), 0)[0];
      EXPECT_GE(friction, -1e-15) << population << " " << own;
      EXPECT_LE(friction, 0.5 + 1e-15) << population << " " << own;
    }
}

// A standard normal entry is the normal deviation cut off at the bounds: with the population at
// 0.1 and bounds 1.25 sds below and 5 above, the median of the deviation is that of the rest.
TEST(SpecimenPrior, DeviationsKeepTheirPriorWithinBounds) {
  FitSetup setup = middle_finger(kFriction);
  setup.experiments.push_back(sample::experiment("H02"));
  const FitProblem problem = setup.problem();
  const auto below = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  const double u = displacements(problem.coordinates(), Eigen::Vector3d::Zero(), 0)[0] / 0.08;
  EXPECT_NEAR((below(u) - below(-1.25)) / (below(5) - below(-1.25)), 0.5, 1e-14);
}

/// A population at 1 sd of its prior, and specimens within -1 .. 2 of the prior mean.
CoordinateEntries bounded_entries() {
  CoordinateEntries of;
  of.population = 0;
  of.population_sd = 0.5;
  of.deviation = 1;
  of.deviation_sd = 0.8;
  of.lower = -1;
  of.upper = 2;
  return of;
}

TEST(SpecimenPrior, EntriesAreFoundFromDeviations) {
  const CoordinateEntries of = bounded_entries();
  for (const double factor : {0.02, 1.0, 3.0})  // far bounds, near ones, hardly any room
    for (const double x : {-2.0, -0.3, 0.0, 1.5}) {
      const double u = specimen_deviation(of, 0.5, x, factor).u;
      EXPECT_NEAR(deviation_entry(of, 0.5, u, factor), x, 1e-9) << factor;
    }
}

TEST(SpecimenPrior, DerivativesOfDeviationsAreThoseOfDifferences) {
  const CoordinateEntries of = bounded_entries();
  constexpr double kStep = 1e-6;
  const auto slope = [&](double population, double x, double log_factor) {
    const auto u = [&](double sign) {
      return specimen_deviation(of, 0.5 + sign * kStep * population, 0.7 + sign * kStep * x,
                                std::exp(0.3 + sign * kStep * log_factor))
          .u;
    };
    return (u(1) - u(-1)) / (2 * kStep);
  };
  const SpecimenDeviation at = specimen_deviation(of, 0.5, 0.7, std::exp(0.3));
  EXPECT_NEAR(at.by_population, slope(1, 0, 0), 1e-8);
  EXPECT_NEAR(at.by_x, slope(0, 1, 0), 1e-8);
  EXPECT_NEAR(at.by_log_factor, slope(0, 0, 1), 1e-8);
}

}  // namespace
}  // namespace thenar
