// Fits where the data or the model are at the edge: each ends with a finite result or says why not.

#include <gtest/gtest.h>

#include "base/error.h"
#include "kinematics_fit/fit_residuals.h"
#include "tests/kinematics_fit/fit_samples.h"

namespace thenar {
namespace {

using Eigen::VectorXd;
using sample::FitSetup;
using sample::middle_finger;

const std::string kAxes = R"(
[[parameter]]
match = "axis/*/direction/*"
state = "free"
)";

Solution fit(const FitProblem& problem) {
  return solve(least_squares(problem), VectorXd::Zero(problem.size()));
}

void expect_sound(const FitProblem& problem, const Solution& found) {
  EXPECT_EQ(found.status, Status::kSolved) << found.message;
  EXPECT_TRUE(found.z.allFinite());
  EXPECT_TRUE(predict_trials(problem, found.z, 0).allFinite());
  EXPECT_TRUE(posterior_covariance(problem, found.z).C.diagonal().allFinite());
}

/// The first posture of H01 with both interphalangeal joints bent by `angle` [rad].
FitSetup nearly_straight(double angle) {
  FitSetup setup = middle_finger(kAxes);
  setup.digit.calibrated_on.clear();
  setup.experiments.front().postures[0].angles = {{"PIP3", angle}, {"DIP3", angle}};
  return setup;
}

// -- Singular postures ------------------------------------------------------------------------

TEST(FitStability, StraightFingerIsRefusedByName) {
  for (const TipConstraint hold : {TipConstraint::kRigid, TipConstraint::kPinned}) {
    FitSetup setup = nearly_straight(0);
    setup.experiments.front().hold = hold;
    try {
      (void)setup.problem();
      FAIL() << "expected InputError";
    } catch (const InputError& e) {
      EXPECT_STREQ(e.what(),
                   "posture 'MinorFlex' of experiment 'synek2019_H01' is singular: the held tip "
                   "carries loads that no joint feels; leave it out");
    }
  }
}

TEST(FitStability, NearlyStraightFingerIsWarnedOf) {
  const FitProblem problem = nearly_straight(1e-6).problem();
  ASSERT_EQ(problem.warnings().size(), 2U);  // and its points cannot move
  EXPECT_EQ(problem.warnings()[0].find("experiment 'synek2019_H01': posture 'MinorFlex' is nearly "
                                       "singular (condition "),
            0U)
      << problem.warnings()[0];
  // A microradian from straight one newton is a million sds away: Ceres ends where its step falls
  // below the rounding of z, far from what the slopes ask for, and is not believed.
  const Solution found = fit(problem);
  EXPECT_EQ(found.status, Status::kStalled) << found.message;
  EXPECT_GT(found.newton_step, 1);
  EXPECT_TRUE(found.z.allFinite());
  // Forces are those of the same formulas in extended precision, to the digits that are there.
  const VectorXd u = VectorXd::Zero(problem.parameters().coordinates());
  const auto exact =
      predict_forces(specimen_model(problem.digit(), problem.parameters(),
                                    parameter_values<long double>(problem.parameters(), u)),
                     problem.plans()[0]);
  const Eigen::Matrix3Xd force =
      force_values(problem.digit(), problem.parameters(), problem.plans()[0], u);
  const auto error = (force.cast<long double>() - exact).norm() / exact.norm();
  EXPECT_LT(static_cast<double>(error), 1e-9);  // 16 digits less 6 of the bend, and one for luck
}

TEST(FitStability, MeasuredPosturesAreSound) {
  FitSetup setup = middle_finger(sample::kAxesAndPaths);
  setup.digit.calibrated_on.clear();
  const FitProblem problem = setup.problem();
  EXPECT_TRUE(problem.warnings().empty());
  for (const double condition : problem.plans()[0].condition) EXPECT_LT(condition, 100);
}

// -- Parameters -------------------------------------------------------------------------------

// Three flexion axes are parallel in the subject: tilts and shifts together are still well posed.
TEST(FitStability, ParallelAxesAreNoTrouble) {
  const FitProblem problem =
      middle_finger("[[parameter]]\nmatch='axis/*'\nstate='free'\n").problem();
  expect_sound(problem, fit(problem));
}

TEST(FitStability, TiedParametersAreOneCoordinate) {
  const FitProblem tied = middle_finger(R"(
[[parameter]]
match = "gain/*"
state = "tied"
tie_to = "gain/FDP"
[[parameter]]
match = "gain/FDP"
state = "free"
)")
                              .problem();
  EXPECT_EQ(tied.size(), 1);
  expect_sound(tied, fit(tied));
}

// A gain of all tendons and the friction's mean effect are nearly the same thing.
TEST(FitStability, NearlyDuplicateParametersShareTheirEffect) {
  const FitProblem problem = middle_finger(R"(
[[parameter]]
match = "gain/*"
state = "free"
[[parameter]]
match = "friction/*"
state = "free"
[[parameter]]
match = "length/*"
state = "free"
[[parameter]]
match = "tip/*"
state = "free"
)")
                                 .problem();
  expect_sound(problem, fit(problem));
}

TEST(FitStability, NearlyFlatPriorLeavesTheDataAlone) {
  const FitProblem problem = middle_finger(R"(
[[parameter]]
match = "gain/FD?"
state = "free"
sd = 1e6
between_sd = 0
)")
                                 .problem();
  SolveOptions precise;
  precise.tolerance = 1e-14;
  const Solution found = solve(least_squares(problem), VectorXd::Zero(problem.size()), precise);
  expect_sound(problem, found);
  const VectorXd gradient = [&] {
    const Residuals at = fit_residuals(problem, found.z, WithJacobian::kYes);
    const int rows = data_rows(problem);
    return VectorXd(at.J.topRows(rows).transpose() * at.r.head(rows));
  }();
  EXPECT_LT(gradient.norm() / 1e6, 1e-3);  // of the data alone, by gain
}

TEST(FitStability, EveryParameterFreeIsHeldByItsPrior) {
  const FitProblem problem = middle_finger(
                                 "[[parameter]]\nmatch='*'\nstate='free'\n"
                                 "[[parameter]]\nmatch='hold/*'\nmean_mm=39\n")
                                 .problem();
  const Solution found = fit(problem);
  expect_sound(problem, found);
  EXPECT_FALSE(posterior_covariance(problem, found.z).null_directions.empty());
}

// -- Starts and data --------------------------------------------------------------------------

TEST(FitStability, StartOutsideTheBoundsIsBroughtIn) {
  const FitProblem problem = middle_finger(kAxes).problem();
  const Solution found = solve(least_squares(problem), VectorXd::Constant(problem.size(), 1e3));
  EXPECT_TRUE(found.z.allFinite());
  EXPECT_TRUE((found.z.array() <= problem.coordinates().upper().array() + 1e-9).all());
}

TEST(FitStability, OneTrialIsEnoughForAPrior) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().trials.resize(1);
  const FitProblem problem = setup.problem();
  const Solution found = fit(problem);
  expect_sound(problem, found);
  EXPECT_LE(posterior_covariance(problem, found.z).effective_parameters, 3);  // three numbers
}

TEST(FitStability, UnloadedTendonsPredictNoForce) {
  FitSetup setup = middle_finger(kAxes);
  for (Trial& trial : setup.experiments.front().trials) trial.tension.clear();
  const FitProblem problem = setup.problem();
  const Solution found = fit(problem);
  EXPECT_LT(found.z.norm(), 1e-12);
  EXPECT_LT(predict_trials(problem, found.z, 0).norm(), 1e-12);
}

TEST(FitStability, HugeForcesDoNotBreakTheRobustFit) {
  FitSetup setup = middle_finger(kAxes);
  setup.experiments.front().trials[0].force = {1e9, -1e9, 1e9};
  const FitProblem problem = setup.problem(2.0);
  const Solution found = fit(problem);
  EXPECT_TRUE(found.z.allFinite());
  EXPECT_LT(found.z.cwiseAbs().maxCoeff(), 10);
}

}  // namespace
}  // namespace thenar
