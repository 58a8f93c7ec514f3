// Tests for posterior/hand_posterior.cpp: what may go wrong with models and data.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "posterior/hand_posterior.h"
#include "tests/kinematics_fit/fit_samples.h"
#include "tests/matrix_near.h"

namespace thenar {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using sample::FitSetup;
using sample::middle_finger;

PosteriorOptions without_noise() {
  PosteriorOptions options;
  options.learn_noise = false;
  return options;
}

const std::string kAxis = R"([[parameter]]
match = "axis/PIP3/direction/*"
state = "free"
sd_deg = 5
between_sd_deg = 0
)";

/// A finger about to be straight, pinned: its forces break down where the tip's load is felt by no
/// joint.
FitSetup nearly_straight() {
  FitSetup setup = middle_finger("[[parameter]]\nmatch='angle/*'\nstate='free'\nsd_deg=10\n");
  Experiment& experiment = setup.experiments.front();
  experiment.hold = TipConstraint::kPinned;
  experiment.postures.resize(1);
  experiment.trials.resize(3);
  for (Trial& trial : experiment.trials) trial.posture = experiment.postures[0].name;
  experiment.postures[0].angles = {{"PIP3", 0.1}, {"DIP3", 0.1}};
  return setup;
}

TEST(HandPosteriorStability, SingularPosturesAreNoThrow) {
  const HandPosterior posterior(nearly_straight().problem(), without_noise());
  // Through the straight finger and out on the other side, in steps of a hundredth of a degree.
  MatrixXd x = MatrixXd::Zero(posterior.size(), 2001);
  const std::vector<std::string> names = posterior.names();
  for (Eigen::Index p = 0; p < x.cols(); ++p)
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == "angle/PIP3" || names[i] == "angle/DIP3")
        x(static_cast<Eigen::Index>(i), p) = 1e-3 * static_cast<double>(p - 1500);
  const Densities at = posterior.evaluate(x, WithGradient::kYes);
  double worst = 0;
  for (Eigen::Index p = 0; p < x.cols(); ++p) {
    EXPECT_FALSE(at.log_likelihood[p] == std::numeric_limits<double>::infinity());
    if (!std::isnan(at.log_likelihood[p])) worst = std::min(worst, at.log_likelihood[p]);
  }
  EXPECT_LT(worst, -1e6) << "the line does not come near a singular posture";
  EXPECT_TRUE(std::isfinite(at.log_likelihood[1500]));
}

TEST(HandPosteriorStability, NoNumberIsABrokenPointAndNoNeighbours) {
  const HandPosterior posterior(middle_finger(kAxis).problem());
  MatrixXd x = MatrixXd::Constant(posterior.size(), 5, 0.3);
  x(0, 1) = std::nan("");
  x(1, 2) = std::numeric_limits<double>::infinity();
  x(posterior.size() - 1, 3) = 1e6;  // a noise factor beyond all numbers
  const Densities at = posterior.evaluate(x, WithGradient::kYes);
  EXPECT_TRUE(std::isnan(at.log_likelihood[1]));
  EXPECT_FALSE(at.log_prior[2] > -std::numeric_limits<double>::max());
  EXPECT_FALSE(std::isfinite(at.log_likelihood[3]));
  const Densities alone = posterior.evaluate(x.col(0), WithGradient::kYes);
  for (const Eigen::Index p : {0, 4}) {
    EXPECT_EQ(at.log_likelihood[p], alone.log_likelihood[0]);
    EXPECT_TRUE(matrix_near(at.likelihood_gradient.col(p), alone.likelihood_gradient, 0));
  }
}

// What no datum knows of keeps its prior, to the last bit.
TEST(HandPosteriorStability, DirectionsThatDataDoNotKnowAreFlat) {
  FitSetup setup = middle_finger(kAxis + "[[parameter]]\nmatch='gain/FDS'\nstate='free'\nsd=0.1\n");
  std::vector<Trial>& trials = setup.experiments[0].trials;
  trials.erase(std::remove_if(trials.begin(), trials.end(),
                              [](const Trial& trial) { return trial.tension.count("FDS") > 0; }),
               trials.end());
  const HandPosterior posterior(setup.problem(), without_noise());
  ASSERT_EQ(posterior.names()[2], "gain/FDS");
  const Densities at = posterior.evaluate(Eigen::Vector3d(0.4, -0.2, 1.1), WithGradient::kYes);
  EXPECT_EQ(at.likelihood_gradient(2, 0), 0);
  EXPECT_EQ(at.prior_gradient(2, 0), -1.1);
}

