// Tests for kinematics_fit/misfit.cpp: a fit that misses the forces is told from chance.

#include "kinematics_fit/misfit.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "base/units.h"
#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::FitSetup;
using sample::kAxes;
using sample::kAxesAndPaths;
using sample::middle_finger;

// Two degrees of freedom have the tail exp(-x / 2): 1e-4 at x = 18.42.
TEST(Misfit, IsBeyondChanceWhereTheTailOfChiSquareIs) {
  const Misfit far = compute_misfit(18.5, 4, 2), near = compute_misfit(18.3, 4, 2);
  EXPECT_NEAR(far.tail, std::exp(-9.25), 1e-15);
  EXPECT_NEAR(far.times_noise, std::sqrt(9.25), 1e-12);
  EXPECT_TRUE(far.beyond_chance);
  EXPECT_FALSE(near.beyond_chance);
  EXPECT_EQ(describe(near), "");
  EXPECT_NE(describe(far).find("by 3.0 times the stated noise (chi-square 18.5, 2.0 degrees"),
            std::string::npos)
      << describe(far);
}

// 1000 numbers tell noise of 1.1 from 1.0 (sd 0.02), and nobody minds: exp(0.5) = 1.6487 is the
// limit, 2718.3 its square times 1000.
TEST(Misfit, ForgivesNoiseThatWasStatedSomewhatTooSmall) {
  EXPECT_LT(compute_misfit(1210, 1000, 0).tail, 1e-4);
  EXPECT_FALSE(compute_misfit(1210, 1000, 0).beyond_chance);
  EXPECT_FALSE(compute_misfit(2718, 1000, 0).beyond_chance);
  EXPECT_TRUE(compute_misfit(2719, 1000, 0).beyond_chance);
}

TEST(Misfit, SaysNothingWithoutDegreesOfFreedom) {
  EXPECT_FALSE(compute_misfit(100, 4, 4).beyond_chance);
  EXPECT_EQ(compute_misfit(100, 4, 4).times_noise, 0);
}

TEST(Misfit, SharesEffectiveParametersAmongExperiments) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  setup.experiments.push_back(sample::experiment("H02"));
  setup.experiments.push_back(sample::experiment("B01"));
  const FitProblem problem = setup.problem();
  const VectorXd z = VectorXd::Constant(problem.size(), 0.1);
  const Covariance covariance = posterior_covariance(problem, z);
  double shared = 0;
  for (const Misfit& each : misfits(problem, z, covariance)) {
    EXPECT_EQ(each.numbers, 72);
    shared += each.numbers - each.degrees_of_freedom;
  }
  EXPECT_NEAR(shared, covariance.effective_parameters, 1e-8);
}

// Next to a posture in which the tip is singular slopes are 1e15 and more: nearer still, no number
// is determined that was not before.
TEST(Misfit, CountsDegreesOfFreedomWhereSlopesAreSteep) {
  FitSetup setup =
      middle_finger("[[parameter]]\nmatch='angle/*/*'\nstate='free'\nsd_deg=4\n" + kAxes);
  Experiment& experiment = setup.experiments.front();
  experiment.hold = TipConstraint::kPinned;
  const auto freedom = [&](double degrees) {
    for (PostureRecord& posture : experiment.postures)
      posture.angles = {{"PIP3", radians(degrees)}, {"DIP3", radians(degrees)}};
    const FitProblem problem = setup.problem();
    const VectorXd z = VectorXd::Zero(problem.size());
    return misfits(problem, z, posterior_covariance(problem, z)).front().degrees_of_freedom;
  };
  EXPECT_NEAR(freedom(1e-7), freedom(1e-5), 1e-5);
}

// Truth from the prior, noise as stated: sums of chi-squares come to the sum of degrees of freedom.
TEST(Misfit, ExpectsAsMuchAsItsDegreesOfFreedom) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().sd_floor = 0.02;  // [N]; small, so that the model is nearly linear
  std::mt19937 rng(12);
  double chi_square = 0, freedom = 0;
  for (int draw = 0; draw < 30; ++draw) {
    const VectorXd sd = sample::person_sds(setup.parameters);
    const VectorXd u = sd.cwiseProduct(sample::normal(sd.size(), rng));
    sample::simulate(setup, u, 0.02, rng, setup.experiments.front());
    const FitProblem problem = setup.problem();
    const Solution found = sample::fit_precisely(problem);
    const Misfit each = misfits(problem, found.z, posterior_covariance(problem, found.z)).front();
    EXPECT_FALSE(each.beyond_chance);
    chi_square += each.chi_square;
    freedom += each.degrees_of_freedom;
  }
  EXPECT_NEAR(chi_square / freedom, 1, 4 * std::sqrt(2 / freedom));  // four sds of a chi-square
}

// Bad trials weigh less in a robust fit, but are missed by no less.
TEST(Misfit, IsThatOfTheForcesWithoutRobustLoss) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  for (Trial& trial : setup.experiments.front().trials) trial.force = -trial.force;
  const FitProblem plain = setup.problem(), robust = setup.problem(3);
  const VectorXd z = VectorXd::Zero(plain.size());
  const double by_hand = data_residuals(plain, z, 0, WithJacobian::kNo).r.squaredNorm();
  const Misfit found = misfits(robust, z, posterior_covariance(robust, z)).front();
  EXPECT_NEAR(found.chi_square / by_hand, 1, 1e-9);
  EXPECT_LT(data_residuals(robust, z, 0, WithJacobian::kNo).r.squaredNorm(), 0.5 * by_hand);
}

// Published forces with the signs of a cell that shows its own force on the tip.
TEST(Misfit, TellsForcesOfTheWrongSign) {
  FitSetup setup = middle_finger(kAxesAndPaths);
  const auto of = [](const FitProblem& problem) {
    const Solution found = solve(least_squares(problem), VectorXd::Zero(problem.size()));
    return misfits(problem, found.z, posterior_covariance(problem, found.z)).front();
  };
  EXPECT_FALSE(of(setup.problem()).beyond_chance);
  for (Trial& trial : setup.experiments.front().trials) trial.force = -trial.force;
  EXPECT_TRUE(of(setup.problem()).beyond_chance);
}

}  // namespace
}  // namespace thenar