// The error of an angle in all postures, and in the only one: only their sum counts.
TEST(HandPosteriorStability, DoubledParametersShareWhatIsKnown) {
  FitSetup setup = middle_finger(
      "[[parameter]]\nmatch='angle/PIP3*'\nstate='free'\nsd_deg=5\nbetween_sd_deg=0\n"
      "range_deg=80\n");
  Experiment& experiment = setup.experiments[0];
  experiment.postures.resize(1);
  experiment.trials.resize(6);
  const TendonDigit digit = setup.digit;
  setup.parameters = choose_parameters(
      digit, sample::postures_of(experiment),
      sample::settings("[[parameter]]\nmatch='angle/PIP3*'\nstate='free'\nsd_deg=5\n"
                       "between_sd_deg=0\nrange_deg=80\n"));
  const HandPosterior posterior(setup.problem(), without_noise());
  ASSERT_EQ(posterior.size(), 2);
  const Densities a = posterior.evaluate(Eigen::Vector2d(0.9, -0.2), WithGradient::kYes);
  const Densities b = posterior.evaluate(Eigen::Vector2d(0.1, 0.6), WithGradient::kYes);
  EXPECT_NEAR(a.log_likelihood[0], b.log_likelihood[0], 1e-9);
  EXPECT_NEAR(a.likelihood_gradient(0, 0), a.likelihood_gradient(1, 0), 1e-9);
}

/// Mean and sd of both tilts, on a grid.
std::pair<Eigen::Vector2d, Eigen::Vector2d> moments(const HandPosterior& posterior) {
  constexpr int kCount = 161;
  MatrixXd x(2, kCount * kCount);
  for (int p = 0; p < kCount * kCount; ++p)
    x.col(p) = Eigen::Vector2i(p % kCount, p / kCount).cast<double>() * (8.0 / (kCount - 1)) -
               Eigen::Vector2d(4, 4);
  const Densities at = posterior.evaluate(x, WithGradient::kNo);
  VectorXd weight = at.log_prior + at.log_likelihood;
  weight = (weight.array() - weight.maxCoeff()).exp();
  weight /= weight.sum();
  const Eigen::Vector2d mean = x * weight;
  return {mean, ((x.colwise() - mean).cwiseAbs2() * weight).cwiseSqrt()};
}

TEST(HandPosteriorStability, OneGrossOutlierDoesNotCarryTheRobustPosteriorAway) {
  FitSetup clean = middle_finger(kAxis);
  std::mt19937 rng(4);
  clean.experiments[0].sd_floor = 0.1;
  sample::simulate(clean, VectorXd::Zero(2), 0.1, rng, clean.experiments[0]);
  FitSetup spoilt = clean;
  spoilt.experiments[0].trials[3].force += Eigen::Vector3d(5, -5, 50);  // [N]
  const auto shift = [&](double robust) {
    const auto good = moments(HandPosterior(clean.problem(robust), without_noise()));
    const auto bad = moments(HandPosterior(spoilt.problem(robust), without_noise()));
    return (bad.first - good.first).cwiseQuotient(good.second).cwiseAbs().maxCoeff();
  };
  EXPECT_GT(shift(0), 3);     // [posterior sds]
  EXPECT_LT(shift(3), 0.25);  // [posterior sds]
}

// Data push a gain far beyond its bound: the density stays finite and smooth in x.
TEST(HandPosteriorStability, BoundsAreNoEdges) {
  FitSetup setup =
      middle_finger("[[parameter]]\nmatch='gain/FDS'\nstate='free'\nsd=0.1\nrange=0.15\n");
  for (Trial& trial : setup.experiments[0].trials) trial.force *= 3;
  const FitProblem problem = setup.problem();
  const HandPosterior posterior(problem, without_noise());
  for (const double x : {-40.0, -10.0, 0.0, 5.0, 10.0, 40.0}) {
    const Densities at = posterior.evaluate(VectorXd::Constant(1, x), WithGradient::kYes);
    EXPECT_TRUE(std::isfinite(at.log_likelihood[0])) << x;
    EXPECT_TRUE(std::isfinite(at.likelihood_gradient(0, 0))) << x;
    const double value = posterior.values(VectorXd::Constant(1, x)).population(0, 0);
    EXPECT_TRUE(0.85 <= value && value <= 1.15) << x;
  }
  const VectorXd on_bound = posterior.from_fit_coordinates(problem.coordinates().upper());
  EXPECT_TRUE(on_bound.allFinite());
  EXPECT_NEAR(posterior.fit_coordinates(on_bound)[0], problem.coordinates().upper()[0] - 1e-3,
              1e-9);
}

TEST(HandPosteriorStability, ParametersThatBoundsHoldAreNotSampled) {
  FitSetup setup = middle_finger(kAxis +
                                 "[[parameter]]\nmatch='gain/FDS'\nstate='free'\n"
                                 "mean=1.1\nlower=1.1\nupper=1.1\n");
  const HandPosterior posterior(setup.problem(), without_noise());
  EXPECT_EQ(posterior.size(), 2);
}

TEST(HandPosteriorStability, ActivationOfAMuscleOfUnknownStrengthIsRefused) {
  FitSetup setup = middle_finger(kAxis);
  ActivationRow row;
  row.posture = setup.experiments[0].postures[0].name;
  row.activation = {{"FDS", 0.3}};
  row.sd = {{"FDS", 0.1}};
  setup.experiments[0].activations = {row};
  setup.digit.max_tension.setConstant(std::numeric_limits<double>::infinity());
  try {
    (void)HandPosterior(setup.problem());
    FAIL() << "expected InputError";
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "experiment 'synek2019_H01' states the activation of 'FDS', whose max_force the "
                 "subject does not say");
  }
}

}  // namespace
}  // namespace thenar
